/**
 * InterfaceFaces: the faces of cells between two labels.
 */
#pragma once

#include "Labels/Labels.h"

namespace vfm
{

/// Face between two labels, given by its lowest node and its axis. Its lower cell is node - stride,
/// its upper cell is node.
struct InterfaceFace
{
  Index Node;
  int Axis;
  int LowerLabel, UpperLabel; ///< labels of the cells on the - and the + side
  int First() const { return std::min(this->LowerLabel, this->UpperLabel); }
  int Second() const { return std::max(this->LowerLabel, this->UpperLabel); }
};

/// Returns the nodes of a face, in order around its axis.
inline std::array<Index, 4> NodesOfFace(const CartesianGrid& grid, const InterfaceFace& face)
{
  const Index b = grid.Stride((face.Axis + 1) % 3), c = grid.Stride((face.Axis + 2) % 3);
  return { { face.Node, face.Node + b, face.Node + b + c, face.Node + c } };
}

/// Calls visit(face, lower cell, upper cell) for the faces with this lowest node whose cells are
/// both in a box, by axis.
template <class Visitor>
void ForFacesOfNode(const CartesianGrid& grid, const LabelArray& labels, Index node,
  const IndexBox& box, const Visitor& visit)
{
  const Index3 upper = grid.Position(node);
  for (int axis = 0; axis < 3; ++axis)
  {
    Index3 lower = upper;
    --lower[axis];
    const int below = labels[node - grid.Stride(axis)], above = labels[node];
    if (below != above && box.Contains(upper) && box.Contains(lower))
    {
      visit(InterfaceFace{ node, axis, below, above }, lower, upper);
    }
  }
}

} // namespace vfm
