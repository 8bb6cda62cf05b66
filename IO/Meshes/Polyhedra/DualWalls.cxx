#include "Meshes/Polyhedra/DualWalls.h"

#include "Base/Vector3.h"

#include <cmath>
#include <tuple>

namespace vfm
{
namespace
{

constexpr double SmoothCosine = 0.8660254037844387; ///< of 30 degrees between two triangles
constexpr double StraightCosine = 1.0 - 1e-14;      ///< of two edges of a sharp curve

std::vector<WallTriangle> ListTriangles(const DualTets& tets, const SurfaceOfSide& surfaceOf)
{
  std::vector<WallTriangle> triangles;
  for (Index side = 0; side < 4 * tets.Count(); ++side)
  {
    const Index behind = tets.BehindSide(side);
    const bool isFront = tets.IsWall(side) &&
      (behind == NothingBehind || tets.RegionOf(side / 4) < tets.RegionOf(behind));
    if (isFront)
    {
      const ElementSide place{ side / 4, static_cast<int>(side % 4) };
      const FaceIds nodes = PointsOfSide(tets.Data(), place);
      triangles.push_back({ side, NothingBehind, surfaceOf(place),
        { { nodes[0], nodes[1], nodes[2] } }, { { -1, -1, -1 } } });
    }
  }
  return triangles;
}

/// Sets the triangles of each side, and the sides behind triangles.
void LinkSides(const DualTets& tets, DualWalls& walls)
{
  walls.OfSide.assign(4 * tets.Count(), -1);
  for (std::size_t t = 0; t < walls.Triangles.size(); ++t)
  {
    WallTriangle& triangle = walls.Triangles[t];
    walls.OfSide[triangle.Front] = static_cast<Index>(t);
    const Index behind = tets.BehindSide(triangle.Front), front = triangle.Front / 4;
    for (Index side = 4 * behind; behind != NothingBehind && side < 4 * behind + 4; ++side)
    {
      if (tets.BehindSide(side) == front)
      {
        walls.OfSide[side] = static_cast<Index>(t);
        triangle.Back = side;
      }
    }
  }
}

Vector3 NormalOf(const MeshData& mesh, const WallTriangle& triangle)
{
  const Vector3 first = mesh.PointAt(triangle.Nodes[0]);
  return Unit(
    Cross(mesh.PointAt(triangle.Nodes[1]) - first, mesh.PointAt(triangle.Nodes[2]) - first));
}

/// Numbers the edges of triangles, smooth or not.
void FindEdges(const MeshData& mesh, const std::vector<NodeEdges>& edges, DualWalls& walls)
{
  std::vector<std::tuple<EdgeIds, Index, int>> places; // edge, triangle, its first node there
  for (std::size_t t = 0; t < walls.Triangles.size(); ++t)
  {
    for (int n = 0; n < 3; ++n)
    {
      const std::array<Index, 3>& nodes = walls.Triangles[t].Nodes;
      places.emplace_back(MakeEdgeIds(nodes[n], nodes[(n + 1) % 3]), static_cast<Index>(t), n);
    }
  }
  std::sort(places.begin(), places.end());
  const auto isSmooth = [&](const EdgeIds& edge, Index a, Index b)
  {
    const WallTriangle &first = walls.Triangles[a], &second = walls.Triangles[b];
    const NodeEdges kind = std::max(edges[edge[0]], edges[edge[1]]);
    if (kind != NodeEdges::ByAngle)
    {
      return kind == NodeEdges::Round && first.Surface.Joined == second.Surface.Joined;
    }
    return first.Surface.Finest == second.Surface.Finest &&
      Dot(NormalOf(mesh, first), NormalOf(mesh, second)) >= SmoothCosine;
  };
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end)
  {
    const auto& [edge, first, place] = places[begin];
    while (end < places.size() && std::get<0>(places[end]) == edge)
    {
      auto& [nodes, triangle, node] = places[end];
      walls.Triangles[triangle].Edges[node] = static_cast<Index>(walls.Edges.size());
      ++end;
    }
    const Index last = std::get<1>(places[end - 1]);
    const bool isJoined = end - begin == 2 && isSmooth(edge, first, last);
    walls.Edges.push_back({ edge, { { first, last } }, isJoined ? -1 : walls.NumberOfPoints++ });
  }
}

/// Decides at which nodes sharp edges meet in a corner or branch.
void FindNodes(const MeshData& mesh, DualWalls& walls)
{
  std::vector<std::pair<Index, Index>> ends; // node and the other end of a sharp edge
  for (const WallEdge& edge : walls.Edges)
  {
    if (edge.Middle >= 0)
    {
      ends.emplace_back(edge.Nodes[0], edge.Nodes[1]);
      ends.emplace_back(edge.Nodes[1], edge.Nodes[0]);
    }
  }
  std::sort(ends.begin(), ends.end());
  walls.NodePoints.assign(mesh.NumberOfPoints, -1);
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end)
  {
    const Index node = ends[begin].first;
    while (end < ends.size() && ends[end].first == node)
    {
      ++end;
    }
    const auto to = [&](std::size_t place)
    { return Unit(mesh.PointAt(ends[place].second) - mesh.PointAt(node)); };
    const bool isStraight = end - begin == 2 && -Dot(to(begin), to(begin + 1)) >= StraightCosine;
    walls.NodePoints[node] = isStraight ? -1 : walls.NumberOfPoints++;
  }
}

/// A part of a triangle.
struct WallPart
{
  Index Triangle;
  int Place; ///< of its node in the triangle
};

/// Returns the part at the same node behind an edge of a triangle.
WallPart StepOver(const DualWalls& walls, const WallPart& part, const WallEdge& edge)
{
  const Index node = walls.Triangles[part.Triangle].Nodes[part.Place];
  const Index next = edge.Triangles[edge.Triangles[0] == part.Triangle ? 1 : 0];
  const std::array<Index, 3>& nodes = walls.Triangles[next].Nodes;
  return { next, static_cast<int>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin()) };
}

/// Returns the edge after the node of a part, or the one before it.
const WallEdge& EdgeAt(const DualWalls& walls, const WallPart& part, bool isAfter)
{
  return walls
    .Edges[walls.Triangles[part.Triangle].Edges[isAfter ? part.Place : (part.Place + 2) % 3]];
}

/// Returns the polygon with a part, and marks its parts.
WallPolygon JoinFrom(const DualWalls& walls, const WallPart& start, std::vector<char>& isDone)
{
  WallPart part = start;
  do // clockwise, to a sharp edge or once around
  {
    const WallEdge& edge = EdgeAt(walls, part, true);
    if (edge.Middle >= 0)
    {
      break;
    }
    part = StepOver(walls, part, edge);
  } while (part.Triangle != start.Triangle);
  const Index node = walls.Triangles[part.Triangle].Nodes[part.Place];
  const Index first = part.Triangle, begin = EdgeAt(walls, part, true).Middle;
  WallPolygon polygon{ node, first, {} };
  if (begin >= 0)
  {
    polygon.Points.push_back(begin);
  }
  for (;;)
  {
    isDone[3 * part.Triangle + part.Place] = 1;
    polygon.Points.push_back(walls.CentreOf(part.Triangle));
    const WallEdge& edge = EdgeAt(walls, part, false);
    if (edge.Middle >= 0)
    {
      if (edge.Middle != begin) // otherwise a sharp curve ends inside of a surface
      {
        polygon.Points.push_back(edge.Middle);
        if (walls.NodePoints[node] >= 0)
        {
          polygon.Points.push_back(walls.NodePoints[node]);
        }
      }
      return polygon;
    }
    part = StepOver(walls, part, edge);
    if (part.Triangle == first)
    {
      return polygon;
    }
  }
}

} // namespace

Index DualWalls::MiddleOf(Index triangle, const EdgeIds& nodes) const
{
  for (const Index edge : this->Triangles[triangle].Edges)
  {
    if (this->Edges[edge].Nodes == nodes)
    {
      return this->Edges[edge].Middle;
    }
  }
  return -1;
}

Index DualWalls::MiddleOf(const EdgeIds& nodes) const
{
  const auto edge = std::lower_bound(this->Edges.begin(), this->Edges.end(), nodes,
    [](const WallEdge& a, const EdgeIds& b) { return a.Nodes < b; });
  return edge == this->Edges.end() || edge->Nodes != nodes ? -1 : edge->Middle;
}

DualWalls FindDualWalls(const DualTets& tets, const SurfaceOfSide& surfaceOf,
  const std::vector<NodeEdges>& edges, Index firstPoint)
{
  DualWalls walls;
  walls.Triangles = ListTriangles(tets, surfaceOf);
  walls.FirstPoint = firstPoint;
  walls.NumberOfPoints = firstPoint + static_cast<Index>(walls.Triangles.size());
  LinkSides(tets, walls);
  FindEdges(tets.Data(), edges, walls);
  FindNodes(tets.Data(), walls);
  return walls;
}

std::vector<WallPolygon> JoinWallParts(const DualWalls& walls)
{
  std::vector<char> isDone(3 * walls.Triangles.size(), 0);
  std::vector<WallPolygon> polygons;
  for (std::size_t part = 0; part < isDone.size(); ++part)
  {
    if (!isDone[part])
    {
      polygons.push_back(
        JoinFrom(walls, { static_cast<Index>(part / 3), static_cast<int>(part % 3) }, isDone));
    }
  }
  return polygons;
}

void AddWallPoints(const MeshData& mesh, const DualWalls& walls, std::vector<double>& points)
{
  const auto set = [&points](Index point, const Vector3& x)
  { std::copy(x.begin(), x.end(), points.begin() + 3 * point); };
  points.resize(3 * walls.NumberOfPoints);
  for (std::size_t t = 0; t < walls.Triangles.size(); ++t)
  {
    std::array<Index, 3> nodes = walls.Triangles[t].Nodes;
    std::sort(nodes.begin(), nodes.end());
    const Vector3 sum = mesh.PointAt(nodes[0]) + mesh.PointAt(nodes[1]) + mesh.PointAt(nodes[2]);
    set(walls.CentreOf(static_cast<Index>(t)), (1.0 / 3.0) * sum);
  }
  for (const WallEdge& edge : walls.Edges)
  {
    if (edge.Middle >= 0)
    {
      set(edge.Middle, 0.5 * (mesh.PointAt(edge.Nodes[0]) + mesh.PointAt(edge.Nodes[1])));
    }
  }
  for (Index node = 0; node < mesh.NumberOfPoints; ++node)
  {
    if (walls.NodePoints[node] >= 0)
    {
      set(walls.NodePoints[node], mesh.PointAt(node));
    }
  }
}

} // namespace vfm
