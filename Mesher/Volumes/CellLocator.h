/**
 * CellLocator: finds the fragment of the material in a cell, for fragments that consist of cells or
 * of leaves of a refined grid.
 */
#pragma once

#include "Labels/Fragments.h"
#include "Octree/RefinedGrid.h"
#include "Volumes/FragmentVolumes.h"

namespace vfm
{

/// Searches the cells around a cell. If interfaces cross levels, it searches the leaves that touch
/// the leaf of the cell. Refers to all arguments of the constructor; thread safe.
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
  /// Returns the fragment of a material near an owned cell, or 0. Candidates are the cells around
  /// its leaf on the level of that leaf, or their leaves that touch it if they are refined. The
  /// candidate whose centre is nearest to the centre of the leaf counts; of equally near ones the
  /// first, x fastest.
  int FindNear(const Index3& cell, int material) const override;

private:
  class Search;

  const RefinedGrid& Levels;
  const CartesianGrid& Grid;
  const LabelArray& Labels;
  const Fragments& Pieces;
};

/// Returns the volumes of fragments that consist of cells or leaves.
/// @param leavesFar  as of FragmentVolumes
/// @pre Collective.
FragmentVolumes VolumesOfCells(const CartesianGrid& grid, const FractionField& fractions,
  const RefinedGrid& levels, const LabelArray& labels, const Fragments& fragments, bool leavesFar,
  Runtime& runtime);

} // namespace vfm
