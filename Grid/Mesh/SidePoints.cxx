#include "Mesh/SidePoints.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Labels/Fragments.h"
#include "Mesh/PointValues.h"

namespace vfm
{
namespace
{

constexpr int LongestGap = 3;       // of an edge, in points from a carrier
constexpr double SharpCosine = .77; // of 40 degrees between facets at a point

bool IsInterface(const Facet& facet)
{
  return facet.DomainSide < 0;
}

class SideFinder
{
public:
  SideFinder(const std::vector<Facet>& facets, const Mesh& mesh, const Partition& partition) :
    Facets(facets),
    Input(mesh),
    Parts(partition),
    Corners(mesh.CornersOfFacet()),
    Shared(this->ListPoints(), mesh, partition)
  {
  }
  SidePoints Find(const std::vector<CreaseKind>& kinds)
  {
    this->FindPlaces(kinds);
    this->CloseGaps();
    this->FindCuts();
    this->NumberPoints();
    return { std::move(this->CutOfFacet), static_cast<int>(this->Cuts.size()),
      std::move(this->SideOfPoint), std::move(this->CutOfSide) };
  }

private:
  using Pair = std::array<int, 2>;
  /// Where a point lies on the interfaces.
  enum class Place : unsigned char
  {
    None,
    Inside,
    OnEdge,
    Between ///< on several surfaces
  };
  std::vector<Index> ListPoints() const;
  void FindPlaces(const std::vector<CreaseKind>& kinds);
  void CloseGaps();
  bool IsBesideEdge(const int* first, const int* last) const;
  bool IsSharp(const int* first, const int* last) const;
  void FindCuts();
  void NumberPoints();
  void NumberPieces(const std::vector<Piece>& pieces, const std::vector<Index>& pieceOf);

  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const Partition& Parts;
  const int Corners; // of a facet
  const PointValues Shared;
  std::vector<Place> PlaceOf;  // of every point
  std::vector<Pair> Cuts;      // interfaces with edges, ascending
  std::vector<int> CutOfFacet; // position in Cuts, or -1
  std::vector<int> SideOfPoint, CutOfSide;
};

/// The points of interfaces, ascending.
std::vector<Index> SideFinder::ListPoints() const
{
  std::vector<Index> points;
  for (const Facet& facet : this->Facets)
  {
    if (IsInterface(facet))
    {
      points.insert(points.end(), facet.Points.begin(), facet.Points.begin() + this->Corners);
    }
  }
  SortUnique(points);
  return points;
}

void SideFinder::FindPlaces(const std::vector<CreaseKind>& kinds)
{
  this->PlaceOf.assign(this->Input.PointIds.size(), Place::None);
  std::vector<Pair> first(this->PlaceOf.size());
  for (const Facet& facet : this->Facets)
  {
    for (int c = 0; c < this->Corners; ++c)
    {
      const Index p = facet.Points[c];
      Place& place = this->PlaceOf[p];
      if (place == Place::None)
      {
        first[p] = SurfaceOf(facet);
        place = !kinds.empty() && IsCarrier(kinds[p]) ? Place::OnEdge : Place::Inside;
      }
      place = first[p] == SurfaceOf(facet) ? place : Place::Between;
    }
  }
  this->Shared.Fetch(
    this->PlaceOf, [this](Index point, Place place) { this->PlaceOf[point] = place; });
}

/// Edges go on over points that carry none but around which the facets turn, for a few points.
void SideFinder::CloseGaps()
{
  const Groups<int> around =
    ListFacetsAt(this->Facets, this->Input, [this](int f) { return IsInterface(this->Facets[f]); });
  for (int step = 0; step < LongestGap; ++step)
  {
    std::vector<Place> places(this->PlaceOf);
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      const int* first = around.Items.data() + around.Begin[p];
      const int* last = around.Items.data() + around.Begin[p + 1];
      if (places[p] == Place::Inside && this->IsBesideEdge(first, last) &&
        this->IsSharp(first, last))
      {
        places[p] = Place::OnEdge;
      }
    }
    this->PlaceOf.swap(places);
    this->Shared.Fetch(
      this->PlaceOf, [this](Index point, Place place) { this->PlaceOf[point] = place; });
  }
}

bool SideFinder::IsBesideEdge(const int* first, const int* last) const
{
  return std::any_of(first, last,
    [this](int f)
    {
      const std::array<Index, 4>& points = this->Facets[f].Points;
      return std::any_of(points.begin(), points.end(),
        [this](Index q) { return this->PlaceOf[q] == Place::OnEdge; });
    });
}

bool SideFinder::IsSharp(const int* first, const int* last) const
{
  return std::any_of(first, last,
    [&](int f)
    {
      const Vector3 normal = NormalOf(this->Input, this->Facets[f]);
      return std::any_of(first, last,
        [&](int g) { return Dot(normal, NormalOf(this->Input, this->Facets[g])) < SharpCosine; });
    });
}

/// The interfaces with edges.
void SideFinder::FindCuts()
{
  std::vector<Pair> cut;
  for (const Facet& facet : this->Facets)
  {
    if (IsInterface(facet) && facet.IsOwned &&
      std::any_of(facet.Points.begin(), facet.Points.end(),
        [this](Index p) { return this->PlaceOf[p] == Place::OnEdge; }))
    {
      cut.push_back(SurfaceOf(facet));
    }
  }
  SortUnique(cut);
  this->Cuts = GatherItems(this->Parts.Group(), cut);
  SortUnique(this->Cuts);
  for (const Facet& facet : this->Facets)
  {
    this->CutOfFacet.push_back(static_cast<int>(FindSorted(this->Cuts, SurfaceOf(facet))));
  }
}

/// Fills SideOfPoint, of points inside; 0 elsewhere.
void SideFinder::NumberPoints()
{
  const std::size_t count = this->PlaceOf.size();
  std::vector<Index> parent = MakeSets(count);
  std::vector<int> cutOf(count, -1);
  for (std::size_t f = 0; f < this->Facets.size(); ++f)
  {
    const std::array<Index, 4>& points = this->Facets[f].Points;
    for (int c = 0; this->CutOfFacet[f] >= 0 && c < this->Corners; ++c)
    {
      const Index a = points[c], b = points[(c + 1) % this->Corners];
      cutOf[a] = this->PlaceOf[a] == Place::Inside ? this->CutOfFacet[f] : -1;
      if (cutOf[a] >= 0 && this->PlaceOf[b] == Place::Inside)
      {
        Join(parent, a, b);
      }
    }
  }
  std::vector<Piece> pieces;
  std::vector<Index> pieceOf(count, -1);
  for (Index p = 0; p < static_cast<Index>(count); ++p)
  {
    const Index root = cutOf[p] >= 0 ? FindRoot(parent, p) : -1;
    if (root == p)
    {
      pieceOf[p] = static_cast<Index>(pieces.size());
      pieces.push_back({ this->Input.PointIds[p], cutOf[p] });
    }
    pieceOf[p] = root < 0 ? -1 : pieceOf[root];
  }
  this->NumberPieces(pieces, pieceOf);
}

void SideFinder::NumberPieces(const std::vector<Piece>& pieces, const std::vector<Index>& pieceOf)
{
  Ranks& ranks = this->Parts.Group();
  const Index offset = OffsetOfPieces(ranks, static_cast<Index>(pieces.size()));
  std::vector<Index> numbers(pieceOf);
  for (Index& number : numbers)
  {
    number += number < 0 ? 0 : offset;
  }
  PiecePairs same;
  this->Shared.Fetch(numbers,
    [&](Index point, Index piece)
    {
      if (piece >= 0 && numbers[point] >= 0)
      {
        same.push_back({ { numbers[point], piece } });
      }
    });
  SortUnique(same);
  const std::vector<int> sides = NumberFragments(pieces, same, offset, ranks, this->CutOfSide);
  for (Index piece : pieceOf)
  {
    this->SideOfPoint.push_back(piece < 0 ? 0 : sides[piece]);
  }
}

} // namespace

Vector3 NormalOf(const Mesh& mesh, const Facet& facet)
{
  const auto x = [&](int c)
  {
    const double* point = mesh.Points.data() + 3 * facet.Points[c];
    return Vector3{ { point[0], point[1], point[2] } };
  };
  const Vector3 normal = Unit(Cross(x(2) - x(0), x(3) - x(1)));
  return facet.Fragments[0] < facet.Fragments[1] ? -1.0 * normal : normal;
}

SidePoints FindSidePoints(const std::vector<Facet>& facets, const std::vector<CreaseKind>& kinds,
  const Mesh& mesh, const Partition& partition)
{
  return SideFinder(facets, mesh, partition).Find(kinds);
}

} // namespace vfm
