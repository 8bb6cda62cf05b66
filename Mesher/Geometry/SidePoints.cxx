#include "Geometry/SidePoints.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Elements/PointValues.h"
#include "Labels/JoinPieces.h"
#include "Ranks/NumberKeys.h"
#include "Ranks/NumberLimit.h"

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
using IndexPair = std::array<Index, 2>;

/// Returns the two sides of a facet as a key (SurfaceOf).
IndexPair PairOf(const Facet& facet)
{
  const Pair pair = SurfaceOf(facet);
  return { { pair[0], pair[1] } };
}

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

using Places = std::vector<Place>; // of every point

/// Sets the places of the points that this rank shares to those on their owners.
void Share(const PointValues& shared, Places& places)
{
  shared.Fetch(places, [&](Index point, Place place) { places[point] = place; });
}

Places FindPlaces(const std::vector<Facet>& facets, const std::vector<FeatureKind>& kinds,
  const Mesh& mesh, const PointValues& shared)
{
  const int corners = mesh.CornersOfFacet();
  Places places(mesh.PointIds.size(), Place::None);
  std::vector<Pair> first(places.size());
  for (const Facet& facet : facets)
  {
    for (int c = 0; c < corners; ++c)
    {
      const Index p = facet.Points[c];
      Place& place = places[p];
      if (place == Place::None)
      {
        first[p] = SurfaceOf(facet);
        place = !kinds.empty() && IsCarrier(kinds[p]) ? Place::OnEdge : Place::Inside;
      }
      place = first[p] == SurfaceOf(facet) ? place : Place::Between;
    }
  }
  Share(shared, places);
  return places;
}

/// Returns whether a facet of a list has a point on an edge.
bool IsNextToEdge(
  const std::vector<Facet>& facets, const Places& places, const int* first, const int* last)
{
  return std::any_of(first, last,
    [&](int f)
    {
      const std::array<Index, 4>& points = facets[f].Points;
      return std::any_of(
        points.begin(), points.end(), [&](Index q) { return places[q] == Place::OnEdge; });
    });
}

/// Returns whether the normals of a list of facets differ much.
bool IsSharp(const std::vector<Facet>& facets, const Mesh& mesh, const int* first, const int* last)
{
  return std::any_of(first, last,
    [&](int f)
    {
      const Vector3 normal = NormalOf(mesh, facets[f]);
      return std::any_of(
        first, last, [&](int g) { return Dot(normal, NormalOf(mesh, facets[g])) < SharpCosine; });
    });
}

/// Extends edges over a few points that are not carriers but around which the facets turn.
void CloseGaps(
  const std::vector<Facet>& facets, const Mesh& mesh, const PointValues& shared, Places& places)
{
  const Groups<int> around =
    ListFacetsAt(facets, mesh, [&](int f) { return IsInterface(facets[f]); });
  for (int step = 0; step < LongestGap; ++step)
  {
    Places closed(places);
    for (std::size_t p = 0; p < closed.size(); ++p)
    {
      const int* first = around.Items.data() + around.Begin[p];
      const int* last = around.Items.data() + around.Begin[p + 1];
      if (closed[p] == Place::Inside && IsNextToEdge(facets, places, first, last) &&
        IsSharp(facets, mesh, first, last))
      {
        closed[p] = Place::OnEdge;
      }
    }
    places.swap(closed);
    Share(shared, places);
  }
}

/// Returns whether interfaces have edges.
/// @param interfaces  those of the facets, ascending
std::vector<unsigned char> FindEdges(
  const std::vector<Facet>& facets, const Places& places, const std::vector<IndexPair>& interfaces)
{
  std::vector<unsigned char> hasEdge(interfaces.size(), 0);
  for (const Facet& facet : facets)
  {
    if (IsInterface(facet) && facet.IsOwned &&
      std::any_of(facet.Points.begin(), facet.Points.end(),
        [&](Index p) { return places[p] == Place::OnEdge; }))
    {
      hasEdge[FindSorted(interfaces, PairOf(facet))] = 1;
    }
  }
  return hasEdge;
}

/// Returns the number of the interface of each facet among those with edges, in the order of all
/// ranks, or -1. Collective.
std::vector<int> FindCuts(const std::vector<Facet>& facets, const Places& places, Ranks& ranks)
{
  std::vector<IndexPair> interfaces;
  for (const Facet& facet : facets)
  {
    if (IsInterface(facet))
    {
      interfaces.push_back(PairOf(facet));
    }
  }
  SortUnique(interfaces);
  std::vector<unsigned char> hasEdge = FindEdges(facets, places, interfaces);
  KeyMerge<IndexPair>(interfaces, ranks)
    .Merge(hasEdge, 1, [](unsigned char& a, unsigned char b) { a |= b; });
  std::vector<IndexPair> cuts;
  for (std::size_t i = 0; i < interfaces.size(); ++i)
  {
    if (hasEdge[i])
    {
      cuts.push_back(interfaces[i]);
    }
  }
  // Fragments have 31 bits.
  const KeyNumbers numbers = NumberKeys(
    cuts, [](const IndexPair& pair) { return (pair[0] << 31) + pair[1]; }, ranks);
  CheckNumberLimit(numbers.Total, "interfaces with edges");
  std::vector<int> cutOf;
  for (const Facet& facet : facets)
  {
    const auto cut = FindSorted(cuts, PairOf(facet));
    cutOf.push_back(cut < 0 ? -1 : static_cast<int>(numbers.Numbers[cut]));
  }
  return cutOf;
}

/// Pieces of sides on this rank.
struct LocalPieces
{
  std::vector<Piece> List;
  std::vector<Index> Of; ///< piece of each point, or -1
};

/// Joins the pieces of all ranks to sides. Collective.
/// @param[out] total  number of sides on all ranks
/// @return side of each point; 0: none
std::vector<int> NumberSides(
  const LocalPieces& pieces, const PointValues& shared, const Partition& partition, int& total)
{
  Ranks& ranks = partition.Group();
  std::vector<Index> numbers(pieces.Of);
  for (Index& number : numbers)
  {
    number += number < 0 ? 0 : OffsetOfRank(ranks);
  }
  PiecePairs same;
  shared.Fetch(numbers,
    [&](Index point, Index piece)
    {
      if (piece >= 0 && numbers[point] >= 0)
      {
        same.push_back({ { numbers[point], piece } });
      }
    });
  SortUnique(same);
  const JoinedPieces joined = JoinPieces(pieces.List, same, partition.Peers(), ranks);
  total = static_cast<int>(joined.Share.Total);
  std::vector<int> sideOf;
  for (Index piece : pieces.Of)
  {
    sideOf.push_back(piece < 0 ? 0 : joined.Share.Ids[joined.Fragments[piece]]);
  }
  return sideOf;
}

/// Joins the points inside interfaces with edges over the edges of facets.
LocalPieces FindPieces(const std::vector<Facet>& facets, const std::vector<int>& cutOfFacet,
  const Places& places, const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  const std::size_t count = places.size();
  std::vector<Index> parent = MakeSets(count);
  std::vector<int> cutOf(count, -1);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const std::array<Index, 4>& points = facets[f].Points;
    for (int c = 0; cutOfFacet[f] >= 0 && c < corners; ++c)
    {
      const Index a = points[c], b = points[(c + 1) % corners];
      cutOf[a] = places[a] == Place::Inside ? cutOfFacet[f] : -1;
      if (cutOf[a] >= 0 && places[b] == Place::Inside)
      {
        Join(parent, a, b);
      }
    }
  }
  LocalPieces pieces{ {}, std::vector<Index>(count, -1) };
  for (Index p = 0; p < static_cast<Index>(count); ++p)
  {
    const Index root = cutOf[p] >= 0 ? FindRoot(parent, p) : -1;
    if (root == p)
    {
      pieces.Of[p] = static_cast<Index>(pieces.List.size());
      pieces.List.push_back({ mesh.PointIds[p], cutOf[p] });
    }
    pieces.Of[p] = root < 0 ? -1 : pieces.Of[root];
  }
  return pieces;
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
  const PointValues shared(ListPoints(facets, mesh.CornersOfFacet()), mesh, partition);
  Places places = FindPlaces(facets, kinds, mesh, shared);
  CloseGaps(facets, mesh, shared, places);
  SidePoints sides;
  sides.CutOf = FindCuts(facets, places, partition.Group());
  sides.SideOf = NumberSides(
    FindPieces(facets, sides.CutOf, places, mesh), shared, partition, sides.NumberOfSides);
  return sides;
}

} // namespace vfm
