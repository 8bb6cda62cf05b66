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
struct FaceAtNode
{
  std::array<Index, 3> Keys;
  const Corner* From;
  int Axis;
};

using CellCondition = std::function<bool(const OctreeKeys::LevelIndex&)>;

/// Grid and labels around split nodes.
struct SplitRegion
{
  const RefinedGrid& Grid;
  const HexStars& Stars;
  const LabelArray& Labels; ///< labels of the finest grid
  const CellCondition& HasHexes;
};

const Hex& HexOf(const HexStars& stars, const Corner& at)
{
  return stars.Hexes()[at.Hex];
}

/// Lists the faces at a node by key. A face that two hexes share is listed twice in sequence.
std::vector<FaceAtNode> ListFaces(const HexStars& stars, const Star& star)
{
  std::vector<FaceAtNode> faces;
  for (const Corner& at : star)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3;
      const Hex& hex = HexOf(stars, at);
      const auto ends =
        std::minmax({ stars.KeyAt(hex, at.Bits ^ b), stars.KeyAt(hex, at.Bits ^ c) });
      faces.push_back(
        { { { ends.first, ends.second, stars.KeyAt(hex, at.Bits ^ b ^ c) } }, &at, axis });
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
    [](const FaceAtNode& a, const FaceAtNode& b) { return a.Keys < b.Keys; });
  return faces;
}

/// Adds a face when it is visited at its node with the smallest key.
void AddFace(const HexStars& stars, const FaceAtNode& a, const FaceAtNode& b, SplitNodes& result)
{
  const Hex& hexA = HexOf(stars, *a.From);
  const Hex& hexB = HexOf(stars, *b.From);
  const int corner = a.From->Bits;
  std::array<Index, 4> keys{ { stars.KeyAt(hexA, corner),
    stars.KeyAt(hexA, corner ^ (1 << (a.Axis + 1) % 3)), a.Keys[2],
    stars.KeyAt(hexA, corner ^ (1 << (a.Axis + 2) % 3)) } };
  if (*std::min_element(keys.begin(), keys.end()) != keys[0])
  {
    return;
  }
  for (const FaceAtNode* face : { &a, &b })
  {
    const Hex& hex = HexOf(stars, *face->From);
    const int bit = 1 << (2 * face->Axis + (face->From->Bits >> face->Axis & 1));
    if (hex.What != Kind::Fine)
    {
      result.HexFaces.emplace_back(hex.Place.HexKey, bit);
    }
  }
  if (hexA.What == Kind::Fine && hexB.What == Kind::Fine)
  {
    return;
  }
  const bool isFirst = hexA.Place.Label < hexB.Place.Label;
  // at a corner with an even number of bits, the normal by this order points into A
  if (((0x69 >> corner & 1) != 0) == isFirst)
  {
    std::swap(keys[1], keys[3]);
  }
  SplitNodes::InterfaceQuad face;
  for (int c = 0; c < 4; ++c)
  {
    face.Nodes[c] = result.Find(keys[c]);
    if (face.Nodes[c] < 0)
    {
      return; // at the rim of the region
    }
  }
  face.Sides = { { isFirst ? hexA.Place : hexB.Place, isFirst ? hexB.Place : hexA.Place } };
  result.Faces.push_back(face);
}

/// Returns the labels at a node, ascending.
std::vector<int> ListLabels(const HexStars& stars, const Star& star)
{
  std::vector<int> labels;
  for (const Corner& at : star)
  {
    labels.push_back(HexOf(stars, at).Place.Label);
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
/// @param cells  labels of the finest grid
bool HasLatticeLabels(
  const RefinedGrid& grid, const LabelArray& cells, Index key, const std::vector<int>& labels)
{
  const CartesianGrid& finest = grid.Finest();
  const OctreeKeys::LevelIndex node = grid.Lattice().NodeOfKey(key);
  const Index3 p = grid.FinestNode(node.Level, node.At);
  if (node.Slot != 0 || !finest.Local().Touches(p) || !grid.TouchesFine(p))
  {
    return true;
  }
  const StarLabels lattice(StarOfNode(finest, cells, finest.Linear(p)));
  return std::equal(labels.begin(), labels.end(), lattice.begin(), lattice.end());
}

/// Requests refinement of the coarser cells of a star.
void RequestFiner(const RefinedGrid& grid, const HexStars& stars, const Star& star,
  std::vector<std::vector<Index>>& families)
{
  for (const Corner& at : star)
  {
    const OctreeKeys::LevelIndex& cell = HexOf(stars, at).Place.Cell;
    if (cell.Level < grid.NumberOfRefinements())
    {
      families[cell.Level].push_back(grid.Lattice().FamilyKeyOf(cell));
    }
  }
}

/// Returns whether a hex is owned. All hexes around an owned hex are in the region.
bool IsOwned(const RefinedGrid& grid, const Hex& hex)
{
  return grid.Finest().Owned().Contains(grid.FinestNode(hex.Place.Cell.Level, hex.Place.Cell.At));
}

/// Returns whether a cell of a label at a node has hexes.
bool HasPoint(const HexStars& stars, const CellCondition& hasHexes, const Star& star, int label)
{
  return std::any_of(star.begin(), star.end(),
    [&](const Corner& at)
    {
      const HexStars::HexPlace& side = HexOf(stars, at).Place;
      return side.Label == label && hasHexes(side.Cell);
    });
}

/// Returns both sides of the flat seams at a node that have a label on both sides. The point of the
/// label is tangential to them.
/// @param x  position of the node
int FindSeamSides(
  const RefinedGrid& grid, const HexStars& stars, const Star& star, const Vector3& x, int label)
{
  const CartesianGrid& finest = grid.Finest();
  int sides = 0;
  const int seams = finest.IsPeriodic() ? finest.FlatSeams(x) : 0;
  for (int a = 0; a < 3; ++a)
  {
    bool isBelow = false, isAbove = false;
    for (const Corner& at : star)
    {
      const HexStars::HexPlace& side = HexOf(stars, at).Place;
      const Index first = grid.FinestNode(side.Cell.Level, side.Cell.At)[a];
      const bool above = finest.Coordinates(a)[first] >= x[a];
      isAbove = isAbove || (side.Label == label && above);
      isBelow = isBelow || (side.Label == label && !above);
    }
    sides |= (seams >> a & 1) && isAbove && isBelow ? 3 << (2 * a) : 0;
  }
  return sides;
}

/// Adds the labels at a node and their inner points.
/// @param labels  labels at the node, ascending
/// @param normals  normals of the faces between two labels
/// @return whether the points can be placed so that hexes are positive
bool PlaceInnerPoints(const SplitRegion& region, Index n, const std::vector<int>& labels,
  const std::vector<LabelNormal>& normals, SplitNodes& result)
{
  const HexStars& stars = region.Stars;
  const Star star = stars.StarOf(n);
  const Vector3 widths = stars.WidthsAt(star);
  const Vector3 x = star.empty() ? Vector3{} : stars.PointAt(HexOf(stars, star[0]), star[0].Bits);
  bool isVisible = true;
  for (int label : labels)
  {
    const int sides = stars.DomainSides(n) | FindSeamSides(region.Grid, stars, star, x, label);
    const VisibleDirection out = FindOutward(label, sides, normals);
    const bool hasPoint = HasPoint(stars, region.HasHexes, star, label);
    isVisible = isVisible && !(hasPoint && out.Margin < SmallestMargin);
    const double length = BufferThickness / std::max(out.Margin, ThinnestMargin);
    result.Labels.push_back(label);
    result.HasPoint.push_back(hasPoint);
    result.Inner.push_back(x - Scaled(widths, length * out.Direction));
  }
  result.LabelOffset.push_back(static_cast<Index>(result.Labels.size()));
  return isVisible;
}

/// Returns whether the hexes of any label are connected only by edges or by the node.
/// @param joined  hexes of one label with a common face, as positions in the star
bool IsTorn(
  const HexStars& stars, const Star& star, const std::vector<std::pair<Index, Index>>& joined)
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
      if (HexOf(stars, star[i]).Place.Label == HexOf(stars, star[j]).Place.Label &&
        FindRoot(parent, static_cast<Index>(i)) != FindRoot(parent, static_cast<Index>(j)))
      {
        return true;
      }
    }
  }
  return false;
}

/// Adds the normals of a face between two labels at its node.
/// @param widths  widths of the cells there
void AddNormals(const HexStars& stars, const FaceAtNode& a, const FaceAtNode& b,
  const Vector3& widths, std::vector<LabelNormal>& normals)
{
  const Hex& hex = HexOf(stars, *a.From);
  const int corner = a.From->Bits;
  const Vector3 x = stars.PointAt(hex, corner);
  const auto edge = [&](int axis)
  { return Divided(stars.PointAt(hex, corner ^ (1 << axis % 3)) - x, widths); };
  Vector3 normal = Cross(edge(a.Axis + 1), edge(a.Axis + 2));
  normal = Dot(normal, edge(a.Axis)) > 0.0 ? -1.0 * normal : normal;
  normals.emplace_back(hex.Place.Label, normal);
  normals.emplace_back(HexOf(stars, *b.From).Place.Label, -1.0 * normal);
}

/// Adds the labels, inner points and faces of a node, and requests refinement if no valid mesh
/// starts there.
void SplitNode(const SplitRegion& region, Index n, SplitNodes& result)
{
  const HexStars& stars = region.Stars;
  const Star star = stars.StarOf(n);
  const std::vector<FaceAtNode> faces = ListFaces(stars, star);
  const Vector3 widths = stars.WidthsAt(star);
  std::vector<LabelNormal> normals;
  std::vector<std::pair<Index, Index>> joined; // pairs of neighbours with one label
  for (std::size_t f = 0; f + 1 < faces.size(); ++f)
  {
    const FaceAtNode &a = faces[f], &b = faces[f + 1];
    if (a.Keys != b.Keys)
    {
      continue;
    }
    if (HexOf(stars, *a.From).Place.Label == HexOf(stars, *b.From).Place.Label)
    {
      joined.emplace_back(a.From - star.data(), b.From - star.data());
      continue;
    }
    AddNormals(stars, a, b, widths, normals);
    AddFace(stars, a, b, result);
  }
  const std::vector<int> labels = ListLabels(stars, star);
  const bool isGood = PlaceInnerPoints(region, n, labels, normals, result) &&
    !IsTorn(stars, star, joined) &&
    HasLatticeLabels(region.Grid, region.Labels, result.Keys[n], labels);
  const auto isOwned = [&](const Corner& at) { return IsOwned(region.Grid, HexOf(stars, at)); };
  if (!isGood && std::any_of(star.begin(), star.end(), isOwned))
  {
    RequestFiner(region.Grid, stars, star, result.BadFamilies);
  }
}

/// Returns the faces of a hex on interfaces, one bit per face.
int FacesAt(
  const RefinedGrid& grid, const LabelArray& labels, const SplitNodes& splits, const Hex& hex)
{
  if (hex.What != Kind::Fine)
  {
    return splits.FacesOfHex(hex.Place.HexKey);
  }
  const CartesianGrid& finest = grid.Finest();
  const Index cell = finest.Linear(hex.Place.Cell.At);
  int faces = 0;
  for (int face = 0; face < 6; ++face)
  {
    faces |= (labels[finest.Neighbour(cell, face)] != hex.Place.Label) << face;
  }
  return faces;
}

/// Returns the initial position of a point of a core hex.
Vector3 InnerAt(const SplitRegion& region, const SplitNodes& splits, const Hex& hex, int corner)
{
  const Index n = splits.Find(region.Stars.KeyAt(hex, corner));
  if (n >= 0)
  {
    return splits.InnerPoint(n, splits.RankOf(n, hex.Place.Label));
  }
  return hex.What == Kind::Fine ? StartOfInnerPoint(region.Grid.Finest(), region.Labels,
                                    CornerOfCell(hex.Place.Cell.At, corner), hex.Place.Label)
                                : region.Stars.PointAt(hex, corner);
}

bool IsPositive(const SplitRegion& region, const SplitNodes& splits, const Hex& hex)
{
  std::array<Vector3, 8> inner, outer;
  for (int c = 0; c < 8; ++c)
  {
    inner[c] = InnerAt(region, splits, hex, c);
    outer[c] = region.Stars.PointAt(hex, c);
  }
  const OctreeKeys::LevelIndex& cell = hex.Place.Cell;
  const Vector3 widths = region.Grid.Lattice().CellWidths(cell.Level, cell.At);
  const double least = SmallestDeterminant * widths[0] * widths[1] * widths[2];
  const auto isPositive = [&](const std::array<Vector3, 8>& x)
  { return SmallestCoefficient(x) > least; };
  bool isGood = isPositive(inner);
  const int faces = FacesAt(region.Grid, region.Labels, splits, hex);
  for (int face = 0; isGood && face < 6; ++face)
  {
    if (faces >> face & 1)
    {
      isGood = isPositive(BufferHex(outer, inner, face));
    }
  }
  return isGood;
}

/// Requests refinement at owned hexes whose initial shape is not positive.
void CheckHexes(const SplitRegion& region, SplitNodes& splits)
{
  for (const Hex& hex : region.Stars.Hexes())
  {
    if (!IsOwned(region.Grid, hex) || !region.HasHexes(hex.Place.Cell) ||
      IsPositive(region, splits, hex))
    {
      continue;
    }
    for (int c = 0; c < 8; ++c)
    {
      const Index n = splits.Find(region.Stars.KeyAt(hex, c));
      if (n >= 0)
      {
        RequestFiner(region.Grid, region.Stars, region.Stars.StarOf(n), splits.BadFamilies);
      }
    }
  }
}

/// Combines the faces of each hex into one entry.
void SortFaces(std::vector<std::pair<Index, int>>& faces)
{
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

} // namespace

SplitNodes FindSplitNodes(const RefinedGrid& grid, const RefinedMesh& refined,
  const IndexBox& region, const LabelArray& labels,
  const std::function<bool(const OctreeKeys::LevelIndex& cell)>& hasHexes)
{
  const HexStars stars(grid, refined, region, labels);
  SplitNodes result;
  result.Keys = stars.Nodes();
  result.BadFamilies.resize(grid.NumberOfRefinements());
  const SplitRegion around{ grid, stars, labels, hasHexes };
  for (Index n = 0; n < result.Count(); ++n)
  {
    SplitNode(around, n, result);
  }
  SortFaces(result.HexFaces);
  CheckHexes(around, result);
  std::for_each(result.BadFamilies.begin(), result.BadFamilies.end(),
    [](std::vector<Index>& families) { SortUnique(families); });
  return result;
}

} // namespace vfm
