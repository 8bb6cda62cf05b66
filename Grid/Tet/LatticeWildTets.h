/**
 * Wild tets: lattice tets whose nodes are all wild, so that their labels are their own.
 *
 * They begin with the label by the mean of their nodes' fractions. Then they take the label that most of their face
 * neighbours show, so that interfaces are less ragged, if more of the four show it than show the tet's own; ties
 * to the smaller. All at once, for ten rounds or until none changes.
 */
#pragma once

#include "Base/Partition.h"

namespace vfm
{

struct WildTet
{
  Index Id; ///< of its first piece
  Index3 Block;
  int Shape;
  int Label;
  std::array<Index, 4> Faces; ///< across its nodes: ids of the points in the triangles
};

/// A triangle of wild nodes of a lattice tet whose fourth node has a label.
struct WildFace
{
  Index Id;
  int Label;
};

/// tets: of CartesianGrid::HexBox, by id. faces: of the lattice tets there. Those of other ranks are told by their
/// owners, the ranks of the cells above their faces. Collective.
void SettleWildTets(std::vector<WildTet>& tets, const std::vector<WildFace>& faces,
  const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
