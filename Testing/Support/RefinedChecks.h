/**
 * Independent checks of a mesh across levels, and sets of families for tests.
 */
#pragma once

#include "Smoothing/Hex/TransitionSmoothing.h"

#include <functional>
#include <memory>
#include <string>

namespace vfm
{
namespace testing
{

/// Families to refine, with their grid and lattice.
struct RefinedCase
{
  std::string Name;
  std::shared_ptr<CartesianGrid> Grid;
  std::shared_ptr<OctreeKeys> Lattice;
  std::vector<std::vector<Index>> Requested; ///< family keys by level
};

/// Returns the families for which requested(family) is true, of one level in a grid of n cells.
RefinedCase MakeFamilyCase(
  const std::string& name, const Index3& n, const std::function<bool(const Index3&)>& requested);
/// Returns random families of the finest of several levels.
RefinedCase MakeRandomCase(const Index3& n, int levels, double chance, unsigned seed);
/// Returns the families of the finest of several levels that are cut by a sphere
/// of radius .36 n in the middle.
RefinedCase MakeShellCase(Index n, int levels);
/// Returns the cases of the table in Documentation, without random ones and shells.
std::vector<RefinedCase> MakeShapeCases();

/// Refined mesh with all untouched base cells.
struct WholeMesh
{
  std::vector<Vector3> Points;
  std::vector<Index> PointKeys, HexKeys;
  std::vector<std::array<int, 8>> Hexes; ///< in the order of corner bits
  std::vector<unsigned char> IsTransition;
};
WholeMesh AddUntouchedCells(const OctreeKeys& lattice, const RefinedMesh& mesh);

/// Returns an empty string or the first problem: a face on more than two hexes, a single face
/// inside the domain, a link of a point other than a sphere or disc, an Euler characteristic other
/// than 1, keys that are not unique, an unused point.
std::string FindTopologyProblem(const CartesianGrid& grid, const WholeMesh& mesh);
/// Returns an empty string or the first problem: a child of a refined cell that is missing or not
/// exact, another hex that is not a transition hex.
std::string FindChildProblem(const OctantFamilies& sets, const WholeMesh& mesh);
/// Returns the smallest determinant of all hexes, in mean volumes of base cells.
double SmallestCornerDeterminant(const CartesianGrid& grid, const WholeMesh& mesh);
/// Returns the volume of the mesh, exact for trilinear hexes, over the
/// volume of the domain, minus 1.
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
