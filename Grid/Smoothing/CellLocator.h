/**
 * To which fragment the material in a cell belongs, where fragments are made of cells or of leaves of a refined grid.
 */
#pragma once

#include "Octree/RefinedGrid.h"
#include "Smoothing/Volumes.h"

namespace vfm
{

/// Looks at the cells around a cell. Where interfaces cross levels: at the leaves that touch the leaf of the cell.
class CellLocator : public FragmentLocator
{
public:
  CellLocator(const RefinedGrid& levels, const LabelArray& labels, const Fragments& fragments) :
    Levels(levels), Grid(levels.Finest()), Labels(labels), Pieces(fragments)
  {
  }
  void ForRuns(Index j, Index k, const Body& body) const override
  {
    this->Pieces.ForRuns(j, k, body);
  }
  /// Of an owned cell. Looks at the cells around its leaf, of the level of that leaf, and in refined ones at the leaves that touch
  /// it. Of those with the material the one whose centre is nearest to that of the leaf counts; of equal ones the first, x fastest.
  int FindNear(const Index3& cell, int material) const override;

private:
  class Search;

  const RefinedGrid& Levels;
  const CartesianGrid& Grid;
  const LabelArray& Labels;
  const Fragments& Pieces;
};

} // namespace vfm
