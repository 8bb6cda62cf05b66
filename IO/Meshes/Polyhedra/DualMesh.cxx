#include "Meshes/Polyhedra/DualMesh.h"

#include "Meshes/Polyhedra/DualMeasures.h"
#include "Meshes/Polyhedra/FitWalls.h"

#include <optional>
#include <tuple>

namespace vfm
{
namespace
{

constexpr int MostRounds = 4; ///< of rounding edges

/// A face before the order is known.
struct DualFace
{
  Index Owner, Neighbour, WallSide;
  Index Begin, End; ///< of its points
};

/// Collects faces and their points.
struct DualFaces
{
  std::vector<DualFace> Faces;
  std::vector<Index> Points;

  /// @param cells  in front of and behind the polygon
  /// @param sides  wall sides of both cells, or -1
  void Add(const std::vector<Index>& polygon, std::array<Index, 2> cells,
    const std::array<Index, 2>& sides)
  {
    const bool isReversed = cells[1] != NothingBehind && cells[1] < cells[0];
    const Index begin = static_cast<Index>(this->Points.size());
    if (isReversed)
    {
      this->Points.insert(this->Points.end(), polygon.rbegin(), polygon.rend());
      std::swap(cells[0], cells[1]);
    }
    else
    {
      this->Points.insert(this->Points.end(), polygon.begin(), polygon.end());
    }
    this->Faces.push_back({ cells[0], cells[1], sides[isReversed ? 1 : 0], begin,
      static_cast<Index>(this->Points.size()) });
  }
};

/// Adds the faces around the edges of the tetrahedra.
void AddEdgeFaces(
  const DualTets& tets, const DualCells& cells, const DualWalls& walls, DualFaces& faces)
{
  std::vector<char> isDone(6 * tets.Count(), 0);
  std::vector<Index> polygon;
  for (Index place = 0; place < 6 * tets.Count(); ++place)
  {
    if (isDone[place])
    {
      continue;
    }
    const Index tet = place / 6;
    const int edge = static_cast<int>(place % 6);
    const int first = CornersByEdge[edge][0], second = CornersByEdge[edge][1];
    const Index from = tets.Node(tet, first), to = tets.Node(tet, second);
    const EdgeArc arc = FollowEdge(tets, tet, edge);
    polygon.clear();
    if (arc.FirstSide >= 0)
    {
      polygon.push_back(walls.CentreOf(walls.OfSide[arc.FirstSide]));
    }
    for (const Index at : arc.Tets)
    {
      isDone[6 * at + EdgeBetween(tets.CornerAt(at, from), tets.CornerAt(at, to))] = 1;
      polygon.push_back(at);
    }
    if (arc.FirstSide >= 0)
    {
      const Index last = walls.OfSide[arc.LastSide];
      polygon.push_back(walls.CentreOf(last));
      const Index middle = walls.MiddleOf(last, MakeEdgeIds(from, to));
      if (middle >= 0)
      {
        polygon.push_back(middle);
      }
    }
    faces.Add(polygon, { { cells.OfCorner[4 * tet + first], cells.OfCorner[4 * tet + second] } },
      { { -1, -1 } });
  }
}

/// Returns the cell of a side at a node.
Index CellAt(const DualTets& tets, const DualCells& cells, Index side, Index node)
{
  return side < 0 ? NothingBehind : cells.OfCorner[4 * (side / 4) + tets.CornerAt(side / 4, node)];
}

void AddWallFaces(
  const DualTets& tets, const DualCells& cells, const DualWalls& walls, DualFaces& faces)
{
  for (const WallPolygon& polygon : JoinWallParts(walls))
  {
    const WallTriangle& triangle = walls.Triangles[polygon.Triangle];
    faces.Add(polygon.Points,
      { { CellAt(tets, cells, triangle.Front, polygon.Node),
        CellAt(tets, cells, triangle.Back, polygon.Node) } },
      { { triangle.Front, triangle.Back } });
  }
}

/// Orders the faces.
void SetFaces(const DualFaces& faces, DualMesh& dual)
{
  std::vector<std::tuple<bool, Index, Index, Index>> order;
  for (std::size_t f = 0; f < faces.Faces.size(); ++f)
  {
    const DualFace& face = faces.Faces[f];
    order.emplace_back(face.Neighbour == NothingBehind, face.Owner, face.Neighbour, f);
  }
  std::sort(order.begin(), order.end());
  dual.FacePoints.reserve(faces.Points.size());
  for (const auto& [isOuter, owner, neighbour, place] : order)
  {
    const DualFace& face = faces.Faces[place];
    dual.FacePoints.insert(
      dual.FacePoints.end(), faces.Points.begin() + face.Begin, faces.Points.begin() + face.End);
    dual.FaceEnds.push_back(static_cast<Index>(dual.FacePoints.size()));
    dual.Owners.push_back(owner);
    dual.WallSides.push_back(face.WallSide);
    if (!isOuter)
    {
      dual.Neighbours.push_back(neighbour);
    }
  }
}

/// Removes the points that no face has.
void DropUnused(DualMesh& dual)
{
  std::vector<Index> numbers(dual.NumberOfPoints(), -1);
  for (const Index point : dual.FacePoints)
  {
    numbers[point] = 0;
  }
  Index count = 0;
  for (std::size_t point = 0; point < numbers.size(); ++point)
  {
    if (numbers[point] == 0)
    {
      std::copy_n(dual.Points.begin() + 3 * point, 3, dual.Points.begin() + 3 * count);
      numbers[point] = count++;
    }
  }
  dual.Points.resize(3 * count);
  for (Index& point : dual.FacePoints)
  {
    point = numbers[point];
  }
}

/// Adds a point in each tetrahedron. Nodes that are on no wall draw it with double weight, which
/// makes the cells at walls thicker.
void AddTetPoints(const MeshData& mesh, const DualWalls& walls, std::vector<double>& points)
{
  std::vector<char> isOnWall(mesh.NumberOfPoints, 0);
  for (const WallTriangle& triangle : walls.Triangles)
  {
    for (const Index node : triangle.Nodes)
    {
      isOnWall[node] = 1;
    }
  }
  for (Index tet = 0; tet < mesh.NumberOfElements; ++tet)
  {
    Vector3 sum{};
    double total = 0.0;
    for (int c = 0; c < 4; ++c)
    {
      const Index node = mesh.Element(tet)[c];
      const double weight = isOnWall[node] ? 1.0 : 2.0;
      sum = sum + weight * mesh.PointAt(node);
      total += weight;
    }
    for (const double x : (1.0 / total) * sum)
    {
      points.push_back(x);
    }
  }
}

/// Makes the dual with given edges, also with points that no face has.
/// @param[in,out] edges  nodes of surfaces that cannot keep volumes otherwise become sharp
/// @return nothing if a node became sharp
std::optional<DualMesh> TryEdges(const DualTets& tets, const DualCells& cells,
  const SurfaceOfSide& surfaceOf, std::vector<NodeEdges>& edges)
{
  DualMesh dual;
  dual.Cells = cells;
  const DualWalls walls = FindDualWalls(tets, surfaceOf, edges, tets.Count());
  AddTetPoints(tets.Data(), walls, dual.Points);
  AddWallPoints(tets.Data(), walls, dual.Points);
  DualFaces faces;
  AddEdgeFaces(tets, cells, walls, faces);
  AddWallFaces(tets, cells, walls, faces);
  SetFaces(faces, dual);
  const std::vector<Index> refused = FitWalls(tets, walls, dual);
  for (const Index triangle : refused)
  {
    for (const Index node : walls.Triangles[triangle].Nodes)
    {
      edges[node] = NodeEdges::Sharp;
    }
  }
  return refused.empty() ? std::optional<DualMesh>(std::move(dual)) : std::nullopt;
}

/// Makes the dual in which surfaces keep volumes. Surfaces whose nodes are all sharp do.
DualMesh Build(const DualTets& tets, const DualCells& cells, const SurfaceOfSide& surfaceOf,
  std::vector<NodeEdges>& edges)
{
  std::optional<DualMesh> dual;
  while (!dual)
  {
    dual = TryEdges(tets, cells, surfaceOf, edges);
  }
  return std::move(*dual);
}

/// Makes the edges at the nodes of cells at poor faces round.
/// @return whether a node is new
bool RoundEdges(const DualMesh& dual, std::vector<NodeEdges>& edges)
{
  const CellMeasures cells = MeasureCells(dual);
  bool isAny = false;
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    for (const Index cell : { dual.Owners[face], dual.BehindFace(face) })
    {
      if (cell != NothingBehind && edges[dual.Cells.Nodes[cell]] == NodeEdges::ByAngle &&
        IsPoor(dual, cells, face))
      {
        edges[dual.Cells.Nodes[cell]] = NodeEdges::Round;
        isAny = true;
      }
    }
  }
  return isAny;
}

} // namespace

DualMesh MakeDualMesh(const MeshData& mesh, const SurfaceOfSide& surfaceOf)
{
  const DualTets tets(mesh);
  const DualCells cells = FindDualCells(tets);
  std::vector<NodeEdges> edges(mesh.NumberOfPoints, NodeEdges::ByAngle);
  DualMesh dual = Build(tets, cells, surfaceOf, edges);
  for (int round = 0; round < MostRounds && RoundEdges(dual, edges); ++round)
  {
    dual = Build(tets, cells, surfaceOf, edges);
  }
  DropUnused(dual);
  return dual;
}

} // namespace vfm
