#include "Meshes/Polyhedra/DualMesh.h"

#include "Meshes/Polyhedra/ApartCells.h"
#include "Meshes/Polyhedra/DualMeasures.h"
#include "Meshes/Polyhedra/FitWalls.h"
#include "Meshes/Polyhedra/MoveTetPoints.h"

#include <optional>
#include <tuple>

namespace vfm
{
namespace
{

constexpr int MostRounds = 4; ///< of rounding edges
constexpr int MostSplits = 8; ///< rounds of splitting cells

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

/// What the faces are made from.
struct DualPieces
{
  const DualTets& Tets;
  const DualCells& Cells;
  const DualWalls& Walls;
  const std::vector<char>& IsApart; ///< of each corner, ApartCells.h
  const ApartPoints& Apart;

  Index CellAt(Index tet, Index node) const
  {
    return this->Cells.OfCorner[4 * tet + this->Tets.CornerAt(tet, node)];
  }
  bool IsApartAt(Index tet, Index node) const
  {
    return this->IsApart[4 * tet + this->Tets.CornerAt(tet, node)] != 0;
  }
};

/// Returns the points around an edge: of tetrahedra at odd places, of the sides before and behind
/// them at even ones; -1: left out.
std::vector<Index> PointsAround(const DualPieces& pieces, const EdgeArc& arc)
{
  const auto onWall = [&pieces](Index side)
  { return pieces.Walls.CentreOf(pieces.Walls.OfSide[side]); };
  const bool isOpen = arc.FirstSide >= 0;
  std::vector<Index> points{ isOpen ? onWall(arc.FirstSide)
                                    : pieces.Apart.CentreBetween(arc.Tets.back(), arc.Tets[0]) };
  for (std::size_t t = 0; t < arc.Tets.size(); ++t)
  {
    points.push_back(arc.Tets[t]);
    points.push_back(t + 1 < arc.Tets.size()
        ? pieces.Apart.CentreBetween(arc.Tets[t], arc.Tets[t + 1])
        : (isOpen ? onWall(arc.LastSide) : points[0]));
  }
  return points;
}

/// Adds the face around an edge, or one per tetrahedron if one of its cells is apart.
/// @param around  of PointsAround
void AddEdgeFace(const DualPieces& pieces, const EdgeArc& arc, Index from, Index to,
  const std::vector<Index>& around, DualFaces& faces)
{
  const EdgeIds edge = MakeEdgeIds(from, to);
  const auto add = [&](Index tet, const std::vector<Index>& polygon) {
    faces.Add(polygon, { { pieces.CellAt(tet, from), pieces.CellAt(tet, to) } }, { { -1, -1 } });
  };
  if (pieces.IsApartAt(arc.Tets[0], from) || pieces.IsApartAt(arc.Tets[0], to))
  {
    for (std::size_t t = 0; t < arc.Tets.size(); ++t)
    {
      const Index* part = around.data() + 2 * t;
      add(arc.Tets[t], { pieces.Apart.Middles.at(edge), part[0], part[1], part[2] });
    }
    return;
  }
  const bool isOpen = arc.FirstSide >= 0;
  std::vector<Index> polygon;
  std::copy_if(around.begin(), around.end() - (isOpen ? 0 : 1), std::back_inserter(polygon),
    [](Index point) { return point >= 0; });
  const Index middle = isOpen ? pieces.Walls.MiddleOf(pieces.Walls.OfSide[arc.LastSide], edge) : -1;
  if (middle >= 0)
  {
    polygon.push_back(middle);
  }
  add(arc.Tets[0], polygon);
}

/// Adds the faces around the edges of the tetrahedra.
void AddEdgeFaces(const DualPieces& pieces, DualFaces& faces)
{
  const DualTets& tets = pieces.Tets;
  std::vector<char> isDone(6 * tets.Count(), 0);
  for (Index place = 0; place < 6 * tets.Count(); ++place)
  {
    if (isDone[place])
    {
      continue;
    }
    const int edge = static_cast<int>(place % 6);
    const Index from = tets.Node(place / 6, CornersByEdge[edge][0]);
    const Index to = tets.Node(place / 6, CornersByEdge[edge][1]);
    const EdgeArc arc = FollowEdge(tets, place / 6, edge);
    for (const Index at : arc.Tets)
    {
      isDone[6 * at + EdgeBetween(tets.CornerAt(at, from), tets.CornerAt(at, to))] = 1;
    }
    AddEdgeFace(pieces, arc, from, to, PointsAround(pieces, arc), faces);
  }
}

/// Adds the faces between the parts of cells that are apart.
void AddApartFaces(const DualPieces& pieces, DualFaces& faces)
{
  for (const auto& [pair, centre] : pieces.Apart.Centres)
  {
    int side = 0;
    while (pieces.Tets.BehindSide(4 * pair[0] + side) != pair[1])
    {
      ++side;
    }
    const FaceIds nodes = PointsOfSide(pieces.Tets.Data(), { pair[0], side });
    for (int n = 0; n < 3; ++n)
    {
      const Index node = nodes[n], next = nodes[(n + 1) % 3], last = nodes[(n + 2) % 3];
      if (pieces.IsApartAt(pair[0], node))
      {
        const std::map<EdgeIds, Index>& middles = pieces.Apart.Middles;
        faces.Add({ middles.at(MakeEdgeIds(node, next)), centre,
                    middles.at(MakeEdgeIds(last, node)), pieces.Apart.Nodes.at(node) },
          { { pieces.CellAt(pair[0], node), pieces.CellAt(pair[1], node) } }, { { -1, -1 } });
      }
    }
  }
}

void AddWallFaces(const DualPieces& pieces, DualFaces& faces)
{
  const auto cellAt = [&pieces](Index side, Index node)
  { return side < 0 ? NothingBehind : pieces.CellAt(side / 4, node); };
  for (const WallPolygon& polygon : JoinWallParts(pieces.Walls))
  {
    const WallTriangle& triangle = pieces.Walls.Triangles[polygon.Triangle];
    faces.Add(polygon.Points,
      { { cellAt(triangle.Front, polygon.Node), cellAt(triangle.Back, polygon.Node) } },
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

/// Returns a point in each tetrahedron. Nodes that are on no wall draw it with double weight, which
/// makes the cells at walls thicker.
std::vector<double> PlaceTetPoints(const DualTets& tets)
{
  const MeshData& mesh = tets.Data();
  std::vector<char> isOnWall(mesh.NumberOfPoints, 0);
  for (Index side = 0; side < 4 * tets.Count(); ++side)
  {
    for (int c = 0; c < 4 && tets.IsWall(side); ++c)
    {
      isOnWall[tets.Node(side / 4, c)] |= SideByCorner[c] != side % 4;
    }
  }
  std::vector<double> points;
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
  return points;
}

/// What is done so that no cell has poor faces.
struct DualChoices
{
  std::vector<NodeEdges> Edges;  ///< of each node
  std::vector<char> IsApart;     ///< of each corner of the tetrahedra
  std::vector<double> TetPoints; ///< a point in each tetrahedron
};

/// Makes the dual with given edges, also with points that no face has.
/// @param[in,out] choices  nodes of surfaces that cannot keep volumes otherwise become sharp
/// @return nothing if a node became sharp
std::optional<DualMesh> TryEdges(
  const DualTets& tets, const SurfaceOfSide& surfaceOf, DualChoices& choices)
{
  DualMesh dual;
  dual.Cells = FindDualCells(tets, choices.IsApart);
  const DualWalls walls = FindDualWalls(tets, surfaceOf, choices.Edges, tets.Count());
  dual.Points = choices.TetPoints;
  AddWallPoints(tets.Data(), walls, dual.Points);
  const ApartPoints apart = AddApartPoints(tets, walls, choices.IsApart, dual.Points);
  const DualPieces pieces{ tets, dual.Cells, walls, choices.IsApart, apart };
  DualFaces faces;
  AddEdgeFaces(pieces, faces);
  AddApartFaces(pieces, faces);
  AddWallFaces(pieces, faces);
  SetFaces(faces, dual);
  const std::vector<Index> refused = FitWalls(tets, walls, dual);
  for (const Index triangle : refused)
  {
    for (const Index node : walls.Triangles[triangle].Nodes)
    {
      choices.Edges[node] = NodeEdges::Sharp;
    }
  }
  return refused.empty() ? std::optional<DualMesh>(std::move(dual)) : std::nullopt;
}

/// Makes the dual in which surfaces keep volumes. Surfaces whose nodes are all sharp do.
DualMesh Build(const DualTets& tets, const SurfaceOfSide& surfaceOf, DualChoices& choices)
{
  std::optional<DualMesh> dual;
  while (!dual)
  {
    dual = TryEdges(tets, surfaceOf, choices);
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

/// Moves the points of tetrahedra at poor faces.
void ImprovePoints(const DualTets& tets, DualChoices& choices, DualMesh& dual)
{
  MoveTetPoints(tets, dual);
  std::copy_n(dual.Points.begin(), choices.TetPoints.size(), choices.TetPoints.begin());
}

/// Returns the cells at rejected faces: those whose centre is behind one, else those on both sides.
std::vector<char> FindRejectedCells(const DualMesh& dual)
{
  const CellMeasures cells = MeasureCells(dual);
  std::vector<char> isRejected(dual.NumberOfCells(), 0);
  const auto isBehind = [&cells](Index face, Index cell, double sign)
  {
    const FaceMeasure& measure = cells.Faces[face];
    return sign * Dot(measure.Area, measure.Centre - cells.Centres[cell]) <= 0.0;
  };
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    if (!IsRejected(dual, cells, face))
    {
      continue;
    }
    const Index owner = dual.Owners[face], neighbour = dual.BehindFace(face);
    const bool hasNeighbour = neighbour != NothingBehind;
    const bool isOwner = isBehind(face, owner, 1.0);
    const bool isNeighbour = hasNeighbour && isBehind(face, neighbour, -1.0);
    if (isOwner || !isNeighbour)
    {
      isRejected[owner] = 1;
    }
    if (hasNeighbour && (isNeighbour || !isOwner))
    {
      isRejected[neighbour] = 1;
    }
  }
  return isRejected;
}

/// Splits the cells at rejected faces into the parts of their tetrahedra.
/// @return whether a corner is new
bool SplitCells(const DualMesh& dual, DualChoices& choices)
{
  const std::vector<char> isRejected = FindRejectedCells(dual);
  bool isAny = false;
  for (std::size_t corner = 0; corner < choices.IsApart.size(); ++corner)
  {
    const Index cell = dual.Cells.OfCorner[corner];
    if (isRejected[cell] && !choices.IsApart[corner])
    {
      choices.IsApart[corner] = 1;
      choices.Edges[dual.Cells.Nodes[cell]] = NodeEdges::Sharp;
      isAny = true;
    }
  }
  return isAny;
}

} // namespace

DualMesh MakeDualMesh(const MeshData& mesh, const SurfaceOfSide& surfaceOf)
{
  const DualTets tets(mesh);
  DualChoices choices{ std::vector<NodeEdges>(mesh.NumberOfPoints, NodeEdges::ByAngle),
    std::vector<char>(4 * mesh.NumberOfElements, 0), PlaceTetPoints(tets) };
  DualMesh dual = Build(tets, surfaceOf, choices);
  for (int round = 0; round < MostRounds && RoundEdges(dual, choices.Edges); ++round)
  {
    dual = Build(tets, surfaceOf, choices);
  }
  ImprovePoints(tets, choices, dual);
  for (int round = 0; round < MostSplits && SplitCells(dual, choices); ++round)
  {
    dual = Build(tets, surfaceOf, choices);
    ImprovePoints(tets, choices, dual);
  }
  DropUnused(dual);
  return dual;
}

} // namespace vfm
