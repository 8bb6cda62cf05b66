/**
 * DualWalls: the faces of a dual mesh on the walls between regions and on the boundary.
 *
 * A wall triangle has three parts, one at each node: a quadrilateral of the node, the middles of
 * two edges and the centre of the triangle. The parts at a node that belong to the same two cells
 * are joined over smooth edges to one polygon, which leaves the middles of these edges out. It
 * leaves the node out, too, unless sharp edges meet there that are not straight.
 */
#pragma once

#include "Meshes/Polyhedra/DualTets.h"

#include <functional>

namespace vfm
{

/// The named surface of a wall triangle.
struct WallSurface
{
  int Finest;   ///< number; polygons have triangles of one number, except at round nodes
  int Joined;   ///< number of all surfaces that round nodes join
  bool IsFixed; ///< a side of the domain
};

using SurfaceOfSide = std::function<WallSurface(const ElementSide&)>;

/// A triangle between two regions or on the boundary.
struct WallTriangle
{
  Index Front; ///< side of the lower region: 4 * tet + side
  Index Back;  ///< side behind; NothingBehind on the boundary
  WallSurface Surface;
  std::array<Index, 3> Nodes; ///< counterclockwise seen from behind
  std::array<Index, 3> Edges; ///< from each node to the next: number among DualWalls::Edges
};

struct WallEdge
{
  EdgeIds Nodes;
  std::array<Index, 2> Triangles; ///< if smooth
  Index Middle;                   ///< number of the point in the middle; -1: smooth
};

/// A polygon on a wall, in the points of the dual mesh.
struct WallPolygon
{
  Index Node;
  Index Triangle;            ///< its first triangle
  std::vector<Index> Points; ///< counterclockwise seen from behind
};

struct DualWalls
{
  std::vector<WallTriangle> Triangles; ///< by Front, ascending
  std::vector<WallEdge> Edges;         ///< by Nodes, ascending
  std::vector<Index> OfSide;           ///< triangle of each side of the tetrahedra; -1: no wall
  std::vector<Index> NodePoints;       ///< number of the point at each node; -1: left out
  Index FirstPoint = 0;                ///< number of the point in the centre of the first triangle
  Index NumberOfPoints = 0;            ///< with those before FirstPoint

  Index CentreOf(Index triangle) const { return this->FirstPoint + triangle; }
  /// Returns the point in the middle of an edge of a triangle; -1: none.
  Index MiddleOf(Index triangle, const EdgeIds& nodes) const;
  /// Returns the point in the middle of an edge; -1: none, or the edge is on no wall.
  Index MiddleOf(const EdgeIds& nodes) const;
};

/// Which wall edges at a node are smooth.
enum class NodeEdges : char
{
  ByAngle, ///< those up to 30 degrees between two triangles of the same finest surface
  Round,   ///< all that have the same joined surface on both sides
  Sharp    ///< none, also where the other node is round
};

/// Finds the walls, and decides which middles of edges and which nodes become points.
/// @param edges  of each node
/// @param firstPoint  number of the first point that the walls add
DualWalls FindDualWalls(const DualTets& tets, const SurfaceOfSide& surfaceOf,
  const std::vector<NodeEdges>& edges, Index firstPoint);

/// Returns the polygons of all triangles.
std::vector<WallPolygon> JoinWallParts(const DualWalls& walls);

/// Adds the coordinates of the points of walls.
void AddWallPoints(const MeshData& mesh, const DualWalls& walls, std::vector<double>& points);

} // namespace vfm
