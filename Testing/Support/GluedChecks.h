/**
 * Checks of periodic meshes: opposite sides are translates of each other, and the mesh glued along
 * them is valid.
 */
#pragma once

#include "MeshChecks.h"

namespace vfm
{
namespace testing
{

/// Returns the grid of one rank that owns all n cells of unit width, periodic along some axes.
/// @param layers  layers of copies
CartesianGrid MakePeriodicGrid(const Index3& n, const std::array<bool, 3>& isPeriodic,
  Seam seam = Seam::Flat, Index layers = GhostLayers);

/// Returns label(i, j, k) of each cell as fractions, with i, j, k from 0 in the domain; copies get
/// the labels of their cells.
FractionField MakePeriodicLabels(
  const CartesianGrid& grid, int materials, const std::function<int(const Index3&)>& label);

/// Returns random labels from lowest to materials; copies get the labels of their cells.
FractionField MakeRandomPeriodic(
  const CartesianGrid& grid, int materials, int lowest, unsigned seed);

/// Returns the fractions of labels at samples^3 points of each cell; copies get those of their
/// cells.
/// @param label  label(x) at a point, in lengths from the lower corner of the domain
FractionField SamplePeriodic(const CartesianGrid& grid, int materials, int samples,
  const std::function<int(const Vector3&)>& label);

/// Returns a polycrystal of Voronoi cells that repeats along all axes, in n^3 unit cells, by 4^3
/// samples per cell.
FractionField MakePeriodicPolycrystal(const CartesianGrid& grid, unsigned seed, int grains = 20);

/// Returns a mesh in which points that are translates of each other, bitwise, are one point.
/// @param mesh  mesh of the whole domain
Mesh Glue(const CartesianGrid& grid, const Mesh& mesh);

/// Returns an empty string or the first problem of the glued mesh: a face between cells of the
/// domain that is not on two elements, a boundary of a material that is not a closed manifold, a
/// fragment that is not connected or not counted.
/// @param meshVoid  whether all cells have elements
std::string FindGluedProblem(
  const CartesianGrid& grid, const Mesh& mesh, bool meshVoid, Index fragments);

} // namespace testing
} // namespace vfm
