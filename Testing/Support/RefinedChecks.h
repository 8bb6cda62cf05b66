/**
 * Independent checks of a mesh across levels, and the sets of families to try.
 */
#pragma once

#include "Hex/TransitionSmoothing.h"

#include <functional>
#include <memory>
#include <string>

namespace vfm
{
namespace testing
{

/// A set of families to refine, and the grid and lattice it belongs to.
struct RefinedCase
{
  std::string Name;
  std::shared_ptr<CartesianGrid> Grid;
  std::shared_ptr<OctreeKeys> Lattice;
  std::vector<std::vector<Index>> Requested; ///< family keys by level
};

/// One level: the families of a grid of n cells for which wanted(family) holds.
RefinedCase MakeFamilyCase(
  const std::string& name, const Index3& n, const std::function<bool(const Index3&)>& requested);
/// Families of the finest of several levels, each with a chance.
RefinedCase MakeRandomCase(const Index3& n, int levels, double chance, unsigned seed);
/// The families of the finest of several levels that the sphere of radius .36 n in the middle cuts.
RefinedCase MakeShellCase(Index n, int levels);
/// Those of the table in Documentation, without random ones and shells.
std::vector<RefinedCase> MakeShapeCases();

/// The refined mesh with all untouched base cells.
struct WholeMesh
{
  std::vector<Vector3> Points;
  std::vector<Index> PointKeys, HexKeys;
  std::vector<std::array<int, 8>> Hexes; ///< by corner bits
  std::vector<unsigned char> IsTransition;
};
WholeMesh AddUntouchedCells(const OctreeKeys& lattice, const RefinedMesh& mesh);

/// "" or what is wrong: faces on more than two hexes, single faces inside the domain, links of
/// points that are no sphere or disc, an Euler characteristic other than 1, keys that are not
/// unique, unused points.
std::string FindTopologyProblem(const CartesianGrid& grid, const WholeMesh& mesh);
/// "" or a child of a refined cell that is missing or not exact; whether the other hexes are
/// transition hexes.
std::string FindChildProblem(const OctantFamilies& sets, const WholeMesh& mesh);
/// Over all hexes, in mean volumes of the cells of the base grid.
double SmallestCornerDeterminant(const CartesianGrid& grid, const WholeMesh& mesh);
/// Of the mesh, exact for trilinear hexes, over the volume of the domain, less 1.
double VolumeError(const CartesianGrid& grid, const WholeMesh& mesh);

/// Scaled Jacobians of the transition hexes.
struct TransitionQuality
{
  Index Hexes = 0;
  double Minimum = 1.0, FirstPercentile = 1.0, Mean = 1.0;
};
TransitionQuality MeasureTransitions(const RefinedMesh& mesh);

} // namespace testing
} // namespace vfm
