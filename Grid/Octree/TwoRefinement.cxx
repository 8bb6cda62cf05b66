#include "Octree/TwoRefinement.h"

#include "Base/HexNumbering.h"
#include "Base/Sorted.h"
#include "Octree/SlabPillow.h"

namespace vfm
{
namespace
{

/// Properties of the cells of a level at a node.
struct CellsAround
{
  /// Whether all, or any, consist of transition hexes.
  bool AreTransitions, HaveTransition;
};

CellsAround LookAround(const OctantFamilies& sets, int level, const Index3& node)
{
  CellsAround around{ true, false };
  for (int c = 0; c < 8; ++c)
  {
    const Index3 cell = CellOfStar(node, c);
    if (sets.Lattice().HasCell(level, cell))
    {
      const bool isTransition = !sets.IsRefined(level, cell) && sets.IsTouched(level, cell);
      around.AreTransitions = around.AreTransitions && isTransition;
      around.HaveTransition = around.HaveTransition || isTransition;
    }
  }
  return around;
}

struct Point
{
  Index Key;
  Index FreeAnchor; // anchor of free points, otherwise -1
  int Sides;
  Vector3 X;
  bool HasAnchor; // whether AnchorsOfChildren has its key
};

struct Hex
{
  Index Key;
  std::array<Index, 8> PointKeys; // VTK order
  bool IsTransition;
};

/// Keys of nodes of the next level, and their anchors.
using ChildAnchors = std::vector<std::pair<Index, Index>>;

/// Points and hexes of all levels, before they are numbered by key.
struct UnsortedMesh
{
  std::vector<Point> Points;
  std::vector<Hex> Hexes;
  std::vector<Index> TouchedCells;
  ChildAnchors AnchorsOfChildren;
};

/// Returns the points of a level's nodes, and adds the anchors of nodes of the next level. Points
/// of refined cells are nodes of the next level's lattice.
std::vector<Point> NamePoints(
  const OctantFamilies& sets, int level, const PillowedLevel& mesh, ChildAnchors& anchors)
{
  const OctreeKeys& lattice = sets.Lattice();
  std::vector<Point> points;
  for (const PillowedLevel::Node& node : mesh.Nodes)
  {
    const Index anchor = lattice.NodeKey(level, node.Base, node.Slot);
    const bool isFree = node.Slot > 0 || LookAround(sets, level, node.Base).AreTransitions;
    points.push_back({ node.Slot > 0 ? anchor : lattice.LatticeKey(level, node.Base),
      isFree ? anchor : -1, node.Sides, lattice.ToPoint(node.X), false });
  }
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    const Index3& cell = mesh.Cells[hex.Cell];
    if (!sets.IsRefined(level, cell))
    {
      continue;
    }
    const Index3 child = ChildOfCell(cell, ChildOfHex(cell, hex.Slot));
    for (int c = 0; c < 8; ++c)
    {
      const Index3 node = CornerOfCell(child, c);
      const PillowedLevel::Node& from = mesh.Nodes[hex.Nodes[c]];
      Point& point = points[hex.Nodes[c]];
      if (from.Slot > 0 && point.FreeAnchor >= 0 &&
        LookAround(sets, level, from.Base).HaveTransition)
      {
        anchors.emplace_back(lattice.LatticeKey(level + 1, node), point.FreeAnchor);
        point.HasAnchor = true;
      }
      point.Key = lattice.LatticeKey(level + 1, node);
      point.FreeAnchor = -1;
      point.X = lattice.NodePoint(level + 1, node); // exact, without accumulated rounding
    }
  }
  return points;
}

/// Points of a level, and which of them have been added.
struct LevelPoints
{
  std::vector<Point> Points;
  std::vector<unsigned char> IsUsed = std::vector<unsigned char>(Points.size(), 0);

  void AddTo(std::vector<Point>& points, int point)
  {
    if (!this->IsUsed[point])
    {
      this->IsUsed[point] = 1;
      points.push_back(this->Points[point]);
    }
  }
};

void AddHex(Hex added, const std::array<int, 8>& nodes, LevelPoints& level, UnsortedMesh& made)
{
  for (int c = 0; c < 8; ++c)
  {
    added.PointKeys[VtkCorner[c]] = level.Points[nodes[c]].Key;
    level.AddTo(made.Points, nodes[c]);
  }
  made.Hexes.push_back(added);
}

/// Adds the points of a hex that have an anchor.
void AddAnchored(const std::array<int, 8>& nodes, LevelPoints& level, std::vector<Point>& points)
{
  for (int node : nodes)
  {
    if (level.Points[node].HasAnchor)
    {
      level.AddTo(points, node);
    }
  }
}

/// Adds the points and hexes of a level.
/// @param box  cells of the level whose hexes are added
/// @param withChildren  whether hexes of the next level are added too
void AddLevel(
  const OctantFamilies& sets, int level, const IndexBox& box, bool withChildren, UnsortedMesh& made)
{
  const OctreeKeys& lattice = sets.Lattice();
  const PillowedLevel mesh = PillowSlabs(sets, level, box);
  LevelPoints points{ NamePoints(sets, level, mesh, made.AnchorsOfChildren) };
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    const Index3& cell = mesh.Cells[hex.Cell];
    if (!box.Contains(cell))
    {
      continue;
    }
    if (!sets.IsRefined(level, cell))
    {
      AddHex({ lattice.HexKey(level, cell, hex.Slot), {}, true }, hex.Nodes, points, made);
      continue;
    }
    if (!withChildren)
    {
      AddAnchored(hex.Nodes, points, made.Points);
      continue;
    }
    const Index3 child = ChildOfCell(cell, ChildOfHex(cell, hex.Slot));
    if (!sets.IsTouched(level + 1, child))
    {
      AddHex({ lattice.HexKey(level + 1, child, 0), {}, false }, hex.Nodes, points, made);
    }
  }
  for (std::size_t c = 0; level == 0 && c < mesh.Cells.size(); ++c)
  {
    if (box.Contains(mesh.Cells[c]))
    {
      made.TouchedCells.push_back(lattice.Base().CellKey(mesh.Cells[c]));
    }
  }
}

/// @param children  ascending
Index FindAnchor(const OctantFamilies& sets, const ChildAnchors& children, const Point& point)
{
  if (sets.Lattice().NodeOfKey(point.Key).Slot > 0)
  {
    return point.Key;
  }
  const auto at =
    std::lower_bound(children.begin(), children.end(), std::make_pair(point.Key, Index(0)));
  return at != children.end() && at->first == point.Key ? at->second
                                                        : AnchorOfNode(sets, point.Key);
}

/// Sorts points, each once, hexes and anchors by key.
void Sort(UnsortedMesh& made)
{
  const auto byKey = [](const auto& a, const auto& b) { return a.Key < b.Key; };
  std::sort(made.Points.begin(), made.Points.end(), byKey);
  std::sort(made.AnchorsOfChildren.begin(), made.AnchorsOfChildren.end());
  made.Points.erase(std::unique(made.Points.begin(), made.Points.end(),
                      [](const Point& a, const Point& b) { return a.Key == b.Key; }),
    made.Points.end());
  std::sort(made.Hexes.begin(), made.Hexes.end(), byKey);
}

RefinedMesh Finish(const OctantFamilies& sets, UnsortedMesh made)
{
  Sort(made);
  RefinedMesh mesh;
  mesh.TouchedCells = std::move(made.TouchedCells);
  mesh.Points.reserve(3 * made.Points.size());
  mesh.PointKeys.reserve(made.Points.size());
  mesh.Anchors.reserve(made.Points.size());
  mesh.DomainSides.reserve(made.Points.size());
  mesh.Hexes.reserve(8 * made.Hexes.size());
  mesh.HexKeys.reserve(made.Hexes.size());
  mesh.IsTransition.reserve(made.Hexes.size());
  for (const Point& point : made.Points)
  {
    if (point.FreeAnchor >= 0)
    {
      mesh.FreePoints.push_back({ static_cast<int>(mesh.PointKeys.size()), point.FreeAnchor });
    }
    mesh.Anchors.push_back(FindAnchor(sets, made.AnchorsOfChildren, point));
    mesh.PointKeys.push_back(point.Key);
    mesh.DomainSides.push_back(static_cast<unsigned char>(point.Sides));
    mesh.Points.insert(mesh.Points.end(), point.X.begin(), point.X.end());
  }
  std::sort(mesh.FreePoints.begin(), mesh.FreePoints.end(),
    [](const auto& a, const auto& b) { return a.Anchor < b.Anchor; });
  for (const Hex& hex : made.Hexes)
  {
    mesh.HexKeys.push_back(hex.Key);
    mesh.IsTransition.push_back(hex.IsTransition);
    for (Index key : hex.PointKeys)
    {
      mesh.Hexes.push_back(FindSorted(mesh.PointKeys, key));
    }
  }
  return mesh;
}

} // namespace

Index AnchorOfNode(const OctantFamilies& sets, Index key)
{
  const OctreeKeys::LevelIndex node = sets.Lattice().NodeOfKey(key);
  for (int level = node.Level; level < sets.NumberOfRefinements(); ++level)
  {
    const int shift = level - node.Level;
    const Index3 at{ { node.At[0] << shift, node.At[1] << shift, node.At[2] << shift } };
    if (LookAround(sets, level, at).HaveTransition)
    {
      return sets.Lattice().NodeKey(level, at, 0);
    }
  }
  return -1;
}

Index AnchorOfPoint(const OctantFamilies& sets, const RefinedMesh& mesh, Index key)
{
  const Index point = FindSorted(mesh.PointKeys, key);
  return point < 0 ? AnchorOfNode(sets, key) : mesh.Anchors[point];
}

RefinedMesh MakeRefinedMesh(const OctantFamilies& sets, const IndexBox& box, bool withFinest)
{
  UnsortedMesh made;
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    const bool withChildren = withFinest || level + 1 < sets.NumberOfRefinements();
    AddLevel(sets, level, ChangeLevel(box, level), withChildren, made);
  }
  return Finish(sets, std::move(made));
}

} // namespace vfm
