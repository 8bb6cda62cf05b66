/**
 * LatticeSnappedTets: labels the snapped tets, the lattice tets whose nodes are all snapped.
 *
 * The initial label of a snapped tet is the label of the mean fractions of its nodes. Then the
 * labels are smoothed, which makes interfaces less ragged. A tet takes the label that is most
 * frequent among its four face neighbours, if more of them have it than have the label of the tet;
 * ties go to the smaller label. All tets change at once, for ten rounds or until none changes.
 */
#pragma once

#include "Base/Partition.h"

namespace vfm
{

struct SnappedTet
{
  Index Id;     ///< id of its only element
  Index3 Block; ///< block of its face of the grid
  int Shape;    ///< LatticeTables::Shape
  int Label;
  /// Id of the point in the triangle opposite to each node, by which faces are identified.
  std::array<Index, 4> Faces;
};

/// Face with three snapped nodes of a lattice tet whose fourth node has a label.
struct SnappedFace
{
  Index Id;  ///< id of the point in the triangle
  int Label; ///< label of the fourth node
};

/// Smooths the labels of snapped tets. The owner of a tet, the rank of the cell above its face of
/// the grid, sends its label to the other ranks that hold it.
/// @param tets  snapped tets of CartesianGrid::HexBox, in order of id; their labels are changed
/// @param faces  snapped faces of all other lattice tets of HexBox
/// @pre Collective.
void SettleSnappedTets(std::vector<SnappedTet>& tets, const std::vector<SnappedFace>& faces,
  const CartesianGrid& grid, const Partition& partition);

} // namespace vfm
