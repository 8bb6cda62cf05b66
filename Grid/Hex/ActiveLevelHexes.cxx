#include "Hex/ActiveLevelHexes.h"

#include "Hex/TransitionSmoothing.h"
#include "Smoothing/ActiveMeshBuilder.h"

namespace vfm
{
namespace
{

constexpr Index Rings = 2; // cells around interfaces whose points move

/// Which nodes of a level lie near interfaces.
class NodesNear
{
public:
  /// mixed: nodes of the finest grid; shift: halvings from the level to it; rings: cells of the level.
  NodesNear(const CartesianGrid& finest, const std::vector<Index>& mixed, int shift, Index rings)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Box.Lower[a] = finest.Local().Lower[a] >> shift;
      this->Box.Upper[a] = (finest.Local().Upper[a] >> shift) + 1;
    }
    this->Marked.assign(this->Box.NumberOfCells(), false);
    std::vector<bool> seen(this->Marked.size(), false);
    for (Index node : mixed)
    {
      const Index3 p = finest.Position(node);
      const Index3 q{ { p[0] >> shift, p[1] >> shift, p[2] >> shift } };
      const Index at = IndexInBox(this->Box, q);
      if (!seen[at])
      {
        seen[at] = true;
        const IndexBox around{ { { q[0] - rings, q[1] - rings, q[2] - rings } },
          { { q[0] + rings + 1, q[1] + rings + 1, q[2] + rings + 1 } } };
        ForCells(Intersect(around, this->Box),
          [&](const Index3& near) { this->Marked[IndexInBox(this->Box, near)] = true; });
      }
    }
  }
  bool Has(const Index3& node) const
  {
    return this->Box.Contains(node) && this->Marked[IndexInBox(this->Box, node)];
  }

private:
  IndexBox Box; // of nodes
  std::vector<bool> Marked;
};

class ActiveLevelBuilder
{
public:
  ActiveLevelBuilder(const LevelInterfaces& interfaces, const CoarseHexes& coarse,
    const LabelArray& labels, const std::vector<Index>& mixed, const PointNumbering& numbering,
    const Fragments& fragments, const Partition& partition, const Mesh& mesh) :
    Interfaces(interfaces),
    Coarse(coarse),
    Levels(coarse.Levels()),
    Finest(coarse.Levels().Finest()),
    Labels(labels),
    Mixed(mixed),
    Numbering(numbering),
    Pieces(fragments),
    Parts(partition),
    Input(mesh),
    Around(this->Finest, mixed, this->Levels.NumberOfRefinements(), Rings + 1)
  {
    for (int level = 0; level <= this->Levels.NumberOfRefinements(); ++level)
    {
      this->Near.emplace_back(
        this->Finest, mixed, this->Levels.NumberOfRefinements() - level, Rings);
    }
  }

  ActiveMesh Build()
  {
    ActiveMeshBuilder builder(8, this->Input.PointIds.size(), this->FindMovers());
    const std::vector<Index> hexes = builder.AddAround(this->Input);
    this->Result = builder.Finish(&this->Parts, 8 * (this->Levels.NumberOfRefinements() + 1));
    this->Result.Widths = WidthsOfHexes(this->Levels, this->Input, hexes);
    this->Result.PlacePoints(this->Finest, this->Input);
    this->AddFineFaces();
    this->AddCoarseFaces();
    this->SetAttachments();
    return std::move(this->Result);
  }

private:
  /// The target of a pair of labels at an active point.
  struct Drawn
  {
    int Point;
    Attachment To;
  };
  using Anchor = OctreeKeys::LevelIndex;

  Anchor FindNode(Index id) const;
  bool IsFineAround(const Index3& node) const;
  std::vector<Mover> FindMovers() const;
  void AddFineFaces();
  void AddCoarseFaces();
  void AddFace(const std::array<Index, 4>& meshPoints, const std::array<int, 2>& labels,
    const std::array<int, 2>& fragments, bool counts);
  void Draw(Index meshPoint, int point, const std::array<int, 2>& labels,
    const std::array<int, 2>& fragments);
  void SetAttachments();

  const LevelInterfaces& Interfaces;
  const CoarseHexes& Coarse;
  const RefinedGrid& Levels;
  const CartesianGrid& Finest;
  const LabelArray& Labels;
  const std::vector<Index>& Mixed;
  const PointNumbering& Numbering;
  const Fragments& Pieces;
  const Partition& Parts;
  const Mesh& Input;
  const NodesNear Around;      // base nodes beyond which nothing is active
  std::vector<NodesNear> Near; // of each level
  std::vector<Drawn> Attached;
  ActiveMesh Result;
};

/// The node that a point moves with.
OctreeKeys::LevelIndex ActiveLevelBuilder::FindNode(Index id) const
{
  const OctreeKeys& lattice = this->Levels.Lattice();
  const bool isCoarse = this->Levels.IsCoarsePoint(id, this->Input.Ids.PointSlots);
  const Anchor finest{ this->Levels.NumberOfRefinements(),
    NodeOfPoint(this->Finest, this->Input, id), 0 };
  if (!isCoarse && this->IsFineAround(finest.At))
  {
    return finest;
  }
  const Index key = this->Levels.KeyOfPoint(id, this->Input.Ids.PointSlots);
  const Index anchor = AnchorOfPoint(this->Levels.Families(), this->Coarse.Refined(), key);
  if (anchor >= 0)
  {
    return lattice.NodeOfKey(anchor);
  }
  return isCoarse ? lattice.NodeOfKey(key) : finest;
}

/// Whether all cells at a node are finest ones.
bool ActiveLevelBuilder::IsFineAround(const Index3& node) const
{
  for (int c = 0; c < 8; ++c)
  {
    if (!this->Levels.IsFine(CornerOfCell({ { node[0] - 1, node[1] - 1, node[2] - 1 } }, c)))
    {
      return false;
    }
  }
  return true;
}

std::vector<Mover> ActiveLevelBuilder::FindMovers() const
{
  const int shift = this->Levels.NumberOfRefinements();
  std::vector<Mover> movers;
  for (std::size_t p = 0; p < this->Input.PointIds.size(); ++p)
  {
    const Index id = this->Input.PointIds[p];
    const Index3 own = NodeOfPoint(this->Finest, this->Input, id);
    if (!this->Around.Has({ { own[0] >> shift, own[1] >> shift, own[2] >> shift } }))
    {
      continue;
    }
    const Anchor node = this->FindNode(id);
    if (this->Near[node.Level].Has(node.At))
    {
      movers.push_back(
        { static_cast<Index>(p), id, this->Levels.Lattice().NodeKey(node.Level, node.At, 0),
          this->Levels.FinestNode(node.Level, node.At), ColourOfNode(node) });
    }
  }
  return movers;
}

/// Draws a surface point to the target of the pair at its node, once.
void ActiveLevelBuilder::Draw(
  Index meshPoint, int point, const std::array<int, 2>& labels, const std::array<int, 2>& fragments)
{
  const Index id = this->Input.PointIds[meshPoint];
  const int refinements = this->Levels.NumberOfRefinements();
  Index target = -1;
  if (!this->Levels.IsCoarsePoint(id, this->Input.Ids.PointSlots))
  {
    target = this->Interfaces.FindTarget(
      refinements, NodeOfPoint(this->Finest, this->Input, id), labels[0], labels[1]);
  }
  if (target < 0)
  {
    const Anchor node = this->FindNode(id);
    target = this->Interfaces.FindTarget(node.Level, node.At, labels[0], labels[1]);
  }
  if (target >= 0)
  {
    Drawn drawn{ point, { target } };
    drawn.To.Fragments = fragments;
    this->Attached.push_back(drawn);
  }
}

/// labels, fragments: of the smaller label first; the normal points to it.
void ActiveLevelBuilder::AddFace(const std::array<Index, 4>& meshPoints,
  const std::array<int, 2>& labels, const std::array<int, 2>& fragments, bool counts)
{
  InterfaceFacet facet{ {}, fragments[1], fragments[0], counts };
  bool isComplete = true;
  for (int c = 0; c < 4; ++c)
  {
    const int point = meshPoints[c] < 0 ? -1 : this->Result.PointOf[meshPoints[c]];
    facet.Points[c] = point;
    isComplete = isComplete && point >= 0;
    if (point >= 0 && this->Result.IsActive[point])
    {
      this->Draw(meshPoints[c], point, labels, fragments);
    }
  }
  if (isComplete)
  {
    this->Result.Facets.push_back(facet);
  }
}

/// Faces of finest cells.
void ActiveLevelBuilder::AddFineFaces()
{
  const IndexBox box = this->Finest.HexBox();
  for (Index node : this->Mixed)
  {
    const Index3 upper = this->Finest.Position(node);
    for (int axis = 0; axis < 3; ++axis)
    {
      Index3 lower = upper;
      --lower[axis];
      const int below = this->Labels[node - this->Finest.Stride(axis)], above = this->Labels[node];
      if (below == above || !box.Contains(upper) || !box.Contains(lower) ||
        (!this->Levels.IsFine(lower) && !this->Levels.IsFine(upper)))
      {
        continue;
      }
      const Index b = this->Finest.Stride((axis + 1) % 3), c = this->Finest.Stride((axis + 2) % 3);
      std::array<Index, 4> points;
      int at = 0;
      for (Index corner : { node, node + b, node + b + c, node + c })
      {
        points[at++] = this->Numbering.FirstPoint(corner);
      }
      const bool isUp = below > above; // the normal
      if (!isUp)
      {
        std::swap(points[1], points[3]);
      }
      this->AddFace(points, { { std::min(below, above), std::max(below, above) } },
        { { this->Pieces.FragmentOfCell(isUp ? upper : lower),
          this->Pieces.FragmentOfCell(isUp ? lower : upper) } },
        this->Parts.OwnsCell(upper));
    }
  }
}

/// Faces of which no side is a finest cell.
void ActiveLevelBuilder::AddCoarseFaces()
{
  for (const SplitNodes::Face& face : this->Coarse.Splits()->Faces())
  {
    std::array<int, 2> labels, fragments;
    bool isCoarse = true;
    for (int side = 0; side < 2; ++side)
    {
      const Anchor& leaf = face.Sides[side].Cell;
      const Index3 cell = this->Levels.NearestCell(leaf.Level, leaf.At);
      isCoarse = isCoarse && leaf.Level < this->Levels.NumberOfRefinements();
      labels[side] = face.Sides[side].Label;
      fragments[side] =
        this->Finest.HexBox().Contains(cell) ? this->Pieces.FragmentOfCell(cell) : 0;
    }
    if (!isCoarse)
    {
      continue;
    }
    std::array<Index, 4> points;
    for (int c = 0; c < 4; ++c)
    {
      points[c] = this->Coarse.SplitPoints()[face.Nodes[(4 - c) % 4]];
    }
    const Anchor& first = face.Sides[0].Cell;
    this->AddFace(points, labels, fragments,
      this->Parts.OwnsCell(this->Levels.FinestNode(first.Level, first.At)));
  }
}

void ActiveLevelBuilder::SetAttachments()
{
  const auto before = [](const Drawn& a, const Drawn& b)
  { return a.Point != b.Point ? a.Point < b.Point : a.To.Target < b.To.Target; };
  std::stable_sort(this->Attached.begin(), this->Attached.end(), before);
  ActiveMesh& active = this->Result;
  auto next = this->Attached.begin();
  for (int point = 0; point < static_cast<int>(active.X.size()); ++point)
  {
    for (; next != this->Attached.end() && next->Point == point; ++next)
    {
      const bool isNew =
        active.AttachmentOffset[point] == static_cast<Index>(active.Attachments.size()) ||
        active.Attachments.back().Target != next->To.Target;
      if (isNew)
      {
        active.Attachments.push_back(next->To);
      }
      else if (active.Attachments.back().Fragments == std::array<int, 2>{})
      {
        active.Attachments.back().Fragments = next->To.Fragments;
      }
    }
    active.AttachmentOffset[point + 1] = static_cast<Index>(active.Attachments.size());
  }
}

} // namespace

ActiveMesh MakeActiveLevelHexes(const LevelInterfaces& interfaces, const CoarseHexes& coarse,
  const LabelArray& labels, const std::vector<Index>& mixed, const PointNumbering& numbering,
  const Fragments& fragments, const Partition& partition, const Mesh& mesh)
{
  return ActiveLevelBuilder(
    interfaces, coarse, labels, mixed, numbering, fragments, partition, mesh)
    .Build();
}

} // namespace vfm
