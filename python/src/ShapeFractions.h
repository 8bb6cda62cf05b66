/**
 * ShapeFractions: exact volume fractions of shapes and closed surfaces as numpy arrays.
 */
#pragma once

#include "Shapes/Shapes.h"

#include <nanobind/nanobind.h>

namespace vfm
{

class PythonRuntime;

using NodeCoordinates = std::array<std::vector<double>, 3>;

/// Returns one array per material with one value per cell, x fastest.
/// @param make returns the shapes for a domain
/// @throws InputError if there are no shapes or cells; exceptions of PythonRuntime::Run
nanobind::list ComputeFractions(const NodeCoordinates& coordinates,
  const std::function<std::vector<Shape>(const Vector3& lower, const Vector3& upper)>& make,
  double tolerance, PythonRuntime& runtime);

} // namespace vfm
