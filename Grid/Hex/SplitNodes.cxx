#include "Hex/SplitNodes.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Hex/HexTopology.h"
#include "Hex/VisibleDirection.h"
#include "Labels/LabelCondition.h"
#include "Smoothing/HexCoefficients.h"

namespace vfm
{
namespace
{

constexpr double SmallestMargin = 0.1;       // of a visible direction
constexpr double ThinnestMargin = 0.3;       // below it the buffer layer starts thinner
constexpr double SmallestDeterminant = 1e-4; // of a hex at the start, in volumes of the cell

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

class SplitNodesBuilder
{
public:
  SplitNodesBuilder(const RefinedGrid& grid, const HexStars& stars, const LabelArray& labels,
    bool meshVoid, SplitNodes& result) :
    Grid(grid),
    Lattice(grid.Lattice()),
    Stars(stars),
    Labels(labels),
    MeshVoid(meshVoid),
    Result(result)
  {
    result.Keys = stars.Nodes();
    result.Families.resize(grid.NumberOfRefinements());
  }

  void Run()
  {
    this->SplitAll();
    this->SortFaces();
    this->CheckHexes();
    this->SortFamilies();
  }

private:
  using Kind = HexStars::Kind;
  using Hex = HexStars::Hex;
  using Corner = HexStars::Corner;
  using Star = HexStars::Star;
  using LabelNormal = std::pair<int, Vector3>; // out of the label
  /// A face of a hex at a node: the far ends of its two edges there, the corner opposite, and whose it is.
  struct FaceAt
  {
    std::array<Index, 3> Keys;
    const Corner* From;
    int Axis;
  };

  void SplitAll();
  void SplitNode(Index n, const Star& star);
  std::vector<FaceAt> ListFaces(const Star& star) const;
  void AddFace(const FaceAt& a, const FaceAt& b);
  std::vector<int> ListLabels(const Star& star) const;
  VisibleDirection FindOutward(int label, int sides, const std::vector<LabelNormal>& normals) const;
  void PlaceInnerPoints(
    Index n, const Star& star, const std::vector<LabelNormal>& normals, bool isBad);
  bool HasLatticeLabels(Index n, const std::vector<int>& labels) const;
  bool IsTorn(const Star& star, const std::vector<std::pair<Index, Index>>& joined) const;
  void CheckHexes();
  int FacesAt(const Hex& hex) const;
  bool IsPositive(const Hex& hex) const;
  void WantFiner(const Star& star);
  void SortFaces();
  void SortFamilies();

  const Hex& HexOf(const Corner& at) const { return this->Stars.Hexes()[at.Hex]; }
  /// Owned hexes have all hexes around them in the region.
  bool IsOwned(const Hex& hex) const
  {
    return this->Grid.Finest().Owned().Contains(
      this->Grid.FinestNode(hex.Side.Cell.Level, hex.Side.Cell.At));
  }
  Vector3 InnerAt(const Hex& hex, int corner) const;

  const RefinedGrid& Grid;
  const OctreeKeys& Lattice;
  const HexStars& Stars;
  const LabelArray& Labels;
  const bool MeshVoid;
  SplitNodes& Result;
};

void SplitNodesBuilder::SplitAll()
{
  this->Result.LabelOffset.assign(1, 0);
  for (Index n = 0; n < this->Result.Count(); ++n)
  {
    this->SplitNode(n, this->Stars.StarOf(n));
  }
}

/// By key, those that two hexes share beside each other.
std::vector<SplitNodesBuilder::FaceAt> SplitNodesBuilder::ListFaces(const Star& star) const
{
  std::vector<FaceAt> faces;
  for (const Corner& at : star)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int b = 1 << (axis + 1) % 3, c = 1 << (axis + 2) % 3;
      const Hex& hex = this->HexOf(at);
      const auto ends =
        std::minmax({ this->Stars.KeyAt(hex, at.Bits ^ b), this->Stars.KeyAt(hex, at.Bits ^ c) });
      faces.push_back(
        { { { ends.first, ends.second, this->Stars.KeyAt(hex, at.Bits ^ b ^ c) } }, &at, axis });
    }
  }
  std::stable_sort(
    faces.begin(), faces.end(), [](const FaceAt& a, const FaceAt& b) { return a.Keys < b.Keys; });
  return faces;
}

void SplitNodesBuilder::SplitNode(Index n, const Star& star)
{
  const std::vector<FaceAt> faces = this->ListFaces(star);
  const Vector3 widths = this->Stars.WidthsAt(star);
  std::vector<LabelNormal> normals;
  std::vector<std::pair<Index, Index>> joined; // hexes of one label
  for (std::size_t f = 0; f + 1 < faces.size(); ++f)
  {
    const FaceAt &a = faces[f], &b = faces[f + 1];
    if (a.Keys != b.Keys)
    {
      continue;
    }
    const Hex &hexA = this->HexOf(*a.From), &hexB = this->HexOf(*b.From);
    if (hexA.Side.Label == hexB.Side.Label)
    {
      joined.emplace_back(a.From - star.data(), b.From - star.data());
      continue;
    }
    const int corner = a.From->Bits;
    const Vector3 x = this->Stars.PointAt(hexA, corner);
    const auto edge = [&](int axis)
    { return Divided(this->Stars.PointAt(hexA, corner ^ (1 << axis % 3)) - x, widths); };
    Vector3 normal = Cross(edge(a.Axis + 1), edge(a.Axis + 2));
    normal = Dot(normal, edge(a.Axis)) > 0.0 ? -1.0 * normal : normal;
    normals.emplace_back(hexA.Side.Label, normal);
    normals.emplace_back(hexB.Side.Label, -1.0 * normal);
    this->AddFace(a, b);
  }
  this->PlaceInnerPoints(n, star, normals, this->IsTorn(star, joined));
}

/// Whether the hexes of some label hang together by edges or the node only.
bool SplitNodesBuilder::IsTorn(
  const Star& star, const std::vector<std::pair<Index, Index>>& joined) const
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
      if (this->HexOf(star[i]).Side.Label == this->HexOf(star[j]).Side.Label &&
        FindRoot(parent, static_cast<Index>(i)) != FindRoot(parent, static_cast<Index>(j)))
      {
        return true;
      }
    }
  }
  return false;
}

/// Keeps a face where it is met at its node of the smallest key.
void SplitNodesBuilder::AddFace(const FaceAt& a, const FaceAt& b)
{
  const Hex& hexA = this->HexOf(*a.From);
  const Hex& hexB = this->HexOf(*b.From);
  const int corner = a.From->Bits;
  std::array<Index, 4> keys{ { this->Stars.KeyAt(hexA, corner),
    this->Stars.KeyAt(hexA, corner ^ (1 << (a.Axis + 1) % 3)), a.Keys[2],
    this->Stars.KeyAt(hexA, corner ^ (1 << (a.Axis + 2) % 3)) } };
  if (*std::min_element(keys.begin(), keys.end()) != keys[0])
  {
    return;
  }
  for (const FaceAt* face : { &a, &b })
  {
    const Hex& hex = this->HexOf(*face->From);
    const int bit = 1 << (2 * face->Axis + (face->From->Bits >> face->Axis & 1));
    if (hex.What != Kind::Fine)
    {
      this->Result.HexFaces.emplace_back(hex.Side.HexKey, bit);
    }
  }
  if (hexA.What == Kind::Fine && hexB.What == Kind::Fine)
  {
    return;
  }
  const bool isFirst = hexA.Side.Label < hexB.Side.Label;
  // at a corner of even bits they turn about an edge into A
  if (((0x69 >> corner & 1) != 0) == isFirst)
  {
    std::swap(keys[1], keys[3]);
  }
  SplitNodes::Face face;
  for (int c = 0; c < 4; ++c)
  {
    face.Nodes[c] = this->Result.Find(keys[c]);
    if (face.Nodes[c] < 0)
    {
      return; // at the rim of the region
    }
  }
  face.Sides = { { isFirst ? hexA.Side : hexB.Side, isFirst ? hexB.Side : hexA.Side } };
  this->Result.TheFaces.push_back(face);
}

/// The labels at a node, ascending.
std::vector<int> SplitNodesBuilder::ListLabels(const Star& star) const
{
  std::vector<int> labels;
  for (const Corner& at : star)
  {
    labels.push_back(this->HexOf(at).Side.Label);
  }
  SortUnique(labels);
  return labels;
}

/// The direction that leads out of a label at a node, on the sides of the domain along them.
VisibleDirection SplitNodesBuilder::FindOutward(
  int label, int sides, const std::vector<LabelNormal>& normals) const
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

void SplitNodesBuilder::PlaceInnerPoints(
  Index n, const Star& star, const std::vector<LabelNormal>& normals, bool isBad)
{
  const std::vector<int> labels = this->ListLabels(star);
  const Vector3 widths = this->Stars.WidthsAt(star);
  const Vector3 x =
    star.empty() ? Vector3{} : this->Stars.PointAt(this->HexOf(star[0]), star[0].Bits);
  const int sides = this->Stars.DomainSides(n);
  for (int label : labels)
  {
    const VisibleDirection out = this->FindOutward(label, sides, normals);
    isBad = isBad || (IsMeshed(label, this->MeshVoid) && out.Margin < SmallestMargin);
    const double length = BufferThickness / std::max(out.Margin, ThinnestMargin);
    this->Result.Labels.push_back(label);
    this->Result.Inner.push_back(x - Scaled(widths, length * out.Direction));
  }
  this->Result.LabelOffset.push_back(static_cast<Index>(this->Result.Labels.size()));
  const auto isOwned = [this](const Corner& at) { return this->IsOwned(this->HexOf(at)); };
  if ((isBad || !this->HasLatticeLabels(n, labels)) &&
    std::any_of(star.begin(), star.end(), isOwned))
  {
    this->WantFiner(star);
  }
}

/// Finest cells number the inner points by the labels of the lattice: whether these are the labels at a node of theirs.
bool SplitNodesBuilder::HasLatticeLabels(Index n, const std::vector<int>& labels) const
{
  const CartesianGrid& finest = this->Grid.Finest();
  const OctreeKeys::LevelIndex node = this->Lattice.NodeOfKey(this->Result.Keys[n]);
  const Index3 p = this->Grid.FinestNode(node.Level, node.At);
  if (node.Slot != 0 || !finest.Local().Touches(p) || !this->Grid.TouchesFine(p))
  {
    return true;
  }
  const StarLabels lattice(StarOfNode(finest, this->Labels, finest.Linear(p)));
  return std::equal(labels.begin(), labels.end(), lattice.begin(), lattice.end());
}

/// Refines the coarser cells of a star.
void SplitNodesBuilder::WantFiner(const Star& star)
{
  for (const Corner& at : star)
  {
    const OctreeKeys::LevelIndex& cell = this->HexOf(at).Side.Cell;
    if (cell.Level < this->Grid.NumberOfRefinements())
    {
      this->Result.Families[cell.Level].push_back(this->Lattice.FamilyKeyOf(cell));
    }
  }
}

/// Where the point of a core hex starts.
Vector3 SplitNodesBuilder::InnerAt(const Hex& hex, int corner) const
{
  const Index n = this->Result.Find(this->Stars.KeyAt(hex, corner));
  if (n >= 0)
  {
    return this->Result.InnerPoint(n, this->Result.RankOf(n, hex.Side.Label));
  }
  return hex.What == Kind::Fine ? StartOfInnerPoint(this->Grid.Finest(), this->Labels,
                                    CornerOfCell(hex.Side.Cell.At, corner), hex.Side.Label)
                                : this->Stars.PointAt(hex, corner);
}

int SplitNodesBuilder::FacesAt(const Hex& hex) const
{
  if (hex.What != Kind::Fine)
  {
    return this->Result.FacesOfHex(hex.Side.HexKey);
  }
  const CartesianGrid& finest = this->Grid.Finest();
  const Index cell = finest.Linear(hex.Side.Cell.At);
  int faces = 0;
  for (int face = 0; face < 6; ++face)
  {
    faces |= (this->Labels[finest.Neighbour(cell, face)] != hex.Side.Label) << face;
  }
  return faces;
}

bool SplitNodesBuilder::IsPositive(const Hex& hex) const
{
  std::array<Vector3, 8> inner, outer;
  for (int c = 0; c < 8; ++c)
  {
    inner[c] = this->InnerAt(hex, c);
    outer[c] = this->Stars.PointAt(hex, c);
  }
  const Vector3 widths = this->Lattice.CellWidths(hex.Side.Cell.Level, hex.Side.Cell.At);
  const double least = SmallestDeterminant * widths[0] * widths[1] * widths[2];
  const auto isPositive = [&](const std::array<Vector3, 8>& x)
  { return SmallestCoefficient(x) > least; };
  bool isGood = isPositive(inner);
  const int faces = this->FacesAt(hex);
  for (int face = 0; isGood && face < 6; ++face)
  {
    if (faces >> face & 1)
    {
      isGood = isPositive(BufferHex(outer, inner, face));
    }
  }
  return isGood;
}

/// Looks at the start of all owned hexes.
void SplitNodesBuilder::CheckHexes()
{
  for (const Hex& hex : this->Stars.Hexes())
  {
    if (!this->IsOwned(hex) || !IsMeshed(hex.Side.Label, this->MeshVoid) || this->IsPositive(hex))
    {
      continue;
    }
    for (int c = 0; c < 8; ++c)
    {
      const Index n = this->Result.Find(this->Stars.KeyAt(hex, c));
      if (n >= 0)
      {
        this->WantFiner(this->Stars.StarOf(n));
      }
    }
  }
}

/// One entry a hex.
void SplitNodesBuilder::SortFaces()
{
  std::vector<std::pair<Index, int>>& faces = this->Result.HexFaces;
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

void SplitNodesBuilder::SortFamilies()
{
  for (std::vector<Index>& families : this->Result.Families)
  {
    SortUnique(families);
  }
}

SplitNodes::SplitNodes(const RefinedGrid& grid, const RefinedMesh& refined, const IndexBox& region,
  const LabelArray& labels, bool meshVoid)
{
  const HexStars stars(grid, refined, region, labels);
  SplitNodesBuilder(grid, stars, labels, meshVoid, *this).Run();
}

} // namespace vfm
