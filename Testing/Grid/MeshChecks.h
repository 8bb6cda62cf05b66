/**
 * Independent checks of a hexahedral mesh: validity, conformity, manifold boundaries.
 */
#pragma once

#include "HexPipeline.h"

#include <functional>

namespace vfm
{
namespace testing
{

/// nx x ny x nz unit cells.
CartesianGrid MakeUnitGrid(Index nx, Index ny, Index nz);
inline CartesianGrid MakeUnitGrid(Index n)
{
  return MakeUnitGrid(n, n, n);
}

/// One label a cell, from label(i, j, k).
FractionField MakeLabels(
  const CartesianGrid& grid, int materials, const std::function<int(const Index3&)>& label);

/// Random labels lowest..materials.
FractionField MakeRandomLabels(const CartesianGrid& grid, int materials, int lowest, unsigned seed);

/// Smallest corner determinant over all hexes.
double SmallestCornerDeterminant(const HexMesh& mesh);

/// Whether the trilinear map of every hex has a positive Jacobian everywhere: its Bernstein coefficients
/// are positive, after subdivision where they are not (Johnen, Remacle, Geuzaine 2013).
bool IsPositiveEverywhere(const HexMesh& mesh);

/// "" or what is wrong: a face on more than two hexes, an unused point, the boundary of a material that is
/// no closed 2-manifold, ids that are not unique.
std::string FindTopologyProblem(const HexMesh& mesh);

/// Volume of a material, exact for trilinear hexes.
double MeasureVolume(const HexMesh& mesh, int material);

/// Distances of the points of all interface quads to the nearest of the given surfaces.
struct Distances
{
  double Largest = 0.0, RootMeanSquare = 0.0;
};
Distances MeasureDistances(
  const HexMesh& mesh, const std::function<double(const Vector3&)>& distance);

bool AreEqual(const HexMesh& a, const HexMesh& b);

} // namespace testing
} // namespace vfm
