/**
 * Independent checks of a mesh of hexahedra or tetrahedra: validity, conformity, manifold boundary.
 */
#pragma once

#include "Phases/MeshOfCells.h"

#include <functional>
#include <map>

namespace vfm
{
namespace testing
{

/// Returns a grid of nx x ny x nz unit cells.
CartesianGrid MakeUnitGrid(Index nx, Index ny, Index nz);
inline CartesianGrid MakeUnitGrid(Index n)
{
  return MakeUnitGrid(n, n, n);
}

/// Returns label(i, j, k) of each cell as fractions.
FractionField MakeLabels(
  const CartesianGrid& grid, int materials, const std::function<int(const Index3&)>& label);

/// Returns random labels from lowest to materials.
FractionField MakeRandomLabels(const CartesianGrid& grid, int materials, int lowest, unsigned seed);

/// Returns the smallest corner determinant of all hexes; of tets six times the volume.
double SmallestCornerDeterminant(const Mesh& mesh);

/// Returns whether the trilinear map of every hex has a positive Jacobian determinant everywhere:
/// its Bernstein coefficients are positive, after subdivision if necessary. Tets: whether every
/// volume is positive. Johnen, Remacle and Geuzaine, J. Comput. Phys. 233 (2013) 359-372.
bool IsPositiveEverywhere(const Mesh& mesh);

/// Returns the smallest of the 27 Bernstein coefficients of a hex's Jacobian determinant, a lower
/// bound of it; six times the volume of a tet.
double SmallestCoefficient(const Mesh& mesh, Index element);

/// Returns an empty string or the first problem: a face shared by more than two elements, an unused
/// point, ids that are not unique.
std::string FindConformityProblem(const Mesh& mesh);

/// Defects of the boundary of a material, which must be a closed 2-manifold.
struct SurfaceDefects
{
  Index OddEdges = 0;          ///< edges not on exactly two faces
  Index NonManifoldPoints = 0; ///< points whose faces are not connected over their edges
};
/// Counts the defects of each material of the mesh.
std::map<int, SurfaceDefects> CountBoundaryDefects(const Mesh& mesh);

/// Returns the result of FindConformityProblem, or a boundary with defects.
std::string FindTopologyProblem(const Mesh& mesh);

/// Returns an empty string or the first problem: a fragment not connected by faces, two fragments
/// of one material that share a face.
std::string FindFragmentProblem(const Mesh& mesh);

/// Returns an empty string or the first problem: the facets must equal, one by one, the faces
/// between fragments and the faces of only one element.
std::string FindFacetProblem(const Mesh& mesh);

/// Returns the number of faces that are on one element only.
Index CountFreeFaces(const Mesh& mesh);

/// Returns the number of elements whose points are all on interfaces or on sides of the domain.
Index CountLocked(const Mesh& mesh);

/// Returns the mesh of the resolved cells: hexes that are not moved.
Mesh MakeCells(
  const CartesianGrid& grid, const FractionField& fractions, const MeshOptions& options);

/// Returns an empty string or the first problem: the fragments of a mesh, and the pairs of them
/// that share a face, must be those of the cells. Void without elements counts as one fragment.
/// @param mesh  mesh of one rank
/// @param cells  MakeCells of the same options, for tets with Levels.FineInterfaces
std::string FindCellProblem(const CartesianGrid& grid, const Mesh& mesh, const Mesh& cells);

/// Returns the volume of a material, exact for tets and trilinear hexes.
double MeasureVolume(const Mesh& mesh, int material);

/// Distances of the points of all interface facets to the true surface.
struct Distances
{
  double Largest = 0.0, RootMeanSquare = 0.0;
};
Distances MeasureDistances(const Mesh& mesh, const std::function<double(const Vector3&)>& distance);

bool AreEqual(const Mesh& a, const Mesh& b);

} // namespace testing
} // namespace vfm
