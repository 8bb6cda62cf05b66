/**
 * ShapeFractions: exact volume fractions of shapes and closed surfaces as arrays of numpy.
 */
#pragma once

#include "Shapes/Shapes.h"

#include <nanobind/nanobind.h>

namespace vfm
{

class PythonRuntime;

using NodeCoordinates = std::array<std::vector<double>, 3>;

/// An array a material, a value a cell, x fastest. Throws ValueError without shapes or cells, and as PythonRuntime::Run does.
/// make: the shapes in a domain.
nanobind::list ComputeFractions(const NodeCoordinates& coordinates,
  const std::function<std::vector<Shape>(const Vector3& lower, const Vector3& upper)>& make,
  double tolerance, PythonRuntime& runtime);

} // namespace vfm
