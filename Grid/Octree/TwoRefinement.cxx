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

/// Points and hexes of all levels, before they are numbered by key.
struct Work
{
  const OctantFamilies& Sets;
  const IndexBox Box;
  const bool WithFinest;
  const OctreeKeys& Lattice = Sets.Lattice();
  std::vector<Point> Points{};
  std::vector<Hex> Hexes{};
  std::vector<Index> TouchedCells{};
  // Key of a node of the next level, and its anchor.
  std::vector<std::pair<Index, Index>> AnchorsOfChildren{};
};

/// Returns the points of a level's nodes. Points of refined cells are nodes of the next
/// level's lattice.
std::vector<Point> NamePoints(Work& work, int level, const PillowedLevel& mesh)
{
  std::vector<Point> points;
  for (const PillowedLevel::Node& node : mesh.Nodes)
  {
    const Index anchor = work.Lattice.NodeKey(level, node.Base, node.Slot);
    const bool isFree = node.Slot > 0 || LookAround(work.Sets, level, node.Base).AreTransitions;
    points.push_back({ node.Slot > 0 ? anchor : work.Lattice.LatticeKey(level, node.Base),
      isFree ? anchor : -1, node.Sides, work.Lattice.ToPoint(node.X), false });
  }
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    const Index3& cell = mesh.Cells[hex.Cell];
    if (!work.Sets.IsRefined(level, cell))
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
        LookAround(work.Sets, level, from.Base).HaveTransition)
      {
        work.AnchorsOfChildren.emplace_back(
          work.Lattice.LatticeKey(level + 1, node), point.FreeAnchor);
        point.HasAnchor = true;
      }
      point.Key = work.Lattice.LatticeKey(level + 1, node);
      point.FreeAnchor = -1;
      point.X = work.Lattice.NodePoint(level + 1, node); // exact, without accumulated rounding
    }
  }
  return points;
}

void AddPoint(
  Work& work, int point, const std::vector<Point>& points, std::vector<unsigned char>& isUsed)
{
  if (!isUsed[point])
  {
    isUsed[point] = 1;
    work.Points.push_back(points[point]);
  }
}

void AddHex(Work& work, Index key, bool isTransition, const PillowedLevel::Hex& hex,
  const std::vector<Point>& points, std::vector<unsigned char>& isUsed)
{
  Hex added{ key, {}, isTransition };
  for (int c = 0; c < 8; ++c)
  {
    added.PointKeys[VtkCorner[c]] = points[hex.Nodes[c]].Key;
    AddPoint(work, hex.Nodes[c], points, isUsed);
  }
  work.Hexes.push_back(added);
}

void AddLevel(Work& work, int level)
{
  const IndexBox box = ChangeLevel(work.Box, level);
  const PillowedLevel mesh = PillowSlabs(work.Sets, level, box);
  const std::vector<Point> points = NamePoints(work, level, mesh);
  std::vector<unsigned char> isUsed(points.size(), 0);
  const bool withChildren = work.WithFinest || level + 1 < work.Sets.NumberOfRefinements();
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    const Index3& cell = mesh.Cells[hex.Cell];
    if (!box.Contains(cell))
    {
      continue;
    }
    if (!work.Sets.IsRefined(level, cell))
    {
      AddHex(work, work.Lattice.HexKey(level, cell, hex.Slot), true, hex, points, isUsed);
      continue;
    }
    for (int c = 0; !withChildren && c < 8; ++c)
    {
      if (points[hex.Nodes[c]].HasAnchor)
      {
        AddPoint(work, hex.Nodes[c], points, isUsed);
      }
    }
    const Index3 child = ChildOfCell(cell, ChildOfHex(cell, hex.Slot));
    if (withChildren && !work.Sets.IsTouched(level + 1, child))
    {
      AddHex(work, work.Lattice.HexKey(level + 1, child, 0), false, hex, points, isUsed);
    }
  }
  for (std::size_t c = 0; level == 0 && c < mesh.Cells.size(); ++c)
  {
    if (box.Contains(mesh.Cells[c]))
    {
      work.TouchedCells.push_back(work.Lattice.Base().CellKey(mesh.Cells[c]));
    }
  }
}

Index FindAnchor(const Work& work, const Point& point)
{
  if (work.Lattice.NodeOfKey(point.Key).Slot > 0)
  {
    return point.Key;
  }
  const auto at = std::lower_bound(work.AnchorsOfChildren.begin(), work.AnchorsOfChildren.end(),
    std::make_pair(point.Key, Index(0)));
  return at != work.AnchorsOfChildren.end() && at->first == point.Key
    ? at->second
    : AnchorOfNode(work.Sets, point.Key);
}

RefinedMesh Finish(Work& work)
{
  const auto byKey = [](const auto& a, const auto& b) { return a.Key < b.Key; };
  std::sort(work.Points.begin(), work.Points.end(), byKey);
  std::sort(work.AnchorsOfChildren.begin(), work.AnchorsOfChildren.end());
  work.Points.erase(std::unique(work.Points.begin(), work.Points.end(),
                      [](const Point& a, const Point& b) { return a.Key == b.Key; }),
    work.Points.end());
  std::sort(work.Hexes.begin(), work.Hexes.end(), byKey);
  RefinedMesh mesh;
  mesh.TouchedCells = std::move(work.TouchedCells);
  mesh.Points.reserve(3 * work.Points.size());
  mesh.PointKeys.reserve(work.Points.size());
  mesh.Anchors.reserve(work.Points.size());
  mesh.DomainSides.reserve(work.Points.size());
  mesh.Hexes.reserve(8 * work.Hexes.size());
  mesh.HexKeys.reserve(work.Hexes.size());
  mesh.IsTransition.reserve(work.Hexes.size());
  for (const Point& point : work.Points)
  {
    if (point.FreeAnchor >= 0)
    {
      mesh.FreePoints.push_back({ static_cast<int>(mesh.PointKeys.size()), point.FreeAnchor });
    }
    mesh.Anchors.push_back(FindAnchor(work, point));
    mesh.PointKeys.push_back(point.Key);
    mesh.DomainSides.push_back(static_cast<unsigned char>(point.Sides));
    mesh.Points.insert(mesh.Points.end(), point.X.begin(), point.X.end());
  }
  std::sort(mesh.FreePoints.begin(), mesh.FreePoints.end(),
    [](const auto& a, const auto& b) { return a.Anchor < b.Anchor; });
  for (const Hex& hex : work.Hexes)
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
  Work work{ sets, box, withFinest };
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    AddLevel(work, level);
  }
  return Finish(work);
}

} // namespace vfm
