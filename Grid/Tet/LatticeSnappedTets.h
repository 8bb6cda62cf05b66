/**
 * Snapped tets: lattice tets whose nodes are all snapped, so that their labels are their own.
 *
 * They begin with the label by the mean of their nodes' fractions. Then they take the label that most of their face
 * neighbours show, so that interfaces are less ragged, if more of the four show it than show the tet's own; ties
 * to the smaller. All at once, for ten rounds or until none changes.
 */
#pragma once

#include "Base/Partition.h"

namespace vfm
{

struct SnappedTet
{
  Index Id; ///< of its first piece
  Index3 Block;
  int Shape;
  int Label;
  std::array<Index, 4> Faces; ///< across its nodes: ids of the points in the triangles
};

/// A triangle of snapped nodes of a lattice tet whose fourth node has a label.
struct SnappedFace
{
  Index Id;
  int Label;
};

/// tets: of CartesianGrid::HexBox, by id. faces: of the lattice tets there. Those of other ranks are told by their
/// owners, the ranks of the cells above their faces. Collective.
void SettleSnappedTets(std::vector<SnappedTet>& tets, const std::vector<SnappedFace>& faces,
  const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
