/**
 * Volumes where labels belong to leaves of a refined grid (RefinedGrid::LeafOf), so that interfaces may lie between coarser cells
 * and transitions: to which fragment the material in a finest cell belongs, and what the mesh has at the start.
 */
#pragma once

#include "Base/Runtime.h"
#include "Octree/RefinedGrid.h"
#include "Smoothing/Volumes.h"

namespace vfm
{

/// Like CellLocator, but what is near are the leaves that touch the leaf of the cell; in a leaf that is a finest cell
/// among finest cells the same.
class LeafLocator : public CellLocator
{
public:
  LeafLocator(const RefinedGrid& levels, const LabelArray& labels, const Fragments& fragments) :
    CellLocator(levels.Finest(), labels, fragments), Levels(levels)
  {
  }
  /// Of an owned cell. The leaf whose centre is nearest to that of the cell's leaf, of coarser ones what a leaf as large as the
  /// cell's covers of them; of equal ones the first, x fastest.
  int FindNear(const Index3& cell, int material) const override;

private:
  class Search;

  const RefinedGrid& Levels;
};

/// The exact volumes of the owned hexes of a mesh by fragment, [0] none, over all ranks, in mean cells: the start
/// (FragmentVolumes::SetStart) where nodes between transition hexes have left the faces of the grid. fragments: how many there
/// are. Collective.
std::vector<double> MeasureHexes(
  const Mesh& mesh, const CartesianGrid& grid, int fragments, Runtime& runtime);

} // namespace vfm
