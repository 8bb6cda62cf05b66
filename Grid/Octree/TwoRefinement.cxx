#include "Octree/TwoRefinement.h"

#include "Base/HexNumbering.h"
#include "Base/Sorted.h"
#include "Octree/SlabPillow.h"

namespace vfm
{
namespace
{

/// The cells of a level at a node.
struct CellsAround
{
  bool AreTransitions, HaveTransition; ///< whether all, or any, consist of transition hexes
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

/// Collects points and hexes of all levels, then numbers them by key.
class RefinedMeshBuilder
{
public:
  RefinedMeshBuilder(const OctantFamilies& sets, const IndexBox& box, bool withFinest) :
    Sets(sets), Lattice(sets.Lattice()), Box(box), WithFinest(withFinest)
  {
  }

  void AddLevel(int level);
  RefinedMesh Finish();

private:
  struct Point
  {
    Index Key;
    Index FreeAnchor; // of free points, else -1
    int Sides;
    Vector3 X;
    bool HasAnchor; // among AnchorsOfChildren
  };
  struct Hex
  {
    Index Key;
    std::array<Index, 8> PointKeys; // VTK order
    bool IsTransition;
  };

  std::vector<Point> NamePoints(int level, const PillowedLevel& mesh);
  Index FindAnchor(const Point& point) const;
  void AddPoint(int point, const std::vector<Point>& points, std::vector<unsigned char>& isUsed);
  void AddHex(Index key, bool isTransition, const PillowedLevel::Hex& hex,
    const std::vector<Point>& points, std::vector<unsigned char>& isUsed);

  const OctantFamilies& Sets;
  const OctreeKeys& Lattice;
  IndexBox Box;
  bool WithFinest;
  std::vector<Point> Points;
  std::vector<Hex> Hexes;
  std::vector<Index> TouchedCells;
  std::vector<std::pair<Index, Index>> AnchorsOfChildren; // key of a node of the next level, anchor
};

/// The points of a level's nodes. Those of refined cells are nodes of the next level's lattice.
std::vector<RefinedMeshBuilder::Point> RefinedMeshBuilder::NamePoints(
  int level, const PillowedLevel& mesh)
{
  std::vector<Point> points;
  for (const PillowedLevel::Node& node : mesh.Nodes)
  {
    const Index anchor = this->Lattice.NodeKey(level, node.Base, node.Slot);
    const bool isFree = node.Slot > 0 || LookAround(this->Sets, level, node.Base).AreTransitions;
    points.push_back({ node.Slot > 0 ? anchor : this->Lattice.LatticeKey(level, node.Base),
      isFree ? anchor : -1, node.Sides, this->Lattice.ToPoint(node.X), false });
  }
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    const Index3& cell = mesh.Cells[hex.Cell];
    if (!this->Sets.IsRefined(level, cell))
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
        LookAround(this->Sets, level, from.Base).HaveTransition)
      {
        this->AnchorsOfChildren.emplace_back(
          this->Lattice.LatticeKey(level + 1, node), point.FreeAnchor);
        point.HasAnchor = true;
      }
      point.Key = this->Lattice.LatticeKey(level + 1, node);
      point.FreeAnchor = -1;
      point.X = this->Lattice.NodePoint(level + 1, node); // halves, without rounding on the way
    }
  }
  return points;
}

void RefinedMeshBuilder::AddPoint(
  int point, const std::vector<Point>& points, std::vector<unsigned char>& isUsed)
{
  if (!isUsed[point])
  {
    isUsed[point] = 1;
    this->Points.push_back(points[point]);
  }
}

void RefinedMeshBuilder::AddHex(Index key, bool isTransition, const PillowedLevel::Hex& hex,
  const std::vector<Point>& points, std::vector<unsigned char>& isUsed)
{
  Hex added{ key, {}, isTransition };
  for (int c = 0; c < 8; ++c)
  {
    added.PointKeys[VtkCorner[c]] = points[hex.Nodes[c]].Key;
    this->AddPoint(hex.Nodes[c], points, isUsed);
  }
  this->Hexes.push_back(added);
}

void RefinedMeshBuilder::AddLevel(int level)
{
  const IndexBox box = ChangeLevel(this->Box, level);
  const PillowedLevel mesh = PillowSlabs(this->Sets, level, box);
  const std::vector<Point> points = this->NamePoints(level, mesh);
  std::vector<unsigned char> isUsed(points.size(), 0);
  const bool withChildren = this->WithFinest || level + 1 < this->Sets.NumberOfRefinements();
  for (const PillowedLevel::Hex& hex : mesh.Hexes)
  {
    const Index3& cell = mesh.Cells[hex.Cell];
    if (!box.Contains(cell))
    {
      continue;
    }
    if (!this->Sets.IsRefined(level, cell))
    {
      this->AddHex(this->Lattice.HexKey(level, cell, hex.Slot), true, hex, points, isUsed);
      continue;
    }
    for (int c = 0; !withChildren && c < 8; ++c)
    {
      if (points[hex.Nodes[c]].HasAnchor)
      {
        this->AddPoint(hex.Nodes[c], points, isUsed);
      }
    }
    const Index3 child = ChildOfCell(cell, ChildOfHex(cell, hex.Slot));
    if (withChildren && !this->Sets.IsTouched(level + 1, child))
    {
      this->AddHex(this->Lattice.HexKey(level + 1, child, 0), false, hex, points, isUsed);
    }
  }
  for (std::size_t c = 0; level == 0 && c < mesh.Cells.size(); ++c)
  {
    if (box.Contains(mesh.Cells[c]))
    {
      this->TouchedCells.push_back(this->Lattice.Base().CellKey(mesh.Cells[c]));
    }
  }
}

Index RefinedMeshBuilder::FindAnchor(const Point& point) const
{
  if (this->Lattice.NodeOfKey(point.Key).Slot > 0)
  {
    return point.Key;
  }
  const auto at = std::lower_bound(this->AnchorsOfChildren.begin(), this->AnchorsOfChildren.end(),
    std::make_pair(point.Key, Index(0)));
  return at != this->AnchorsOfChildren.end() && at->first == point.Key
    ? at->second
    : AnchorOfNode(this->Sets, point.Key);
}

RefinedMesh RefinedMeshBuilder::Finish()
{
  const auto byKey = [](const auto& a, const auto& b) { return a.Key < b.Key; };
  std::sort(this->Points.begin(), this->Points.end(), byKey);
  std::sort(this->AnchorsOfChildren.begin(), this->AnchorsOfChildren.end());
  this->Points.erase(std::unique(this->Points.begin(), this->Points.end(),
                       [](const Point& a, const Point& b) { return a.Key == b.Key; }),
    this->Points.end());
  std::sort(this->Hexes.begin(), this->Hexes.end(), byKey);
  RefinedMesh mesh;
  mesh.TouchedCells = std::move(this->TouchedCells);
  mesh.Points.reserve(3 * this->Points.size());
  mesh.PointKeys.reserve(this->Points.size());
  mesh.Anchors.reserve(this->Points.size());
  mesh.DomainSides.reserve(this->Points.size());
  mesh.Hexes.reserve(8 * this->Hexes.size());
  mesh.HexKeys.reserve(this->Hexes.size());
  mesh.IsTransition.reserve(this->Hexes.size());
  for (const Point& point : this->Points)
  {
    if (point.FreeAnchor >= 0)
    {
      mesh.FreePoints.push_back({ static_cast<int>(mesh.PointKeys.size()), point.FreeAnchor });
    }
    mesh.Anchors.push_back(this->FindAnchor(point));
    mesh.PointKeys.push_back(point.Key);
    mesh.DomainSides.push_back(static_cast<unsigned char>(point.Sides));
    mesh.Points.insert(mesh.Points.end(), point.X.begin(), point.X.end());
  }
  std::sort(mesh.FreePoints.begin(), mesh.FreePoints.end(),
    [](const auto& a, const auto& b) { return a.Anchor < b.Anchor; });
  for (const Hex& hex : this->Hexes)
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
  RefinedMeshBuilder builder(sets, box, withFinest);
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    builder.AddLevel(level);
  }
  return builder.Finish();
}

} // namespace vfm
