#include "Elements/Hex/SplitNodes.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Elements/Hex/HexCoefficients.h"
#include "Elements/Hex/HexTopology.h"
#include "Elements/Hex/VisibleDirection.h"
#include "Labels/LabelCondition.h"

namespace vfm
{
namespace
{

constexpr double SmallestMargin = 0.1; // smallest margin of a visible direction
constexpr double ThinnestMargin = 0.3; // margin below which the buffer layer starts thinner
constexpr double SmallestDeterminant =
  1e-4; // smallest determinant of initial hexes, in cell volumes

} // namespace

Index SplitNodes::Find(Index key) const
{
  return FindSorted(this->Keys, key);
}

int SplitNodes::RankOf(Index n, int label) const
{
  return static_cast<int>(
    std::find(this->LabelsBegin(n), this->LabelsEnd(n), label) - this->LabelsBegin(n));
}

int SplitNodes::FacesOfHex(Index hexKey) const
{
  const auto at =
    std::lower_bound(this->HexFaces.begin(), this->HexFaces.end(), std::make_pair(hexKey, 0));
  return at != this->HexFaces.end() && at->first == hexKey ? at->second : 0;
}

namespace
{

using Kind = HexStars::Kind;

using Hex = HexStars::Hex;

using Corner = HexStars::Corner;

using Star = HexStars::Star;

using LabelNormal = std::pair<int, Vector3>; // label, normal out of it

/// Face of a hex at a node: keys of the far ends of its two edges there and of the opposite corner,
/// and the hex.
struct FaceAt
{
  std::array<Index, 3> Keys;
  const Corner* From;
  int Axis;
};

struct Work
{
  const RefinedGrid& Grid;
  const OctreeKeys& Lattice;
  const HexStars& Stars;
  const LabelArray& Labels;
  const std::function<bool(const OctreeKeys::LevelIndex&)>& HasHexes;
  SplitNodes& Result;
};

const Hex& HexOf(const Work& work, const Corner& at)
{
  return work.Stars.Hexes()[at.Hex];
}

/// Lists the faces at a node by key. A face that two hexes share is listed twice in sequence.
std::vector<FaceAt> ListFaces(const Work& work, const Star& star)
{
  std::vector<FaceAt> faces;
  for (const Corner& at : star)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3;
      const Hex& hex = HexOf(work, at);
      const auto ends =
        std::minmax({ work.Stars.KeyAt(hex, at.Bits ^ b), work.Stars.KeyAt(hex, at.Bits ^ c) });
      faces.push_back(
        { { { ends.first, ends.second, work.Stars.KeyAt(hex, at.Bits ^ b ^ c) } }, &at, axis });
    }
  }
  std::stable_sort(
    faces.begin(), faces.end(), [](const FaceAt& a, const FaceAt& b) { return a.Keys < b.Keys; });
  return faces;
}

/// Adds a face when it is visited at its node with the smallest key.
void AddFace(Work& work, const FaceAt& a, const FaceAt& b)
{
  const Hex& hexA = HexOf(work, *a.From);
  const Hex& hexB = HexOf(work, *b.From);
  const int corner = a.From->Bits;
  std::array<Index, 4> keys{ { work.Stars.KeyAt(hexA, corner),
    work.Stars.KeyAt(hexA, corner ^ (1 << (a.Axis + 1) % 3)), a.Keys[2],
    work.Stars.KeyAt(hexA, corner ^ (1 << (a.Axis + 2) % 3)) } };
  if (*std::min_element(keys.begin(), keys.end()) != keys[0])
  {
    return;
  }
  for (const FaceAt* face : { &a, &b })
  {
    const Hex& hex = HexOf(work, *face->From);
    const int bit = 1 << (2 * face->Axis + (face->From->Bits >> face->Axis & 1));
    if (hex.What != Kind::Fine)
    {
      work.Result.HexFaces.emplace_back(hex.Side.HexKey, bit);
    }
  }
  if (hexA.What == Kind::Fine && hexB.What == Kind::Fine)
  {
    return;
  }
  const bool isFirst = hexA.Side.Label < hexB.Side.Label;
  // at a corner with an even number of bits, the normal by this order points into A
  if (((0x69 >> corner & 1) != 0) == isFirst)
  {
    std::swap(keys[1], keys[3]);
  }
  SplitNodes::Face face;
  for (int c = 0; c < 4; ++c)
  {
    face.Nodes[c] = work.Result.Find(keys[c]);
    if (face.Nodes[c] < 0)
    {
      return; // at the rim of the region
    }
  }
  face.Sides = { { isFirst ? hexA.Side : hexB.Side, isFirst ? hexB.Side : hexA.Side } };
  work.Result.Faces.push_back(face);
}

/// Returns the labels at a node, ascending.
std::vector<int> ListLabels(const Work& work, const Star& star)
{
  std::vector<int> labels;
  for (const Corner& at : star)
  {
    labels.push_back(HexOf(work, at).Side.Label);
  }
  SortUnique(labels);
  return labels;
}

/// Returns the direction out of a label at a node. It is tangential to these sides.
VisibleDirection FindOutward(int label, int sides, const std::vector<LabelNormal>& normals)
{
  std::vector<Vector3> own;
  for (const LabelNormal& normal : normals)
  {
    Vector3 v = normal.second;
    for (int a = 0; a < 3; ++a)
    {
      v[a] = sides >> (2 * a) & 3 ? 0.0 : v[a];
    }
    if (normal.first == label && Norm(v) > 0.0)
    {
      own.push_back(Unit(v));
    }
  }
  return own.empty() ? VisibleDirection{ {}, -1.0 } : FindVisibleDirection(own);
}

/// Returns whether a node of finest cells has these labels in the lattice, by which finest cells
/// number the inner points. True for all other nodes.
bool HasLatticeLabels(const Work& work, Index n, const std::vector<int>& labels)
{
  const CartesianGrid& finest = work.Grid.Finest();
  const OctreeKeys::LevelIndex node = work.Lattice.NodeOfKey(work.Result.Keys[n]);
  const Index3 p = work.Grid.FinestNode(node.Level, node.At);
  if (node.Slot != 0 || !finest.Local().Touches(p) || !work.Grid.TouchesFine(p))
  {
    return true;
  }
  const StarLabels lattice(StarOfNode(finest, work.Labels, finest.Linear(p)));
  return std::equal(labels.begin(), labels.end(), lattice.begin(), lattice.end());
}

/// Requests refinement of the coarser cells of a star.
void RequestFiner(Work& work, const Star& star)
{
  for (const Corner& at : star)
  {
    const OctreeKeys::LevelIndex& cell = HexOf(work, at).Side.Cell;
    if (cell.Level < work.Grid.NumberOfRefinements())
    {
      work.Result.BadFamilies[cell.Level].push_back(work.Lattice.FamilyKeyOf(cell));
    }
  }
}

/// Returns whether a hex is owned. All hexes around an owned hex are in the region.
bool IsOwned(const Work& work, const Hex& hex)
{
  return work.Grid.Finest().Owned().Contains(
    work.Grid.FinestNode(hex.Side.Cell.Level, hex.Side.Cell.At));
}

/// Returns whether a cell of a label at a node has hexes.
bool HasPoint(const Work& work, const Star& star, int label)
{
  return std::any_of(star.begin(), star.end(),
    [&](const Corner& at)
    {
      const HexStars::Side& side = HexOf(work, at).Side;
      return side.Label == label && work.HasHexes(side.Cell);
    });
}

/// Returns the sides to which the point of a label is tangential: those of the domain, and both
/// sides of a flat seam if the label is on both.
int FindSides(const Work& work, Index n, const Star& star, const Vector3& x, int label)
{
  const CartesianGrid& finest = work.Grid.Finest();
  int sides = work.Stars.DomainSides(n);
  const int seams = finest.IsPeriodic() ? finest.FlatSeams(x) : 0;
  for (int a = 0; a < 3; ++a)
  {
    bool isBelow = false, isAbove = false;
    for (const Corner& at : star)
    {
      const HexStars::Side& side = HexOf(work, at).Side;
      const Index first = work.Grid.FinestNode(side.Cell.Level, side.Cell.At)[a];
      const bool above = finest.Coordinates(a)[first] >= x[a];
      isAbove = isAbove || (side.Label == label && above);
      isBelow = isBelow || (side.Label == label && !above);
    }
    sides |= (seams >> a & 1) && isAbove && isBelow ? 3 << (2 * a) : 0;
  }
  return sides;
}

void PlaceInnerPoints(
  Work& work, Index n, const Star& star, const std::vector<LabelNormal>& normals, bool isBad)
{
  const std::vector<int> labels = ListLabels(work, star);
  const Vector3 widths = work.Stars.WidthsAt(star);
  const Vector3 x =
    star.empty() ? Vector3{} : work.Stars.PointAt(HexOf(work, star[0]), star[0].Bits);
  for (int label : labels)
  {
    const VisibleDirection out = FindOutward(label, FindSides(work, n, star, x, label), normals);
    const bool hasPoint = HasPoint(work, star, label);
    isBad = isBad || (hasPoint && out.Margin < SmallestMargin);
    const double length = BufferThickness / std::max(out.Margin, ThinnestMargin);
    work.Result.Labels.push_back(label);
    work.Result.HasPoint.push_back(hasPoint);
    work.Result.Inner.push_back(x - Scaled(widths, length * out.Direction));
  }
  work.Result.LabelOffset.push_back(static_cast<Index>(work.Result.Labels.size()));
  const auto isOwned = [&](const Corner& at) { return IsOwned(work, HexOf(work, at)); };
  if ((isBad || !HasLatticeLabels(work, n, labels)) &&
    std::any_of(star.begin(), star.end(), isOwned))
  {
    RequestFiner(work, star);
  }
}

/// Returns whether the hexes of any label are connected only by edges or by the node.
bool IsTorn(const Work& work, const Star& star, const std::vector<std::pair<Index, Index>>& joined)
{
  std::vector<Index> parent = MakeSets(star.size());
  for (const auto& pair : joined)
  {
    Join(parent, pair.first, pair.second);
  }
  for (std::size_t i = 0; i < star.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (HexOf(work, star[i]).Side.Label == HexOf(work, star[j]).Side.Label &&
        FindRoot(parent, static_cast<Index>(i)) != FindRoot(parent, static_cast<Index>(j)))
      {
        return true;
      }
    }
  }
  return false;
}

void SplitNode(Work& work, Index n, const Star& star)
{
  const std::vector<FaceAt> faces = ListFaces(work, star);
  const Vector3 widths = work.Stars.WidthsAt(star);
  std::vector<LabelNormal> normals;
  std::vector<std::pair<Index, Index>> joined; // pairs of neighbours with one label
  for (std::size_t f = 0; f + 1 < faces.size(); ++f)
  {
    const FaceAt &a = faces[f], &b = faces[f + 1];
    if (a.Keys != b.Keys)
    {
      continue;
    }
    const Hex &hexA = HexOf(work, *a.From), &hexB = HexOf(work, *b.From);
    if (hexA.Side.Label == hexB.Side.Label)
    {
      joined.emplace_back(a.From - star.data(), b.From - star.data());
      continue;
    }
    const int corner = a.From->Bits;
    const Vector3 x = work.Stars.PointAt(hexA, corner);
    const auto edge = [&](int axis)
    { return Divided(work.Stars.PointAt(hexA, corner ^ (1 << axis % 3)) - x, widths); };
    Vector3 normal = Cross(edge(a.Axis + 1), edge(a.Axis + 2));
    normal = Dot(normal, edge(a.Axis)) > 0.0 ? -1.0 * normal : normal;
    normals.emplace_back(hexA.Side.Label, normal);
    normals.emplace_back(hexB.Side.Label, -1.0 * normal);
    AddFace(work, a, b);
  }
  PlaceInnerPoints(work, n, star, normals, IsTorn(work, star, joined));
}

void SplitAll(Work& work)
{
  for (Index n = 0; n < work.Result.Count(); ++n)
  {
    SplitNode(work, n, work.Stars.StarOf(n));
  }
}

int FacesAt(const Work& work, const Hex& hex)
{
  if (hex.What != Kind::Fine)
  {
    return work.Result.FacesOfHex(hex.Side.HexKey);
  }
  const CartesianGrid& finest = work.Grid.Finest();
  const Index cell = finest.Linear(hex.Side.Cell.At);
  int faces = 0;
  for (int face = 0; face < 6; ++face)
  {
    faces |= (work.Labels[finest.Neighbour(cell, face)] != hex.Side.Label) << face;
  }
  return faces;
}

/// Returns the initial position of a point of a core hex.
Vector3 InnerAt(const Work& work, const Hex& hex, int corner)
{
  const Index n = work.Result.Find(work.Stars.KeyAt(hex, corner));
  if (n >= 0)
  {
    return work.Result.InnerPoint(n, work.Result.RankOf(n, hex.Side.Label));
  }
  return hex.What == Kind::Fine ? StartOfInnerPoint(work.Grid.Finest(), work.Labels,
                                    CornerOfCell(hex.Side.Cell.At, corner), hex.Side.Label)
                                : work.Stars.PointAt(hex, corner);
}

bool IsPositive(const Work& work, const Hex& hex)
{
  std::array<Vector3, 8> inner, outer;
  for (int c = 0; c < 8; ++c)
  {
    inner[c] = InnerAt(work, hex, c);
    outer[c] = work.Stars.PointAt(hex, c);
  }
  const Vector3 widths = work.Lattice.CellWidths(hex.Side.Cell.Level, hex.Side.Cell.At);
  const double least = SmallestDeterminant * widths[0] * widths[1] * widths[2];
  const auto isPositive = [&](const std::array<Vector3, 8>& x)
  { return SmallestCoefficient(x) > least; };
  bool isGood = isPositive(inner);
  const int faces = FacesAt(work, hex);
  for (int face = 0; isGood && face < 6; ++face)
  {
    if (faces >> face & 1)
    {
      isGood = isPositive(BufferHex(outer, inner, face));
    }
  }
  return isGood;
}

/// Checks the initial shape of all owned hexes.
void CheckHexes(Work& work)
{
  for (const Hex& hex : work.Stars.Hexes())
  {
    if (!IsOwned(work, hex) || !work.HasHexes(hex.Side.Cell) || IsPositive(work, hex))
    {
      continue;
    }
    for (int c = 0; c < 8; ++c)
    {
      const Index n = work.Result.Find(work.Stars.KeyAt(hex, c));
      if (n >= 0)
      {
        RequestFiner(work, work.Stars.StarOf(n));
      }
    }
  }
}

/// Combines the faces of each hex into one entry.
void SortFaces(Work& work)
{
  std::vector<std::pair<Index, int>>& faces = work.Result.HexFaces;
  std::sort(faces.begin(), faces.end());
  std::size_t count = 0;
  for (const auto& face : faces)
  {
    if (count > 0 && faces[count - 1].first == face.first)
    {
      faces[count - 1].second |= face.second;
      continue;
    }
    faces[count++] = face;
  }
  faces.resize(count);
}

void SortFamilies(Work& work)
{
  for (std::vector<Index>& families : work.Result.BadFamilies)
  {
    SortUnique(families);
  }
}

} // namespace

SplitNodes FindSplitNodes(const RefinedGrid& grid, const RefinedMesh& refined,
  const IndexBox& region, const LabelArray& labels,
  const std::function<bool(const OctreeKeys::LevelIndex& cell)>& hasHexes)
{
  const HexStars stars(grid, refined, region, labels);
  SplitNodes result;
  result.Keys = stars.Nodes();
  result.BadFamilies.resize(grid.NumberOfRefinements());
  Work work{ grid, grid.Lattice(), stars, labels, hasHexes, result };
  SplitAll(work);
  SortFaces(work);
  CheckHexes(work);
  SortFamilies(work);
  return result;
}

} // namespace vfm
