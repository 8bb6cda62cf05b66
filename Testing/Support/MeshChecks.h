/**
 * Independent checks of a hexahedral or tetrahedral mesh: validity, conformity, manifold
 * boundaries.
 */
#pragma once

#include "HexPipeline.h"

#include <functional>
#include <map>

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

/// Smallest corner determinant over all hexes; of tets six volumes.
double SmallestCornerDeterminant(const Mesh& mesh);

/// Whether the trilinear map of every hex has a positive Jacobian everywhere: its Bernstein
/// coefficients are positive, after subdivision where they are not (Johnen, Remacle, Geuzaine
/// 2013). Tets: every volume is positive.
bool IsPositiveEverywhere(const Mesh& mesh);

/// Smallest of the 27 Bernstein coefficients of a hex's Jacobian, a bound below it; six volumes of
/// a tet.
double SmallestCoefficient(const Mesh& mesh, Index element);

/// "" or what is wrong: a face on more than two elements, an unused point, ids that are not unique.
std::string FindConformityProblem(const Mesh& mesh);

/// Where the boundary of a material is no closed 2-manifold.
struct SurfaceDefects
{
  Index OddEdges = 0;          ///< not on exactly two faces
  Index NonManifoldPoints = 0; ///< whose faces are not connected over the edges at them
};
/// Of every material of the mesh.
std::map<int, SurfaceDefects> CountBoundaryDefects(const Mesh& mesh);

/// FindConformityProblem, or a boundary with defects.
std::string FindTopologyProblem(const Mesh& mesh);

/// "" or what is wrong: a fragment that its faces do not connect, two of one material that share a
/// face.
std::string FindFragmentProblem(const Mesh& mesh);

/// "" or what is wrong: facets that are not, one by one, the faces between fragments and those of
/// one element alone.
std::string FindFacetProblem(const Mesh& mesh);

/// How deep a point beside void that is not meshed lies in an element that is not its own, in
/// widths of it; 0: in none.
double DeepestOverlap(const Mesh& mesh);

/// Volume of a material, exact for tets and trilinear hexes.
double MeasureVolume(const Mesh& mesh, int material);

/// Distances of the points of all interface facets to the nearest of the given surfaces.
struct Distances
{
  double Largest = 0.0, RootMeanSquare = 0.0;
};
Distances MeasureDistances(const Mesh& mesh, const std::function<double(const Vector3&)>& distance);

bool AreEqual(const Mesh& a, const Mesh& b);

} // namespace testing
} // namespace vfm
