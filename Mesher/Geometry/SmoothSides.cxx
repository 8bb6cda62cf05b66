#include "Geometry/SmoothSides.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Geometry/SidePoints.h"

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

/// Common border of two sides.
struct Border
{
  Pair Sides;                      ///< the smaller first
  std::int64_t Edges, SmoothEdges; ///< numbers of facet edges
  double Cosine;                   ///< largest cosine between normals of facets across the border
};

using Borders = std::map<Pair, Border>;

void AddBorder(const Border& more, Borders& borders)
{
  const auto [at, isNew] = borders.emplace(more.Sides, more);
  if (!isNew)
  {
    at->second.Edges += more.Edges;
    at->second.SmoothEdges += more.SmoothEdges;
    at->second.Cosine = std::max(at->second.Cosine, more.Cosine);
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

struct Work
{
  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const Partition& Parts;
  const SidePoints Points;
  const int Corners = Input.CornersOfFacet();
  /// Number of the first remainder side: each cut interface has one for facets
  /// without an adjacent side.
  const int PiecesEnd = static_cast<int>(Points.CutsOfSides.size());
  /// Cut interface of each side; [0] is not used. Sides of points come first, then the remainders.
  std::vector<int> CutOfSide = Points.CutsOfSides;
  std::vector<int> SideOf{}; // side of every facet
};

int SideOfPoints(const Work& work, const Facet& facet)
{
  int side = 0;
  for (Index p : facet.Points)
  {
    const int other = work.Points.SideOf[p];
    if (side > 0 && other > 0 && other != side)
    {
      return Undecided;
    }
    side = std::max(side, other);
  }
  return side > 0 ? side : Undecided;
}

std::array<Index, 4> KeyOf(const Work& work, std::size_t f)
{
  std::array<Index, 4> key;
  std::transform(work.Facets[f].Points.begin(), work.Facets[f].Points.end(), key.begin(),
    [&](Index p) { return IdOfOwner(work.Input, work.Input.PointIds[p]); });
  std::sort(key.begin(), key.end());
  return key;
}

/// Returns the facets of the same interface at the points of a facet.
std::vector<int> ListAdjacent(const Work& work, std::size_t f, const Groups<int>& around)
{
  std::vector<int> beside;
  for (Index p : work.Facets[f].Points)
  {
    std::copy_if(around.Items.data() + around.Begin[p], around.Items.data() + around.Begin[p + 1],
      std::back_inserter(beside),
      [&](int other) { return work.Points.CutOf[other] == work.Points.CutOf[f]; });
  }
  SortUnique(beside);
  return beside;
}

bool ShareEdge(const Work& work, std::size_t f, std::size_t g)
{
  const auto begin = work.Facets[g].Points.begin(), end = begin + work.Corners;
  return std::count_if(work.Facets[f].Points.begin(), work.Facets[f].Points.begin() + work.Corners,
           [&](Index p) { return std::find(begin, end, p) != end; }) > 1;
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
  const Work& work, std::size_t f, const Groups<int>& around, bool prefersSmooth)
{
  std::map<int, AdjacentSide> sides;
  const Vector3 normal = NormalOf(work.Input, work.Facets[f]);
  for (int other : ListAdjacent(work, f, around))
  {
    AdjacentSide& side = sides[work.SideOf[other]];
    side.Side = work.SideOf[other];
    side.Edges = std::max(side.Edges, 0) + ShareEdge(work, f, other);
    side.Cosine = std::max(side.Cosine, Dot(normal, NormalOf(work.Input, work.Facets[other])));
    side.IsSmooth = prefersSmooth && side.Cosine > SmoothCosine;
  }
  const int own = work.SideOf[f];
  AdjacentSide nearest;
  nearest.Side = own > 0 ? own : work.PiecesEnd + work.Points.CutOf[f];
  for (const auto& [side, its] : sides)
  {
    nearest = side != own ? std::max(nearest, its) : nearest;
  }
  return nearest;
}

void TakeDecisions(Work& work, const std::vector<int>& loose, const std::vector<Decision>& mine)
{
  const std::vector<std::vector<Decision>> lists(work.Parts.Peers().size(), mine);
  std::vector<Decision> told = Joined(work.Parts.Exchange(lists));
  std::sort(told.begin(), told.end());
  for (int f : loose)
  {
    const Decision key{ KeyOf(work, f), 0 };
    const auto at = std::lower_bound(told.begin(), told.end(), key);
    if (at != told.end() && at->Facet == key.Facet)
    {
      work.SideOf[f] = static_cast<int>(at->Side);
    }
  }
}

/// Decides the sides of facets on their owners, which have all adjacent facets, and exchanges them.
/// @param around  facets with a side, at each point
/// @param isTaken  whether the nearest side (AdjacentSide) of a facet is taken
template <class Condition>
void Decide(Work& work, const std::vector<int>& loose, const Groups<int>& around,
  const Condition& isTaken, bool prefersSmooth = true)
{
  std::vector<int> decided(work.SideOf);
  std::vector<Decision> mine;
  for (int f : loose)
  {
    if (work.Facets[f].IsOwned)
    {
      const AdjacentSide nearest = NearestSide(work, f, around, prefersSmooth);
      if (isTaken(f, nearest))
      {
        decided[f] = nearest.Side;
        mine.push_back({ KeyOf(work, f), nearest.Side });
      }
    }
  }
  work.SideOf = std::move(decided);
  TakeDecisions(work, loose, mine);
}

/// Returns whether other facets of its side touch a facet only at a point, not
/// over common edges there.
bool IsPinched(const Work& work, int f, const Groups<int>& around)
{
  return std::any_of(work.Facets[f].Points.begin(), work.Facets[f].Points.end(),
    [&](Index p)
    {
      std::vector<int> joined{ f }, apart;
      std::copy_if(around.Items.data() + around.Begin[p], around.Items.data() + around.Begin[p + 1],
        std::back_inserter(apart),
        [&](int g) { return g != f && work.SideOf[g] == work.SideOf[f]; });
      for (std::size_t next = 0; next < joined.size(); ++next)
      {
        const auto rest = std::partition(
          apart.begin(), apart.end(), [&](int g) { return !ShareEdge(work, joined[next], g); });
        std::copy(rest, apart.end(), std::back_inserter(joined));
        apart.erase(rest, apart.end());
      }
      return !apart.empty();
    });
}

/// Decides facets whose points do not determine the side: first those that continue a side
/// smoothly, then the others. Then decides again those of them through which two parts of their
/// side would touch at a point.
void DecideOthers(Work& work)
{
  std::vector<int> loose;
  for (std::size_t f = 0; f < work.Facets.size(); ++f)
  {
    if (work.SideOf[f] == Undecided)
    {
      loose.push_back(static_cast<int>(f));
    }
  }
  const auto listDecided = [&work]
  { return ListFacetsAt(work.Facets, work.Input, [&](int f) { return work.SideOf[f] > 0; }); };
  Decide(work, loose, listDecided(), [](int, const AdjacentSide& side) { return side.IsSmooth; });
  Decide(work, loose, listDecided(),
    [&work](int f, const AdjacentSide&) { return work.SideOf[f] == Undecided; });
  for (int f : loose)
  {
    if (work.SideOf[f] == Undecided) // far from owned elements no rank may have decided
    {
      work.SideOf[f] = work.PiecesEnd + work.Points.CutOf[f];
    }
  }
  const Groups<int> around = listDecided();
  Decide(
    work, loose, around, [&](int f, const AdjacentSide&) { return IsPinched(work, f, around); },
    false);
}

/// Returns the unit mean normal of the facets of the side of f at the points that f and
/// g have in common.
Vector3 MeanNormal(const Work& work, std::size_t f, std::size_t g, const Groups<int>& around)
{
  std::vector<std::pair<std::array<Index, 4>, int>> beside; // ordered by ids
  for (Index p : work.Facets[f].Points)
  {
    const std::array<Index, 4>& others = work.Facets[g].Points;
    const bool isShared = std::find(others.begin(), others.end(), p) != others.end();
    for (Index at = around.Begin[p]; isShared && at < around.Begin[p + 1]; ++at)
    {
      if (work.SideOf[around.Items[at]] == work.SideOf[f])
      {
        beside.emplace_back(KeyOf(work, around.Items[at]), around.Items[at]);
      }
    }
  }
  SortUnique(beside);
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (const auto& facet : beside)
  {
    sum = sum + NormalOf(work.Input, work.Facets[facet.second]);
  }
  return Unit(sum);
}

/// Adds the common edge of two facets. The owner of the facet with the lower points counts it.
void AddEdge(
  const Work& work, std::size_t f, std::size_t g, const Groups<int>& around, Borders& borders)
{
  const Pair sides{ { std::min(work.SideOf[f], work.SideOf[g]),
    std::max(work.SideOf[f], work.SideOf[g]) } };
  if (sides[0] != sides[1] && work.Points.CutOf[f] == work.Points.CutOf[g] &&
    work.Facets[KeyOf(work, f) < KeyOf(work, g) ? f : g].IsOwned)
  {
    const double cosine =
      Dot(NormalOf(work.Input, work.Facets[f]), NormalOf(work.Input, work.Facets[g]));
    const bool isSmooth =
      Dot(MeanNormal(work, f, g, around), MeanNormal(work, g, f, around)) > SmoothCosine;
    AddBorder({ sides, 1, isSmooth, cosine }, borders);
  }
}

/// Returns the borders from the facet edges that this rank counts.
Borders FindBorders(const Work& work)
{
  std::vector<std::pair<std::array<Index, 2>, std::size_t>> places; // edge, facet
  for (std::size_t f = 0; f < work.Facets.size(); ++f)
  {
    const std::array<Index, 4>& points = work.Facets[f].Points;
    for (int c = 0; work.Points.CutOf[f] >= 0 && c < work.Corners; ++c)
    {
      const Index a = points[c], b = points[(c + 1) % work.Corners];
      places.push_back({ { { std::min(a, b), std::max(a, b) } }, f });
    }
  }
  std::sort(places.begin(), places.end());
  const Groups<int> around =
    ListFacetsAt(work.Facets, work.Input, [&](int f) { return work.SideOf[f] > 0; });
  Borders borders;
  ForRuns(
    places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first == b.first; },
    [&](auto first, auto last)
    {
      for (auto a = first; a != last; ++a)
      {
        std::for_each(
          a + 1, last, [&](const auto& b) { AddEdge(work, a->second, b.second, around, borders); });
      }
    });
  return borders;
}

void JoinSides(Work& work)
{
  Ranks& ranks = work.Parts.Group();
  std::vector<std::int64_t> triangles(work.CutOfSide.size(), 0);
  for (std::size_t f = 0; f < work.Facets.size(); ++f)
  {
    triangles[work.SideOf[f]] += work.Facets[f].IsOwned ? work.Corners - 2 : 0;
  }
  ranks.Sum(triangles);
  std::vector<Border> mine;
  for (const auto& border : FindBorders(work))
  {
    mine.push_back(border.second);
  }
  Borders borders;
  for (const Border& border : GatherItems(ranks, mine))
  {
    AddBorder(border, borders);
  }
  SideSets sets(triangles);
  JoinSmooth(borders, sets);
  JoinSlivers(borders, sets);
  std::vector<int> parts(work.Points.NumberOfCuts, 0); // number of sides of each interface
  for (std::size_t side = 1; side < triangles.size(); ++side)
  {
    const Index root = sets.Root(side);
    parts[work.CutOfSide[side]] += sets.Triangles[root] > 0 && root == static_cast<Index>(side);
  }
  for (std::size_t f = 0; f < work.Facets.size(); ++f)
  {
    const bool isCut = work.Points.CutOf[f] >= 0 && parts[work.Points.CutOf[f]] > 1;
    work.SideOf[f] = isCut ? static_cast<int>(sets.Root(work.SideOf[f])) : 0;
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
  Work work{ facets, mesh, partition, FindSidePoints(facets, kinds, mesh, partition) };
  for (int cut = 0; cut < work.Points.NumberOfCuts; ++cut)
  {
    work.CutOfSide.push_back(cut);
  }
  for (std::size_t f = 0; f < work.Facets.size(); ++f)
  {
    work.SideOf.push_back(work.Points.CutOf[f] < 0 ? 0 : SideOfPoints(work, work.Facets[f]));
  }
  DecideOthers(work);
  JoinSides(work);
  return std::move(work.SideOf);
}

} // namespace vfm
