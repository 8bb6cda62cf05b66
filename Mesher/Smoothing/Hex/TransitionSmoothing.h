/**
 * TransitionSmoothing: moves the free points of a refined mesh until its transition hexes are good.
 *
 * First, inverted and nearly flat hexes are untangled (UntangleEnergy.h) by a fixed schedule of
 * sweeps in which only the points of such hexes move, so that each change stays near its cause.
 * Then all free points are smoothed by the energy of HexEnergy. All other points are fixed: refined
 * and untouched cells are exact boxes.
 *
 * Both steps use lattice coordinates, in which all cells of a level are cubes, so that success
 * depends only on the families. If cells are not cubes, both steps are repeated from that result in
 * length units, and kept if they help.
 *
 * Colours are the parities of the lattice nodes from which the points stem. The points of a hex
 * stem from corners of one cell, so points of one colour share no hex unless they share their node.
 * Each rank moves its own points and receives the others after each colour, so the result does not
 * depend on the number of ranks and threads.
 */
#pragma once

#include "Base/Runtime.h"
#include "Octree/TwoRefinement.h"

namespace vfm
{

/// Returns the base node whose owner moves the points that stem from a node: the upper corner of
/// the base cell around the lowest cell there.
Index3 OwnerNode(const OctreeKeys::LevelIndex& anchor);

/// Returns the colour of the points that stem from a node, among the colours of all levels, eight
/// per level.
inline int ColourOfNode(const OctreeKeys::LevelIndex& anchor)
{
  return 8 * anchor.Level + CartesianGrid::Parities(anchor.At);
}

/// Result of SmoothTransitions.
struct TransitionReport
{
  /// Number of hexes with a corner that is not positive, before untangling, over all ranks.
  Index InvertedHexes = 0;
  int UntangleSweeps = 0;
  /// Cell of each owned transition hex that is not positive everywhere at the end.
  std::vector<OctreeKeys::LevelIndex> BadCells;
};

/// Untangles and smooths the transition hexes of a refined mesh.
/// @param[in,out] mesh  mesh of the owned cells of the lattice's grid and the cells around them
/// (CartesianGrid::Extended(1) or more)
/// @param smooth  false: stops after untangling
/// @throws InputError  if a rank has more than 2^31 points, on all ranks
/// @pre Collective.
TransitionReport SmoothTransitions(
  const OctreeKeys& lattice, RefinedMesh& mesh, Runtime& runtime, bool smooth = true);

} // namespace vfm
