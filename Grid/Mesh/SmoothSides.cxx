#include "Mesh/SmoothSides.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Mesh/SidePoints.h"

#include <map>
#include <tuple>

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

constexpr int Undecided = -1;
constexpr int FewestTriangles = 12;   // of a side; quads count as two
constexpr int FewTriangles = 36;      // of one beside another that it goes on in smoothly somewhere
constexpr double SmoothCosine = .906; // of 25 degrees between means of facets

/// The border of two sides, the smaller first.
struct Border
{
  Pair Sides;
  std::int64_t Edges, SmoothEdges; ///< of facets
  double Cosine;                   ///< the largest between normals across it
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

/// Disjoint sets of sides, with the number of their triangles.
struct SideSets
{
  std::vector<Index> Parent;
  std::vector<std::int64_t> Triangles;

  explicit SideSets(std::vector<std::int64_t> triangles) :
    Parent(MakeSets(triangles.size())), Triangles(std::move(triangles))
  {
  }
  Index Root(Index side) { return FindRoot(this->Parent, side); }
  /// cosine: the largest between its normals and those of a side beside it.
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

/// Joins sides whose border is no edge: most of it is smooth.
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

/// Joins sides of few triangles with the nearest beside them until none is left that has one.
void JoinSlivers(const Borders& borders, SideSets& sets)
{
  for (bool changes = true; changes;)
  {
    changes = false;
    std::map<Index, std::pair<double, Index>> nearest; // of each sliver
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

class SideFinder
{
public:
  SideFinder(const std::vector<Facet>& facets, const std::vector<CreaseKind>& kinds,
    const Mesh& mesh, const Partition& partition) :
    Facets(facets),
    Input(mesh),
    Parts(partition),
    Corners(mesh.CornersOfFacet()),
    Points(FindSidePoints(facets, kinds, mesh, partition)),
    PiecesEnd(static_cast<int>(this->Points.CutsOfSides.size())),
    CutOfSide(this->Points.CutsOfSides)
  {
    for (int cut = 0; cut < this->Points.NumberOfCuts; ++cut)
    {
      this->CutOfSide.push_back(cut);
    }
  }

  std::vector<int> Find()
  {
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      this->SideOf.push_back(this->Points.CutOf[f] < 0 ? 0 : this->SideOfPoints(this->Facets[f]));
    }
    this->DecideOthers();
    this->JoinSides();
    return std::move(this->SideOf);
  }

private:
  int SideOfPoints(const Facet& facet) const
  {
    int side = 0;
    for (Index p : facet.Points)
    {
      const int other = this->Points.SideOf[p];
      if (side > 0 && other > 0 && other != side)
      {
        return Undecided;
      }
      side = std::max(side, other);
    }
    return side > 0 ? side : Undecided;
  }

  /// Facets whose points do not tell. Then those of them through which two parts of their side would touch in a point.
  void DecideOthers()
  {
    std::vector<int> loose;
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      if (this->SideOf[f] == Undecided)
      {
        loose.push_back(static_cast<int>(f));
      }
    }
    const auto isDecided = [this](int f) { return this->SideOf[f] > 0; };
    this->Decide(
      loose, ListFacetsAt(this->Facets, this->Input, isDecided), [](int) { return true; });
    const Groups<int> around = ListFacetsAt(this->Facets, this->Input, isDecided);
    this->Decide(loose, around, [&](int f) { return this->IsPinched(f, around); });
  }

  /// The owner of a facet knows all those around it.
  template <class Condition>
  void Decide(const std::vector<int>& loose, const Groups<int>& around, const Condition& isWanted)
  {
    std::vector<int> decided(this->SideOf);
    std::vector<Decision> mine;
    for (int f : loose)
    {
      if (this->Facets[f].IsOwned && isWanted(f))
      {
        decided[f] = this->NearestSide(f, around);
        mine.push_back({ this->KeyOf(f), decided[f] });
      }
    }
    this->SideOf = std::move(decided);
    this->TakeDecisions(loose, mine);
  }

  struct Decision
  {
    std::array<Index, 4> Facet; // ids of its points, ascending
    Index Side;
    bool operator<(const Decision& other) const { return this->Facet < other.Facet; }
  };

  std::array<Index, 4> KeyOf(std::size_t f) const
  {
    std::array<Index, 4> key;
    std::transform(this->Facets[f].Points.begin(), this->Facets[f].Points.end(), key.begin(),
      [this](Index p) { return this->Input.PointIds[p]; });
    std::sort(key.begin(), key.end());
    return key;
  }

  /// Another side around a facet than its own, that which has most of its edges, the nearest normal where several do. Where there is none:
  /// what is left of the interface is one more side.
  int NearestSide(std::size_t f, const Groups<int>& around) const
  {
    struct Around
    {
      int Edges = 0;
      double Cosine = -2.0;
    };
    std::map<int, Around> sides;
    const Vector3 normal = NormalOf(this->Input, this->Facets[f]);
    for (int other : this->ListBeside(f, around))
    {
      Around& side = sides[this->SideOf[other]];
      side.Edges += this->ShareEdge(f, other);
      side.Cosine = std::max(side.Cosine, Dot(normal, NormalOf(this->Input, this->Facets[other])));
    }
    const int own = this->SideOf[f];
    const int rest = own > 0 ? own : this->PiecesEnd + this->Points.CutOf[f];
    std::tuple<int, double, int> nearest(-1, 0.0, -rest);
    for (const auto& [side, its] : sides)
    {
      if (side != own)
      {
        nearest = std::max(nearest, { its.Edges, its.Cosine, -side });
      }
    }
    return -std::get<2>(nearest);
  }

  /// Whether facets of its side at one of its points are not joined to it over edges there.
  bool IsPinched(int f, const Groups<int>& around) const
  {
    return std::any_of(this->Facets[f].Points.begin(), this->Facets[f].Points.end(),
      [&](Index p)
      {
        std::vector<int> joined{ f }, apart;
        std::copy_if(around.Items.data() + around.Begin[p],
          around.Items.data() + around.Begin[p + 1], std::back_inserter(apart),
          [&](int g) { return g != f && this->SideOf[g] == this->SideOf[f]; });
        for (std::size_t next = 0; next < joined.size(); ++next)
        {
          const auto rest = std::partition(
            apart.begin(), apart.end(), [&](int g) { return !this->ShareEdge(joined[next], g); });
          std::copy(rest, apart.end(), std::back_inserter(joined));
          apart.erase(rest, apart.end());
        }
        return !apart.empty();
      });
  }

  /// The facets of the same interface at its points.
  std::vector<int> ListBeside(std::size_t f, const Groups<int>& around) const
  {
    std::vector<int> beside;
    for (Index p : this->Facets[f].Points)
    {
      std::copy_if(around.Items.data() + around.Begin[p], around.Items.data() + around.Begin[p + 1],
        std::back_inserter(beside),
        [&](int other) { return this->Points.CutOf[other] == this->Points.CutOf[f]; });
    }
    SortUnique(beside);
    return beside;
  }

  bool ShareEdge(std::size_t f, std::size_t g) const
  {
    const auto begin = this->Facets[g].Points.begin(), end = begin + this->Corners;
    return std::count_if(this->Facets[f].Points.begin(),
             this->Facets[f].Points.begin() + this->Corners,
             [&](Index p) { return std::find(begin, end, p) != end; }) > 1;
  }

  void TakeDecisions(const std::vector<int>& loose, const std::vector<Decision>& mine)
  {
    const std::vector<Bytes> messages(this->Parts.Peers().size(), ToBytes(mine));
    std::vector<Decision> told =
      JoinItems<Decision>(this->Parts.Group().Exchange(this->Parts.Peers(), messages));
    std::sort(told.begin(), told.end());
    for (int f : loose)
    {
      const Decision key{ this->KeyOf(f), 0 };
      const auto at = std::lower_bound(told.begin(), told.end(), key);
      if (at != told.end() && at->Facet == key.Facet)
      {
        this->SideOf[f] = static_cast<int>(at->Side);
      }
      else if (this->SideOf[f] == Undecided) // beyond the rim nobody may have decided
      {
        this->SideOf[f] = this->PiecesEnd + this->Points.CutOf[f];
      }
    }
  }

  void JoinSides()
  {
    Ranks& ranks = this->Parts.Group();
    std::vector<std::int64_t> triangles(this->CutOfSide.size(), 0);
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      triangles[this->SideOf[f]] += this->Facets[f].IsOwned ? this->Corners - 2 : 0;
    }
    ranks.Sum(triangles);
    std::vector<Border> mine;
    for (const auto& border : this->FindBorders())
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
    std::vector<int> parts(this->Points.NumberOfCuts, 0); // sides of each interface
    for (std::size_t side = 1; side < triangles.size(); ++side)
    {
      const Index root = sets.Root(side);
      parts[this->CutOfSide[side]] += sets.Triangles[root] > 0 && root == static_cast<Index>(side);
    }
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const bool isCut = this->Points.CutOf[f] >= 0 && parts[this->Points.CutOf[f]] > 1;
      this->SideOf[f] = isCut ? static_cast<int>(sets.Root(this->SideOf[f])) : 0;
    }
  }

  /// At edges of facets that this rank counts.
  Borders FindBorders() const
  {
    struct Place
    {
      std::array<Index, 2> Edge;
      std::size_t Facet;
      bool operator<(const Place& other) const { return this->Edge < other.Edge; }
    };
    std::vector<Place> places;
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const std::array<Index, 4>& points = this->Facets[f].Points;
      for (int c = 0; this->Points.CutOf[f] >= 0 && c < this->Corners; ++c)
      {
        const Index a = points[c], b = points[(c + 1) % this->Corners];
        places.push_back({ { { std::min(a, b), std::max(a, b) } }, f });
      }
    }
    std::sort(places.begin(), places.end());
    const Groups<int> around =
      ListFacetsAt(this->Facets, this->Input, [this](int f) { return this->SideOf[f] > 0; });
    Borders borders;
    for (auto first = places.begin(), last = first; first != places.end(); first = last)
    {
      last = std::upper_bound(first, places.end(), *first);
      for (auto a = first; a != last; ++a)
      {
        for (auto b = a + 1; b != last; ++b)
        {
          this->AddEdge(a->Facet, b->Facet, around, borders);
        }
      }
    }
    return borders;
  }

  /// Of two facets that share it; the owner of that with the lower points counts it.
  void AddEdge(std::size_t f, std::size_t g, const Groups<int>& around, Borders& borders) const
  {
    const Pair sides{ { std::min(this->SideOf[f], this->SideOf[g]),
      std::max(this->SideOf[f], this->SideOf[g]) } };
    if (sides[0] != sides[1] && this->Points.CutOf[f] == this->Points.CutOf[g] &&
      this->Facets[this->KeyOf(f) < this->KeyOf(g) ? f : g].IsOwned)
    {
      const double cosine =
        Dot(NormalOf(this->Input, this->Facets[f]), NormalOf(this->Input, this->Facets[g]));
      const bool isSmooth =
        Dot(this->MeanNormal(f, g, around), this->MeanNormal(g, f, around)) > SmoothCosine;
      AddBorder({ sides, 1, isSmooth, cosine }, borders);
    }
  }

  /// Of the facets of the side of f at the points that it shares with g; unit.
  Vector3 MeanNormal(std::size_t f, std::size_t g, const Groups<int>& around) const
  {
    std::vector<std::pair<std::array<Index, 4>, int>> beside; // in the order of ids
    for (Index p : this->Facets[f].Points)
    {
      const std::array<Index, 4>& others = this->Facets[g].Points;
      const bool isShared = std::find(others.begin(), others.end(), p) != others.end();
      for (Index at = around.Begin[p]; isShared && at < around.Begin[p + 1]; ++at)
      {
        if (this->SideOf[around.Items[at]] == this->SideOf[f])
        {
          beside.emplace_back(this->KeyOf(around.Items[at]), around.Items[at]);
        }
      }
    }
    SortUnique(beside);
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    for (const auto& facet : beside)
    {
      sum = sum + NormalOf(this->Input, this->Facets[facet.second]);
    }
    return Unit(sum);
  }

  const std::vector<Facet>& Facets;
  const Mesh& Input;
  const Partition& Parts;
  const int Corners; // of a facet
  const SidePoints Points;
  const int PiecesEnd;        // the first side that is what is left of an interface
  std::vector<int> CutOfSide; // [0] unused; those of points, then one more of each interface
  std::vector<int> SideOf;    // of every facet
};

} // namespace

std::vector<int> FindSmoothSides(const std::vector<Facet>& facets,
  const std::vector<CreaseKind>& kinds, const Mesh& mesh, const Partition& partition)
{
  if (!partition.Group().Any(std::any_of(kinds.begin(), kinds.end(), IsCarrier)))
  {
    return std::vector<int>(facets.size(), 0);
  }
  return SideFinder(facets, kinds, mesh, partition).Find();
}

} // namespace vfm
