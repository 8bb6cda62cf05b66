/**
 * MidNodes: the nodes of second-order elements between the corners, in the numbering of
 * vtkQuadraticHexahedron, vtkTriQuadraticHexahedron and vtkQuadraticTetra.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Vector3.h"
#include "Elements/ElementFaces.h"

namespace vfm
{

/// Global ids of the two ends of an edge, ascending.
using EdgeIds = std::array<Index, 2>;

inline EdgeIds MakeEdgeIds(Index a, Index b)
{
  return { { std::min(a, b), std::max(a, b) } };
}

/// Mid nodes of an element: those of its edges first, then of its faces, then its centre.
struct MidNodes
{
  /// @param corners  corners per element, 8 or 4
  /// @param count  mid nodes per element: 0, 12, 19 or 6
  MidNodes(int corners, int count) :
    Edges(ShapeOf(corners).Edges), Count(count), EdgeCorners(AreHexes(corners) ? OfHex : OfTet)
  {
  }

  /// Returns the number of mid nodes per element.
  static int CountOf(InterpolationOrder order, int corners)
  {
    return order == InterpolationOrder::Linear ? 0
      : corners == 4                           ? 6
      : order == InterpolationOrder::Quadratic ? 12
                                               : 19;
  }
  bool HasFaces() const { return this->Count > this->Edges; }

  /// Returns the number of an edge of a face: from a corner of the face, in the order of
  /// ElementFaces, to the next one.
  int EdgeOfFace(int face, int corner) const
  {
    return this->Edges == 12 ? FacesOfHex[face][corner] : FacesOfTet[face][corner];
  }

  const int Edges, Count;      ///< number of edges, and of mid nodes
  const int (*EdgeCorners)[2]; ///< corners of each edge

private:
  static constexpr int FacesOfHex[6][4] = { { 8, 7, 11, 3 }, { 1, 10, 5, 9 }, { 0, 9, 4, 8 },
    { 11, 6, 10, 2 }, { 3, 2, 1, 0 }, { 4, 5, 6, 7 } };
  static constexpr int FacesOfTet[4][4] = { { 0, 4, 3, -1 }, { 1, 5, 4, -1 }, { 2, 3, 5, -1 },
    { 2, 1, 0, -1 } };
  static constexpr int OfHex[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
    { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  static constexpr int OfTet[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
};

/// Displacement from its middle that the surfaces at one end of an edge request of the mid node.
/// The displacement of the node is half the sum over both ends. All copies of an edge, on opposite
/// sides and at split interfaces, have the same pulls: their ids are Mesh::CommonIds.
struct EdgePull
{
  EdgeIds Edge;
  Index End;     ///< id of the end, equal to one of Edge
  Vector3 Pull;  ///< length units of the grid
  bool IsHeld;   ///< the edge stays straight, whatever the other end requests
  EdgeIds Group; ///< edges of a group become straight together: those of layers above an edge
};

/// Displacement of the mid node of an edge.
struct EdgeMove
{
  Vector3 Move;
  EdgeIds Group; ///< EdgePull::Group
};

} // namespace vfm
