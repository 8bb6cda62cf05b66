/**
 * ShapeFractions: exact volume fractions of shapes and closed surfaces as numpy arrays.
 */
#pragma once

#include "NumpyArrays.h"
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

/// Returns the fractions of level sets: one array per level set with one value per cell, x fastest.
/// @param arrays  names and values of the level sets at the centres of the cells, shape (cells,)
/// @param rule,inside  words of the options LevelSets and LevelSetInside
/// @throws InputError if no value is inside; exceptions of PythonRuntime::Run
nanobind::list FractionsOfArrays(const std::vector<std::pair<std::string, NumpyArray>>& arrays,
  const NodeCoordinates& coordinates, const std::string& rule, const std::string& inside,
  PythonRuntime& runtime);

} // namespace vfm
