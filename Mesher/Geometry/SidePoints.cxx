#include "Geometry/SidePoints.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Elements/PointValues.h"
#include "Labels/Fragments.h"

namespace vfm
{
namespace
{

constexpr int LongestGap = 3;       // maximum number of points from a carrier into a gap of an edge
constexpr double SharpCosine = .77; // cosine of 40 degrees, between facets at a point

bool IsInterface(const Facet& facet)
{
  return facet.DomainSide < 0;
}

using Pair = std::array<int, 2>;

/// Place of a point on the interfaces.
enum class Place : unsigned char
{
  None,
  Inside,
  OnEdge,
  Between ///< on several surfaces
};

/// Returns the points of interfaces, ascending.
std::vector<Index> ListPoints(const std::vector<Facet>& facets, int corners)
{
  std::vector<Index> points;
  for (const Facet& facet : facets)
  {
    if (IsInterface(facet))
    {
      points.insert(points.end(), facet.Points.begin(), facet.Points.begin() + corners);
    }
  }
  SortUnique(points);
  return points;
}

struct Work
{
  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const Partition& Parts;
  const int Corners = Input.CornersOfFacet();
  const PointValues Shared{ ListPoints(Facets, Corners), Input, Parts };
  std::vector<Place> PlaceOf{};  // place of every point
  std::vector<Pair> Cuts{};      // interfaces with edges, ascending
  std::vector<int> CutOfFacet{}; // position in Cuts, or -1
  std::vector<int> SideOfPoint{}, CutOfSide{};
};

void FindPlaces(Work& work, const std::vector<FeatureKind>& kinds)
{
  work.PlaceOf.assign(work.Input.PointIds.size(), Place::None);
  std::vector<Pair> first(work.PlaceOf.size());
  for (const Facet& facet : work.Facets)
  {
    for (int c = 0; c < work.Corners; ++c)
    {
      const Index p = facet.Points[c];
      Place& place = work.PlaceOf[p];
      if (place == Place::None)
      {
        first[p] = SurfaceOf(facet);
        place = !kinds.empty() && IsCarrier(kinds[p]) ? Place::OnEdge : Place::Inside;
      }
      place = first[p] == SurfaceOf(facet) ? place : Place::Between;
    }
  }
  work.Shared.Fetch(work.PlaceOf, [&](Index point, Place place) { work.PlaceOf[point] = place; });
}

bool IsNextToEdge(const Work& work, const int* first, const int* last)
{
  return std::any_of(first, last,
    [&](int f)
    {
      const std::array<Index, 4>& points = work.Facets[f].Points;
      return std::any_of(
        points.begin(), points.end(), [&](Index q) { return work.PlaceOf[q] == Place::OnEdge; });
    });
}

bool IsSharp(const Work& work, const int* first, const int* last)
{
  return std::any_of(first, last,
    [&](int f)
    {
      const Vector3 normal = NormalOf(work.Input, work.Facets[f]);
      return std::any_of(first, last,
        [&](int g) { return Dot(normal, NormalOf(work.Input, work.Facets[g])) < SharpCosine; });
    });
}

/// Extends edges over a few points that are not carriers but around which the facets turn.
void CloseGaps(Work& work)
{
  const Groups<int> around =
    ListFacetsAt(work.Facets, work.Input, [&](int f) { return IsInterface(work.Facets[f]); });
  for (int step = 0; step < LongestGap; ++step)
  {
    std::vector<Place> places(work.PlaceOf);
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      const int* first = around.Items.data() + around.Begin[p];
      const int* last = around.Items.data() + around.Begin[p + 1];
      if (places[p] == Place::Inside && IsNextToEdge(work, first, last) &&
        IsSharp(work, first, last))
      {
        places[p] = Place::OnEdge;
      }
    }
    work.PlaceOf.swap(places);
    work.Shared.Fetch(work.PlaceOf, [&](Index point, Place place) { work.PlaceOf[point] = place; });
  }
}

/// Finds the interfaces with edges on all ranks.
void FindCuts(Work& work)
{
  std::vector<Pair> cut;
  for (const Facet& facet : work.Facets)
  {
    if (IsInterface(facet) && facet.IsOwned &&
      std::any_of(facet.Points.begin(), facet.Points.end(),
        [&](Index p) { return work.PlaceOf[p] == Place::OnEdge; }))
    {
      cut.push_back(SurfaceOf(facet));
    }
  }
  SortUnique(cut);
  work.Cuts = GatherItems(work.Parts.Group(), cut);
  SortUnique(work.Cuts);
  for (const Facet& facet : work.Facets)
  {
    work.CutOfFacet.push_back(static_cast<int>(FindSorted(work.Cuts, SurfaceOf(facet))));
  }
}

void NumberPieces(Work& work, const std::vector<Piece>& pieces, const std::vector<Index>& pieceOf)
{
  Ranks& ranks = work.Parts.Group();
  const Index offset = OffsetOfPieces(ranks, static_cast<Index>(pieces.size()));
  std::vector<Index> numbers(pieceOf);
  for (Index& number : numbers)
  {
    number += number < 0 ? 0 : offset;
  }
  PiecePairs same;
  work.Shared.Fetch(numbers,
    [&](Index point, Index piece)
    {
      if (piece >= 0 && numbers[point] >= 0)
      {
        same.push_back({ { numbers[point], piece } });
      }
    });
  SortUnique(same);
  const std::vector<int> sides = NumberFragments(pieces, same, offset, ranks, work.CutOfSide);
  for (Index piece : pieceOf)
  {
    work.SideOfPoint.push_back(piece < 0 ? 0 : sides[piece]);
  }
}

/// Fills SideOfPoint: the side of points inside sides, 0 for other points.
void NumberPoints(Work& work)
{
  const std::size_t count = work.PlaceOf.size();
  std::vector<Index> parent = MakeSets(count);
  std::vector<int> cutOf(count, -1);
  for (std::size_t f = 0; f < work.Facets.size(); ++f)
  {
    const std::array<Index, 4>& points = work.Facets[f].Points;
    for (int c = 0; work.CutOfFacet[f] >= 0 && c < work.Corners; ++c)
    {
      const Index a = points[c], b = points[(c + 1) % work.Corners];
      cutOf[a] = work.PlaceOf[a] == Place::Inside ? work.CutOfFacet[f] : -1;
      if (cutOf[a] >= 0 && work.PlaceOf[b] == Place::Inside)
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
      pieces.push_back({ work.Input.PointIds[p], cutOf[p] });
    }
    pieceOf[p] = root < 0 ? -1 : pieceOf[root];
  }
  NumberPieces(work, pieces, pieceOf);
}

} // namespace

Vector3 NormalOf(const Mesh& mesh, const Facet& facet)
{
  const auto x = [&](int c) { return mesh.PointAt(facet.Points[c]); };
  const Vector3 normal = Unit(Cross(x(2) - x(0), x(3) - x(1)));
  return facet.Fragments[0] < facet.Fragments[1] ? -1.0 * normal : normal;
}

SidePoints FindSidePoints(const std::vector<Facet>& facets, const std::vector<FeatureKind>& kinds,
  const Mesh& mesh, const Partition& partition)
{
  Work work{ facets, mesh, partition };
  FindPlaces(work, kinds);
  CloseGaps(work);
  FindCuts(work);
  NumberPoints(work);
  return { std::move(work.CutOfFacet), static_cast<int>(work.Cuts.size()),
    std::move(work.SideOfPoint), std::move(work.CutOfSide) };
}

} // namespace vfm
