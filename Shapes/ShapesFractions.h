/**
 * Volume fractions of shapes in the cells of a grid.
 *
 * The first shape that contains a point owns it, so a shape gets what the ones before it left over.
 * Cells cut by planes only are exact. Elsewhere a cell is halved until each curved surface is, in
 * every part, near enough to the plane of equal volume; what "near enough" leaves is estimated to
 * stay below the tolerance, an absolute error of the fraction in a cell.
 *
 * The fractions of a cell depend on that cell alone: they are the same, bit for bit, whatever box
 * of cells is asked for and however many threads work.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Shapes/Shapes.h"

namespace vfm
{

constexpr double DefaultShapeTolerance = 1e-4;

/// Parts in one box from lower to upper, in the order of their materials, without void and without
/// parts below 1e-12. Throws InputError unless 0 < tolerance < 1.
std::vector<FractionField::Part> ComputeShapeParts(const std::vector<Shape>& shapes,
  const Vector3& lower, const Vector3& upper, double tolerance = DefaultShapeTolerance);

/// As above into an array: fractions[material - 1], CountMaterials(shapes) long.
void ShapeFractions(const std::vector<Shape>& shapes, const Vector3& lower, const Vector3& upper,
  double tolerance, double* fractions);

/// Called with a box of cells that all have the parts given; boxes are disjoint, several threads
/// may call at once.
using ShapePartsSink =
  std::function<void(const IndexBox& cells, const std::vector<FractionField::Part>& parts)>;

/// Fractions in the cells of a box of a grid whose node coordinates are given, one list an axis.
/// Void cells are not told. Tells its progress, 0 to 1, and stops when that throws Aborted. Throws InputError unless 0 < tolerance < 1.
void ComputeShapeFractions(const std::array<std::vector<double>, 3>& coordinates,
  const IndexBox& box, const std::vector<Shape>& shapes, double tolerance, Runtime& runtime,
  const ShapePartsSink& sink);

/// The same as an array per material of the cells of the box, x fastest.
std::vector<Buffer<double>> FractionArraysOfShapes(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& box,
  const std::vector<Shape>& shapes, double tolerance, Runtime& runtime);

/// The fractions in the local box of a grid. materials: 0 for CountMaterials(shapes).
FractionField FractionsOfShapes(const CartesianGrid& grid, const std::vector<Shape>& shapes,
  int materials = 0, double tolerance = DefaultShapeTolerance);
FractionField FractionsOfShapes(const CartesianGrid& grid, const std::vector<Shape>& shapes,
  int materials, double tolerance, Runtime& runtime);

} // namespace vfm
