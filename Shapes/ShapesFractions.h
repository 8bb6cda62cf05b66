/**
 * ShapesFractions: volume fractions of shapes in the cells of a grid.
 *
 * A point belongs to the first shape that contains it. Cells that are cut only by planes are exact.
 * Other cells are halved until each curved surface is close to a plane of equal volume in every
 * part. The tolerance is a limit of the estimated absolute error of a fraction in a cell.
 *
 * The fractions of a cell depend only on the cell. They are bitwise identical for any box of cells
 * and any number of threads.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Shapes/Shapes.h"

namespace vfm
{

constexpr double DefaultShapeTolerance = 1e-4;

/// Computes the fractions in one box.
/// @param lower,upper  corners of the box
/// @param tolerance  absolute error of a fraction, between 0 and 1
/// @return parts in the order of materials, without void and without parts below 1e-12
/// @throws InputError  unless 0 < tolerance < 1
std::vector<FractionField::Part> ComputeShapeParts(const std::vector<Shape>& shapes,
  const Vector3& lower, const Vector3& upper, double tolerance = DefaultShapeTolerance);

/// Computes the fractions in one box as an array.
/// @param[out] fractions  fractions[material - 1], of length CountMaterials(shapes)
/// @throws InputError  unless 0 < tolerance < 1
void ShapeFractions(const std::vector<Shape>& shapes, const Vector3& lower, const Vector3& upper,
  double tolerance, double* fractions);

/// Function that receives a box of cells with equal parts. Boxes are disjoint. Several threads may
/// call it at once.
using ShapePartsSink =
  std::function<void(const IndexBox& cells, const std::vector<FractionField::Part>& parts)>;

/// Computes the fractions in the cells of a box.
/// @param coordinates  node coordinates of the grid, one list per axis
/// @param box  cells to compute
/// @param runtime  receives the progress, 0 to 1
/// @param sink  called for all cells except void cells
/// @throws InputError  unless 0 < tolerance < 1
/// @throws Aborted  if the user stops the run
void ComputeShapeFractions(const std::array<std::vector<double>, 3>& coordinates,
  const IndexBox& box, const std::vector<Shape>& shapes, double tolerance, Runtime& runtime,
  const ShapePartsSink& sink);

/// Computes the fractions in the cells of a box (ComputeShapeFractions).
/// @return one array per material over the cells of the box, x fastest
std::vector<Buffer<double>> FractionArraysOfShapes(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& box,
  const std::vector<Shape>& shapes, double tolerance, Runtime& runtime);

/// Computes the fractions in the local box of a grid.
/// @param materials  number of materials; 0 for CountMaterials(shapes)
FractionField FractionsOfShapes(const CartesianGrid& grid, const std::vector<Shape>& shapes,
  int materials = 0, double tolerance = DefaultShapeTolerance);
FractionField FractionsOfShapes(const CartesianGrid& grid, const std::vector<Shape>& shapes,
  int materials, double tolerance, Runtime& runtime);

} // namespace vfm
