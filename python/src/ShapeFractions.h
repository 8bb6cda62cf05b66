/**
 * ShapeFractions: exact volume fractions of shapes and closed surfaces as numpy arrays.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"

#include <nanobind/nanobind.h>

#include <string>

namespace vfm
{

class PythonRuntime;

using NodeCoordinates = std::array<std::vector<double>, 3>;

/// Returns the fractions of shapes that text describes: one array per material with one value per
/// cell, x fastest.
/// @throws InputError if there are no shapes or cells; exceptions of PythonRuntime::Run
nanobind::list FractionsOfText(const std::string& text, const NodeCoordinates& coordinates,
  double tolerance, PythonRuntime& runtime);

/// Returns the fractions inside bodies: one array per body with one value per cell, x fastest.
/// @throws InputError if there are no cells; exceptions of PythonRuntime::Run
nanobind::list FractionsInside(
  const InputSurfaces& surfaces, const NodeCoordinates& coordinates, PythonRuntime& runtime);

} // namespace vfm
