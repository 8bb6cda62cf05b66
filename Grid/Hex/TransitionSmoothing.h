/**
 * TransitionSmoothing: moves the free points of a refined mesh until its transition hexes are good.
 *
 * First inverted and nearly flat hexes are untangled (UntangleEnergy.h): a fixed schedule of sweeps in which only the
 * points of such hexes move, so each change stays near its cause. Then all free points are smoothed by the barrier energy
 * of HexEnergy. All other points stay: refined cells and untouched ones are exact boxes.
 *
 * Both happen in lattice coordinates, where all cells of a level are cubes: whether untangling succeeds depends on the
 * families alone. Where the cells are no cubes both follow in length units, from that start, and stay if they help.
 *
 * Colours are the parities of the lattice nodes that the points stem from: the points of a hex stem from corners of one
 * cell, so points of one colour share no hex unless they share their node. Each rank moves the points that it owns and
 * gets the others after each colour: the result is the same on any number of ranks and threads.
 */
#pragma once

#include "Base/Runtime.h"
#include "Octree/TwoRefinement.h"

namespace vfm
{

/// The base node whose owner moves a point that stems from a node: the owner of the lowest cell there.
Index3 OwnerNode(const OctreeKeys::LevelIndex& anchor);

/// The colour of the points that stem from a node, among those of all levels, eight a level.
inline int ColourOfNode(const OctreeKeys::LevelIndex& anchor)
{
  return 8 * anchor.Level + CartesianGrid::Colour(anchor.At);
}

struct TransitionReport
{
  Index InvertedHexes = 0; ///< with a corner that is not positive, before; over all ranks
  int UntangleSweeps = 0;
  /// Of each owned transition hex that is not positive throughout, afterwards: its cell. Not looked for when as cubes.
  std::vector<OctreeKeys::LevelIndex> BadCells;
};

/// mesh: of the owned cells of the lattice's grid and those around them (CartesianGrid::Extended(1) or more).
/// smooth: false stops after untangling. asCubes: what is best where all cells are cubes, whatever their widths; then tets
/// are positive too (CoarseTets.h). Throws InputError on all ranks when a rank has more than 2^31 points. Collective.
TransitionReport SmoothTransitions(const OctreeKeys& lattice, RefinedMesh& mesh, Runtime& runtime,
  bool smooth = true, bool asCubes = false);

} // namespace vfm
