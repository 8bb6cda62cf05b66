/**
 * ShapeFractions: exact volume fractions of shapes and closed surfaces as numpy arrays.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

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

struct NamedTriangles
{
  std::string Name;
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
};

/// Returns the fractions inside closed surfaces: one array per surface with one value per cell, x
/// fastest.
/// @throws InputError if a surface is not closed; its name is in the message if there are several.
///   Also if there are no cells; exceptions of PythonRuntime::Run
nanobind::list FractionsInside(
  std::vector<NamedTriangles> surfaces, const NodeCoordinates& coordinates, PythonRuntime& runtime);

} // namespace vfm
