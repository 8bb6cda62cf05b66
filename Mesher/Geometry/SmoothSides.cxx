#include "Geometry/SmoothSides.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Geometry/FacetValues.h"
#include "Geometry/SidePoints.h"
#include "Ranks/KeyMerge.h"

#include <map>
#include <tuple>

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

constexpr int Undecided = -1;
constexpr int FewestTriangles = 12;   // minimum size of a side; a quad counts as two triangles
constexpr int FewTriangles = 36;      // minimum size if its border is smooth somewhere
constexpr double SmoothCosine = .906; // cosine of 25 degrees, between mean normals of facets

/// Common border of two sides of a cut interface.
struct Border
{
  Index Cut;
  Pair Sides;                      ///< the smaller first
  std::int64_t Edges, SmoothEdges; ///< numbers of facet edges
  double Cosine;                   ///< largest cosine between normals of facets across the border
};

using Borders = std::map<Pair, Border>;

/// Adds more of the same border.
void Combine(Border& border, const Border& more)
{
  border.Edges += more.Edges;
  border.SmoothEdges += more.SmoothEdges;
  border.Cosine = std::max(border.Cosine, more.Cosine);
}

void AddBorder(const Border& more, Borders& borders)
{
  const auto [at, isNew] = borders.emplace(more.Sides, more);
  if (!isNew)
  {
    Combine(at->second, more);
  }
}

/// Disjoint sets of sides with their numbers of triangles.
struct SideSets
{
  std::vector<Index> Parent;
  std::vector<std::int64_t> Triangles;

  explicit SideSets(std::vector<std::int64_t> triangles) :
    Parent(MakeSets(triangles.size())), Triangles(std::move(triangles))
  {
  }
  Index Root(Index side) { return FindRoot(this->Parent, side); }
  /// Returns whether a set is too small to remain a side.
  /// @param cosine  largest cosine between its normals and the normals of an adjacent side
  bool IsSliver(Index root, double cosine) const
  {
    return this->Triangles[root] < (cosine > SmoothCosine ? FewTriangles : FewestTriangles);
  }
  void Join(Index a, Index b)
  {
    const std::int64_t both = this->Triangles[this->Root(a)] + this->Triangles[this->Root(b)];
    vfm::Join(this->Parent, a, b);
    this->Triangles[this->Root(a)] = both;
  }
};

/// Joins sides if most of their border is smooth.
void JoinSmooth(const Borders& borders, SideSets& sets)
{
  for (const auto& [sides, border] : borders)
  {
    if (2 * border.SmoothEdges > border.Edges && sets.Root(sides[0]) != sets.Root(sides[1]))
    {
      sets.Join(sides[0], sides[1]);
    }
  }
}

/// Joins slivers with the adjacent side of the nearest normal until no sliver has an adjacent side.
void JoinSlivers(const Borders& borders, SideSets& sets)
{
  for (bool changes = true; changes;)
  {
    changes = false;
    std::map<Index, std::pair<double, Index>> nearest; // nearest side of each sliver
    for (const auto& [sides, border] : borders)
    {
      const Index ends[2] = { sets.Root(sides[0]), sets.Root(sides[1]) };
      for (int e = 0; ends[0] != ends[1] && e < 2; ++e)
      {
        if (sets.IsSliver(ends[e], border.Cosine))
        {
          const std::pair<double, Index> other(border.Cosine, ends[1 - e]);
          const auto at = nearest.emplace(ends[e], other).first;
          at->second = std::max(at->second, other);
        }
      }
    }
    for (const auto& [sliver, other] : nearest)
    {
      const Index a = sets.Root(sliver), b = sets.Root(other.second);
      if (a != b && sets.IsSliver(a, other.first))
      {
        sets.Join(a, b);
        changes = true;
      }
    }
  }
}

struct Decision
{
  std::array<Index, 4> Facet; // ids of its points, ascending
  Index Side;
  bool operator<(const Decision& other) const { return this->Facet < other.Facet; }
};

/// Returns the side of the points of a facet, or Undecided.
int SideOfPoints(const SidePoints& points, const Facet& facet)
{
  int side = 0;
  for (Index p : facet.Points)
  {
    const int other = points.SideOf[p];
    if (side > 0 && other > 0 && other != side)
    {
      return Undecided;
    }
    side = std::max(side, other);
  }
  return side > 0 ? side : Undecided;
}

/// Facets and their sides as far as decided. Sides of points come first; the others are the
/// remainders, one of each cut interface, for facets without an adjacent side.
struct SidedFacets
{
  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const SidePoints& Points;
  std::vector<int> SideOf; ///< side of every facet

  SidedFacets(const std::vector<Facet>& facets, const Mesh& mesh, const SidePoints& points) :
    Facets(facets), Input(mesh), Points(points)
  {
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      this->SideOf.push_back(points.CutOf[f] < 0 ? 0 : SideOfPoints(points, facets[f]));
    }
  }

  int Remainder(std::size_t f) const
  {
    return this->Points.NumberOfSides + 1 + this->Points.CutOf[f];
  }
  Vector3 Normal(std::size_t f) const { return NormalOf(this->Input, this->Facets[f]); }
  /// Returns the ids of the points of a facet, ascending.
  FacetKey KeyOf(std::size_t f) const { return KeyOfFacet(this->Input, this->Facets[f]); }
  /// Returns, for each point of the mesh, the adjacent facets that have a side.
  Groups<int> ListDecided() const
  {
    return ListFacetsAt(this->Facets, this->Input, [this](int f) { return this->SideOf[f] > 0; });
  }
};

/// Returns the facets of the same interface at the points of a facet.
std::vector<int> ListAdjacent(const SidedFacets& sided, std::size_t f, const Groups<int>& around)
{
  std::vector<int> beside;
  for (Index p : sided.Facets[f].Points)
  {
    std::copy_if(around.Items.data() + around.Begin[p], around.Items.data() + around.Begin[p + 1],
      std::back_inserter(beside),
      [&](int other) { return sided.Points.CutOf[other] == sided.Points.CutOf[f]; });
  }
  SortUnique(beside);
  return beside;
}

bool ShareEdge(const SidedFacets& sided, std::size_t f, std::size_t g)
{
  const int corners = sided.Input.CornersOfFacet();
  const std::array<Index, 4>& points = sided.Facets[f].Points;
  const std::array<Index, 4>& others = sided.Facets[g].Points;
  const auto end = others.begin() + corners;
  return std::count_if(points.begin(), points.begin() + corners,
           [&](Index p) { return std::find(others.begin(), end, p) != end; }) > 1;
}

/// A side adjacent to a facet.
struct AdjacentSide
{
  bool IsSmooth = false; ///< a facet of the side is nearly parallel
  int Edges = -1;        ///< number of common edges
  double Cosine = -2.0;  ///< largest cosine between the normals of its facets and of the facet
  int Side = 0;

  /// Orders sides by how well the facet continues them.
  bool operator<(const AdjacentSide& other) const
  {
    return std::tie(this->IsSmooth, this->Edges, this->Cosine, other.Side) <
      std::tie(other.IsSmooth, other.Edges, other.Cosine, this->Side);
  }
};

/// Returns the adjacent side of a facet that the facet continues best, other than its own. Without
/// such a side returns its own side, or the remainder of the interface.
/// @param prefersSmooth  false: the number of common edges decides, whether or not a side is smooth
AdjacentSide NearestSide(
  const SidedFacets& sided, std::size_t f, const Groups<int>& around, bool prefersSmooth)
{
  std::map<int, AdjacentSide> sides;
  const Vector3 normal = sided.Normal(f);
  for (int other : ListAdjacent(sided, f, around))
  {
    AdjacentSide& side = sides[sided.SideOf[other]];
    side.Side = sided.SideOf[other];
    side.Edges = std::max(side.Edges, 0) + ShareEdge(sided, f, other);
    side.Cosine = std::max(side.Cosine, Dot(normal, sided.Normal(other)));
    side.IsSmooth = prefersSmooth && side.Cosine > SmoothCosine;
  }
  const int own = sided.SideOf[f];
  AdjacentSide nearest;
  nearest.Side = own > 0 ? own : sided.Remainder(f);
  for (const auto& [side, its] : sides)
  {
    nearest = side != own ? std::max(nearest, its) : nearest;
  }
  return nearest;
}

void TakeDecisions(const Partition& partition, const std::vector<int>& loose,
  const std::vector<Decision>& mine, SidedFacets& sided)
{
  const std::vector<std::vector<Decision>> lists(partition.Peers().size(), mine);
  std::vector<Decision> told = Joined(partition.Exchange(lists));
  std::sort(told.begin(), told.end());
  for (int f : loose)
  {
    const Decision key{ sided.KeyOf(f), 0 };
    const auto at = std::lower_bound(told.begin(), told.end(), key);
    if (at != told.end() && at->Facet == key.Facet)
    {
      sided.SideOf[f] = static_cast<int>(at->Side);
    }
  }
}

/// Decides the sides of facets on their owners, which have all adjacent facets, and exchanges them.
/// @param choose  choose(f) returns the side of a facet, or Undecided to leave it as it is
template <class Choose>
void Decide(const Partition& partition, const std::vector<int>& loose, const Choose& choose,
  SidedFacets& sided)
{
  std::vector<int> decided(sided.SideOf);
  std::vector<Decision> mine;
  for (int f : loose)
  {
    const int side = sided.Facets[f].IsOwned ? choose(f) : Undecided;
    if (side != Undecided)
    {
      decided[f] = side;
      mine.push_back({ sided.KeyOf(f), side });
    }
  }
  sided.SideOf = std::move(decided);
  TakeDecisions(partition, loose, mine, sided);
}

/// Returns whether other facets of its side touch a facet only at a point, not
/// over common edges there.
bool IsPinched(const SidedFacets& sided, int f, const Groups<int>& around)
{
  return std::any_of(sided.Facets[f].Points.begin(), sided.Facets[f].Points.end(),
    [&](Index p)
    {
      std::vector<int> joined{ f }, apart;
      std::copy_if(around.Items.data() + around.Begin[p], around.Items.data() + around.Begin[p + 1],
        std::back_inserter(apart),
        [&](int g) { return g != f && sided.SideOf[g] == sided.SideOf[f]; });
      for (std::size_t next = 0; next < joined.size(); ++next)
      {
        const auto rest = std::partition(
          apart.begin(), apart.end(), [&](int g) { return !ShareEdge(sided, joined[next], g); });
        std::copy(rest, apart.end(), std::back_inserter(joined));
        apart.erase(rest, apart.end());
      }
      return !apart.empty();
    });
}

/// Decides facets whose points do not determine the side: first those that continue a side
/// smoothly, then the others. Then decides again those of them through which two parts of their
/// side would touch at a point.
void DecideOthers(const Partition& partition, SidedFacets& sided)
{
  std::vector<int> loose;
  for (std::size_t f = 0; f < sided.Facets.size(); ++f)
  {
    if (sided.SideOf[f] == Undecided)
    {
      loose.push_back(static_cast<int>(f));
    }
  }
  Groups<int> around = sided.ListDecided();
  const auto continueSmoothly = [&](int f)
  {
    const AdjacentSide nearest = NearestSide(sided, f, around, true);
    return nearest.IsSmooth ? nearest.Side : Undecided;
  };
  const auto takeNearest = [&](int f)
  { return sided.SideOf[f] == Undecided ? NearestSide(sided, f, around, true).Side : Undecided; };
  const auto unpinch = [&](int f)
  { return IsPinched(sided, f, around) ? NearestSide(sided, f, around, false).Side : Undecided; };
  Decide(partition, loose, continueSmoothly, sided);
  around = sided.ListDecided();
  Decide(partition, loose, takeNearest, sided);
  for (int f : loose)
  {
    if (sided.SideOf[f] == Undecided) // far from owned elements no rank may have decided
    {
      sided.SideOf[f] = sided.Remainder(f);
    }
  }
  around = sided.ListDecided();
  Decide(partition, loose, unpinch, sided);
}

/// Returns the unit mean normal of the facets of the side of f at the points that f and
/// g have in common.
Vector3 MeanNormal(
  const SidedFacets& sided, std::size_t f, std::size_t g, const Groups<int>& around)
{
  std::vector<std::pair<std::array<Index, 4>, int>> beside; // ordered by ids
  for (Index p : sided.Facets[f].Points)
  {
    const std::array<Index, 4>& others = sided.Facets[g].Points;
    const bool isShared = std::find(others.begin(), others.end(), p) != others.end();
    for (Index at = around.Begin[p]; isShared && at < around.Begin[p + 1]; ++at)
    {
      if (sided.SideOf[around.Items[at]] == sided.SideOf[f])
      {
        beside.emplace_back(sided.KeyOf(around.Items[at]), around.Items[at]);
      }
    }
  }
  SortUnique(beside);
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const auto& facet : beside)
  {
    sum = sum + sided.Normal(facet.second);
  }
  return Unit(sum);
}

/// Adds the common edge of two facets. The owner of the facet with the lower points counts it.
void AddEdge(const SidedFacets& sided, std::size_t f, std::size_t g, const Groups<int>& around,
  Borders& borders)
{
  const Pair sides{ { std::min(sided.SideOf[f], sided.SideOf[g]),
    std::max(sided.SideOf[f], sided.SideOf[g]) } };
  if (sides[0] != sides[1] && sided.Points.CutOf[f] == sided.Points.CutOf[g] &&
    sided.Facets[sided.KeyOf(f) < sided.KeyOf(g) ? f : g].IsOwned)
  {
    const double cosine = Dot(sided.Normal(f), sided.Normal(g));
    const bool isSmooth =
      Dot(MeanNormal(sided, f, g, around), MeanNormal(sided, g, f, around)) > SmoothCosine;
    AddBorder({ sided.Points.CutOf[f], sides, 1, isSmooth, cosine }, borders);
  }
}

/// Returns the borders from the facet edges that this rank counts.
Borders FindBorders(const SidedFacets& sided)
{
  const int corners = sided.Input.CornersOfFacet();
  std::vector<std::pair<std::array<Index, 2>, std::size_t>> places; // edge, facet
  for (std::size_t f = 0; f < sided.Facets.size(); ++f)
  {
    const std::array<Index, 4>& points = sided.Facets[f].Points;
    for (int c = 0; sided.Points.CutOf[f] >= 0 && c < corners; ++c)
    {
      const Index a = points[c], b = points[(c + 1) % corners];
      places.push_back({ { { std::min(a, b), std::max(a, b) } }, f });
    }
  }
  std::sort(places.begin(), places.end());
  const Groups<int> around = sided.ListDecided();
  Borders borders;
  ForRuns(
    places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first == b.first; },
    [&](auto first, auto last)
    {
      for (auto a = first; a != last; ++a)
      {
        std::for_each(a + 1, last,
          [&](const auto& b) { AddEdge(sided, a->second, b.second, around, borders); });
      }
    });
  return borders;
}

/// Side of a cut interface: numbers of both over all ranks.
using SideKey = std::array<Index, 2>;
/// Border of two sides of a cut interface, the side with the smaller number first.
using BorderKey = std::array<Index, 3>;

SideKey SideOfFacet(const SidedFacets& sided, std::size_t f)
{
  return { { sided.Points.CutOf[f], sided.SideOf[f] } };
}

/// Returns the sides of the facets of this rank, ascending.
std::vector<SideKey> ListSides(const SidedFacets& sided)
{
  std::vector<SideKey> sides;
  for (std::size_t f = 0; f < sided.Facets.size(); ++f)
  {
    if (sided.Points.CutOf[f] >= 0)
    {
      sides.push_back(SideOfFacet(sided, f));
    }
  }
  SortUnique(sides);
  return sides;
}

/// Returns the number of triangles of each side that this rank owns.
std::vector<std::int64_t> CountTriangles(
  const SidedFacets& sided, const std::vector<SideKey>& sides)
{
  std::vector<std::int64_t> triangles(sides.size(), 0);
  for (std::size_t f = 0; f < sided.Facets.size(); ++f)
  {
    if (sided.Points.CutOf[f] >= 0 && sided.Facets[f].IsOwned)
    {
      triangles[FindSorted(sides, SideOfFacet(sided, f))] += sided.Input.CornersOfFacet() - 2;
    }
  }
  return triangles;
}

/// Returns the borders of all ranks between sides whose home this rank is. Collective.
/// @param sides  these sides; borders have their positions
Borders FindBordersAtHome(const SidedFacets& sided, const std::vector<SideKey>& sides, Ranks& ranks)
{
  std::vector<std::pair<BorderKey, Border>> mine;
  for (const auto& [pair, border] : FindBorders(sided))
  {
    mine.push_back({ { { border.Cut, pair[0], pair[1] } }, border });
  }
  std::sort(
    mine.begin(), mine.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<BorderKey> keys;
  std::vector<Border> values;
  for (const auto& [key, border] : mine)
  {
    keys.push_back(key);
    values.push_back(border);
  }
  const KeyMerge<BorderKey> ways(std::move(keys), HomeOfFirst(ranks), ranks);
  Borders borders;
  for (Border border : ways.ToHome(std::move(values), 1, Combine))
  {
    for (int& side : border.Sides)
    {
      side = static_cast<int>(FindSorted(sides, SideKey{ { border.Cut, side } }));
    }
    borders.emplace(border.Sides, border);
  }
  return borders;
}

/// Returns the number of each side after sides have been joined; 0 if its interface has one side.
/// @param sides  sides with all sides of their interfaces, ascending
std::vector<Index> NumberJoined(const std::vector<SideKey>& sides, SideSets& sets)
{
  std::vector<Index> numbers(sides.size(), 0);
  ForRuns(
    sides.begin(), sides.end(), [](const SideKey& a, const SideKey& b) { return a[0] == b[0]; },
    [&](auto begin, auto end)
    {
      const Index first = begin - sides.begin(), last = end - sides.begin();
      int count = 0;
      for (Index side = first; side < last; ++side)
      {
        count += sets.Root(side) == side && sets.Triangles[side] > 0;
      }
      for (Index side = first; count > 1 && side < last; ++side)
      {
        numbers[side] = sides[sets.Root(side)][1];
      }
    });
  return numbers;
}

/// Joins sides. Facets of interfaces with one side get side 0. Interfaces do not depend on each
/// other, and each has a home that joins its sides. Collective.
void JoinSides(Ranks& ranks, SidedFacets& sided)
{
  const std::vector<SideKey> mine = ListSides(sided);
  const KeyMerge<SideKey> ways(mine, HomeOfFirst(ranks), ranks);
  const std::vector<SideKey>& sides = ways.HomeKeys();
  SideSets sets(
    ways.ToHome(CountTriangles(sided, mine), 1, [](std::int64_t& a, std::int64_t b) { a += b; }));
  const Borders borders = FindBordersAtHome(sided, sides, ranks);
  JoinSmooth(borders, sets);
  JoinSlivers(borders, sets);
  const std::vector<Index> numbers = ways.FromHome(NumberJoined(sides, sets), 1);
  for (std::size_t f = 0; f < sided.SideOf.size(); ++f)
  {
    sided.SideOf[f] = sided.Points.CutOf[f] < 0
      ? 0
      : static_cast<int>(numbers[FindSorted(mine, SideOfFacet(sided, f))]);
  }
}

} // namespace

std::vector<int> FindSmoothSides(const std::vector<Facet>& facets,
  const std::vector<FeatureKind>& kinds, const Mesh& mesh, const Partition& partition)
{
  if (!partition.Group().Any(std::any_of(kinds.begin(), kinds.end(), IsCarrier)))
  {
    return std::vector<int>(facets.size(), 0);
  }
  const SidePoints points = FindSidePoints(facets, kinds, mesh, partition);
  SidedFacets sided(facets, mesh, points);
  DecideOthers(partition, sided);
  JoinSides(partition.Group(), sided);
  return std::move(sided.SideOf);
}

} // namespace vfm
