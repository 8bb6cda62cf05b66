/**
 * DualTets: the tetrahedra that the cells of a dual mesh consist of, and the way around their
 * edges.
 *
 * Corners, sides and edges of tetrahedra are numbered as in ElementFaces.h and MidNodes.h. The part
 * of a tetrahedron at a corner is a quarter of its volume: it is bounded by the middles of the
 * edges, the centres of the sides and the centre of the tetrahedron.
 */
#pragma once

#include "Report/MatchFaces.h"

#include <utility>
#include <vector>

namespace vfm
{

/// Corners of the edges of a tetrahedron, then the other two: all four are an even permutation.
constexpr int CornersByEdge[6][4] = { { 0, 1, 2, 3 }, { 1, 2, 0, 3 }, { 2, 0, 1, 3 },
  { 0, 3, 1, 2 }, { 1, 3, 2, 0 }, { 2, 3, 0, 1 } };

/// Side of a tetrahedron opposite to each corner.
constexpr int SideByCorner[4] = { 1, 2, 0, 3 };

/// Tetrahedra of a whole mesh with the walls between their regions. A region is a material, or a
/// fragment of it if the fragments are known.
class DualTets
{
public:
  /// @param mesh  linear tetrahedra; must outlive the object
  /// @throws InputError  if a face belongs to more than two elements
  explicit DualTets(const MeshData& mesh) : Mesh(mesh), Behind(MatchSides(mesh)) {}

  const MeshData& Data() const { return this->Mesh; }
  Index Count() const { return this->Mesh.NumberOfElements; }
  Index Node(Index tet, int corner) const { return this->Mesh.Element(tet)[corner]; }
  /// Returns the corner at a node of the tetrahedron.
  int CornerAt(Index tet, Index node) const
  {
    const Index* nodes = this->Mesh.Element(tet);
    return static_cast<int>(std::find(nodes, nodes + 4, node) - nodes);
  }
  /// Returns the tetrahedron behind a side, 4 * tet + side, or NothingBehind.
  Index BehindSide(Index side) const { return this->Behind[side]; }
  /// Returns the region of a tetrahedron.
  std::pair<int, int> RegionOf(Index tet) const
  {
    return { this->Mesh.Material[tet], this->Mesh.Fragment ? this->Mesh.Fragment[tet] : 0 };
  }
  /// Returns whether a side is on the boundary or between two regions.
  bool IsWall(Index side) const
  {
    const Index behind = this->Behind[side];
    return behind == NothingBehind || this->RegionOf(behind) != this->RegionOf(side / 4);
  }

private:
  const MeshData& Mesh;
  const std::vector<Index> Behind;
};

/// The cells of a dual mesh: one for each node and each group of tetrahedra at this node that are
/// connected by sides that are no walls.
struct DualCells
{
  std::vector<Index> OfCorner; ///< cell of corner c of tetrahedron t at 4 * t + c
  std::vector<Index> Nodes;    ///< node of each cell, ascending
  std::vector<Index> Tets;     ///< lowest tetrahedron of each cell
};

/// @param isApart  of each corner: whether its part is a cell of its own; empty: none
DualCells FindDualCells(const DualTets& tets, const std::vector<char>& isApart = {});

/// The tetrahedra around an edge from one wall to the next, or all around it.
struct EdgeArc
{
  std::vector<Index> Tets; ///< counterclockwise seen from the end of the edge
  Index FirstSide = -1;    ///< side of the first tetrahedron that is a wall; -1: there are no walls
  Index LastSide = -1;     ///< side of the last one
};

/// Returns the arc with a tetrahedron around one of its edges.
EdgeArc FollowEdge(const DualTets& tets, Index tet, int edge);

/// Returns the number of the edge, 0 to 5, between two corners.
int EdgeBetween(int first, int second);

} // namespace vfm
