#include "Geometry/GivenSides.h"

#include "Base/Sorted.h"
#include "Elements/GridCoordinates.h"
#include "Geometry/FacetValues.h"
#include "GivenSurfaces/BodySurfaces.h"
#include "Octree/RefinedGrid.h"
#include "Ranks/MergeByKey.h"
#include "Surfaces/TriangleSearch.h"

#include <cmath>
#include <limits>
#include <map>

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

constexpr double NormalWeight = 0.6, EdgeWeight = 0.2; // in sizes of facets
constexpr double LeastGain = 1e-9;
constexpr int MostRounds = 50;
constexpr double OnSide = 1e-6; // distance of a triangle from a side of the domain
constexpr double None = std::numeric_limits<double>::infinity();

/// Facet in grid coordinates.
struct Place
{
  Vector3 Centre, Normal; ///< the normal points out of the body
  double Size;            ///< about the length of its edges, at least 1
};

Place PlaceOf(const CartesianGrid& grid, const Mesh& mesh, const Facet& facet, int material)
{
  const int corners = CornersOf(facet.Points);
  std::array<Vector3, 4> x;
  for (int c = 0; c < 4; ++c)
  {
    x[c] = ToGrid(grid, mesh.Points.data() + 3 * facet.Points[c]);
  }
  Vector3 sum{};
  for (int c = 0; c < corners; ++c)
  {
    sum = sum + x[c];
  }
  const Vector3 normal = Cross(x[2] - x[0], x[3] - x[1]);
  const double sign = facet.Materials[0] == material ? 1.0 : -1.0;
  return { (1.0 / corners) * sum, sign * Unit(normal),
    std::max(1.0, std::sqrt(0.5 * Norm(normal))) };
}

/// Search for the sides of one body.
class SideSearch
{
public:
  SideSearch(const GivenBody& body, int firstSide, const BodySurfaces& surfaces, Runtime& runtime) :
    Body(body), First(firstSide), Search(PlaceTriangles(body.Boundary), runtime)
  {
    this->LeaveOutside(surfaces.Domain());
    const Vector3& periods = surfaces.Periods();
    for (int n = 0; n < 27; ++n)
    {
      const Index3 steps{ { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 } };
      Vector3 shift{};
      bool isNew = true;
      for (int a = 0; a < 3; ++a)
      {
        shift[a] = static_cast<double>(steps[a]) * periods[a];
        isNew = isNew && (steps[a] == 0 || periods[a] > 0.0);
      }
      if (isNew)
      {
        this->Shifts.push_back(shift);
      }
    }
  }

  /// Returns the side with the smallest rating at a facet, from 1 over all bodies; 0: there is
  /// none.
  int FindSide(const Place& place) const
  {
    const int triangle = this->FindTriangle(place, None, -1).Triangle;
    return triangle < 0 ? 0 : this->First + this->SideOf(triangle);
  }
  /// Returns the smallest rating of a side at a facet, or infinity if it is not below a limit.
  double RateSide(const Place& place, int side, double limit) const
  {
    const TriangleSearch::Rated found = this->FindTriangle(place, limit, side - this->First);
    return found.Triangle < 0 ? None : found.Rating;
  }

private:
  int SideOf(int triangle) const { return this->Body.Sides.SideOf[triangle]; }

  /// Excludes the triangles on sides of the domain and beyond, where no interface is.
  void LeaveOutside(const Bounds& domain)
  {
    for (std::size_t t = 0; t < this->Body.Boundary.Triangles.size(); ++t)
    {
      Bounds box;
      for (const Vector3& x : this->Search.Corners(static_cast<int>(t)))
      {
        box.Add(x);
      }
      bool isOutside = false;
      for (int a = 0; a < 3; ++a)
      {
        isOutside = isOutside || box.Upper[a] < domain.Lower[a] + OnSide ||
          box.Lower[a] > domain.Upper[a] - OnSide;
      }
      this->IsOutside.push_back(isOutside);
    }
  }

  /// @param side  side of the body; -1: all
  TriangleSearch::Rated FindTriangle(const Place& place, double limit, int side) const
  {
    TriangleSearch::Rated best{ -1, limit };
    for (const Vector3& shift : this->Shifts)
    {
      best = this->Search.FindBest(
        place.Centre + shift,
        [&](int t)
        {
          const double cosine = Dot(place.Normal, this->Body.Sheets.Normals[t]);
          return this->IsOutside[t] || (side >= 0 && this->SideOf(t) != side)
            ? None
            : NormalWeight * place.Size * std::max(0.0, 1.0 - cosine);
        },
        best);
    }
    return best;
  }

  const GivenBody& Body;
  int First; // number of its first side over all bodies
  TriangleSearch Search;
  std::vector<bool> IsOutside; // of each triangle
  std::vector<Vector3> Shifts; // to the copies of the domain
};

/// Facets on surfaces, their bodies and their neighbours.
struct SurfaceFacetList
{
  std::vector<int> Facets; ///< selected facets
  std::vector<int> BodyOf; ///< of each facet of the mesh; -1: none
  /// Neighbours of each facet on the same interface, one for each common edge.
  Groups<int> Neighbours;
};

Groups<int> FindNeighbours(
  const std::vector<int>& selected, const std::vector<Facet>& facets, const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  std::vector<std::pair<std::array<Index, 2>, int>> edges;
  for (int f : selected)
  {
    for (int c = 0; c < corners; ++c)
    {
      const Index a = facets[f].Points[c], b = facets[f].Points[(c + 1) % corners];
      edges.push_back({ { { std::min(a, b), std::max(a, b) } }, f });
    }
  }
  std::sort(edges.begin(), edges.end());
  return MakeGroups<int>(facets.size(),
    [&](const auto& visit)
    {
      ForRuns(
        edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first == b.first; },
        [&](auto first, auto last)
        {
          for (auto a = first; a != last; ++a)
          {
            for (auto b = first; b != last; ++b)
            {
              if (a != b && SurfaceOf(facets[a->second]) == SurfaceOf(facets[b->second]))
              {
                visit(a->second, b->second);
              }
            }
          }
        });
    });
}

SurfaceFacetList ListFacets(
  const std::vector<Facet>& facets, const Mesh& mesh, const BodySurfaces& surfaces)
{
  SurfaceFacetList list;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const Facet& facet = facets[f];
    const bool isInterface = facet.DomainSide < 0 && facet.Fragments[0] != facet.Fragments[1];
    list.BodyOf.push_back(
      isInterface ? surfaces.FindOfInterface(facet.Materials[0], facet.Materials[1]) : -1);
    if (list.BodyOf.back() >= 0)
    {
      list.Facets.push_back(static_cast<int>(f));
    }
  }
  list.Neighbours = FindNeighbours(list.Facets, facets, mesh);
  return list;
}

/// Change of the side of a facet that lowers the sum.
struct Change
{
  double Gain = 0.0;
  int Side = 0;
};

/// Sides of facets, which change until no single change lowers the sum.
class SideChanges
{
public:
  SideChanges(const std::vector<Facet>& facets, const Mesh& mesh, const SurfaceFacetList& list,
    const std::vector<SideSearch>& searches, const BodySurfaces& surfaces,
    const Partition& partition) :
    Facets(facets),
    TheMesh(mesh),
    List(list),
    Searches(searches),
    Surfaces(surfaces),
    Values(list.Facets, facets, mesh, partition),
    Group(partition.Group()),
    SideOf(facets.size(), 0),
    Ratings(facets.size())
  {
  }

  void FindNearest(Runtime& runtime)
  {
    ForEach(runtime, this->List.Facets.size(),
      [this](Index i)
      {
        const int f = this->List.Facets[i];
        if (this->Facets[f].IsOwned)
        {
          this->SideOf[f] = this->SearchAt(f).FindSide(this->PlaceAt(f));
        }
      });
    this->Values.Fetch(this->SideOf);
  }

  /// Changes the sides with the largest gains among their neighbours, round by round.
  void Improve(Runtime& runtime)
  {
    for (int round = 0, changes = 1; changes > 0 && round < MostRounds; ++round)
    {
      std::vector<Change> proposed(this->Facets.size());
      ForEach(runtime, this->List.Facets.size(),
        [&](Index i)
        {
          const int f = this->List.Facets[i];
          proposed[f] = this->Facets[f].IsOwned ? this->Propose(f) : Change();
        });
      this->Values.Fetch(proposed);
      std::vector<int> changed;
      std::copy_if(this->List.Facets.begin(), this->List.Facets.end(), std::back_inserter(changed),
        [&](int f) { return this->Facets[f].IsOwned && this->IsFirst(f, proposed); });
      for (int f : changed)
      {
        this->SideOf[f] = proposed[f].Side;
      }
      this->Values.Fetch(this->SideOf);
      changes = this->Group.Any(!changed.empty());
    }
  }

  std::vector<int> Take() { return std::move(this->SideOf); }

private:
  const SideSearch& SearchAt(int f) const { return this->Searches[this->List.BodyOf[f]]; }
  Place PlaceAt(int f) const
  {
    const int material = this->Surfaces.Bodies()[this->List.BodyOf[f]].Material;
    return PlaceOf(this->TheMesh.Levels->Finest(), this->TheMesh, this->Facets[f], material);
  }

  /// Returns the rating of a side at a facet, or infinity if it is above a limit.
  double Rate(int f, const Place& place, int side, double limit)
  {
    std::vector<std::pair<int, double>>& known = this->Ratings[f];
    const auto at = std::find_if(
      known.begin(), known.end(), [side](const auto& rating) { return rating.first == side; });
    if (at != known.end())
    {
      return at->second;
    }
    known.emplace_back(side, this->SearchAt(f).RateSide(place, side, limit));
    return known.back().second;
  }

  /// Returns the best change of a facet; Gain is 0 if there is none.
  Change Propose(int f)
  {
    std::map<int, int> edges; // number of edges to each side
    for (Index n = this->List.Neighbours.Begin[f]; n < this->List.Neighbours.Begin[f + 1]; ++n)
    {
      ++edges[this->SideOf[this->List.Neighbours.Items[n]]];
    }
    const int own = this->SideOf[f];
    Change best;
    if (edges.size() - edges.count(own) == 0)
    {
      return best;
    }
    const Place place = this->PlaceAt(f);
    const double ofEdge = EdgeWeight * place.Size;
    const double rating = this->Rate(f, place, own, None);
    for (const auto& [side, count] : edges)
    {
      // Ratings beyond this limit never pay.
      const double other = side == own ? None : this->Rate(f, place, side, rating + 4 * ofEdge);
      const double gain = rating - other + ofEdge * (count - (edges.count(own) ? edges[own] : 0));
      if (gain > std::max(best.Gain, LeastGain))
      {
        best = { gain, side };
      }
    }
    return best;
  }

  /// Returns whether the change of a facet is before those of its neighbours.
  bool IsFirst(int f, const std::vector<Change>& proposed) const
  {
    const Groups<int>& neighbours = this->List.Neighbours;
    return proposed[f].Gain > 0.0 &&
      std::all_of(neighbours.Items.data() + neighbours.Begin[f],
        neighbours.Items.data() + neighbours.Begin[f + 1],
        [&](int g)
        {
          return proposed[f].Gain != proposed[g].Gain ? proposed[f].Gain > proposed[g].Gain
                                                      : KeyOfFacet(this->TheMesh, this->Facets[f]) <
              KeyOfFacet(this->TheMesh, this->Facets[g]);
        });
  }

  const std::vector<Facet>& Facets;
  const Mesh& TheMesh;
  const SurfaceFacetList& List;
  const std::vector<SideSearch>& Searches;
  const BodySurfaces& Surfaces;
  FacetValues Values;
  Ranks& Group;
  std::vector<int> SideOf;
  std::vector<std::vector<std::pair<int, double>>> Ratings; // of sides at facets, as far as known
};

/// Sets the sides of interfaces with one side without a name to 0. Collective.
void LeaveWholes(const std::vector<Facet>& facets, Ranks& ranks, DividedFacets& sides)
{
  using Key = std::array<Index, 2>;
  using Bounds = std::array<int, 2>; // lowest and highest side
  std::vector<std::size_t> divided;
  std::vector<Key> keys;
  std::vector<Bounds> bounds;
  constexpr Bounds none{ { std::numeric_limits<int>::max(), 0 } };
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    if (const int side = sides.SideOf[f]; side > 0)
    {
      const Pair pair = SurfaceOf(facets[f]);
      divided.push_back(f);
      keys.push_back({ { pair[0], pair[1] } });
      bounds.push_back(facets[f].IsOwned ? Bounds{ { side, side } } : none);
    }
  }
  bounds = MergeByKey(
    keys, bounds,
    [](const Bounds& a, const Bounds& b) {
      return Bounds{ { std::min(a[0], b[0]), std::max(a[1], b[1]) } };
    },
    ranks);
  for (std::size_t i = 0; i < divided.size(); ++i)
  {
    if (bounds[i][0] == bounds[i][1] && sides.Names[bounds[i][0]].empty())
    {
      sides.SideOf[divided[i]] = 0;
    }
  }
}

} // namespace

DividedFacets FindGivenSides(const std::vector<Facet>& facets, const Mesh& mesh,
  const BodySurfaces& surfaces, const Partition& partition, Runtime& runtime)
{
  DividedFacets sides{ {}, { "" } };
  std::vector<SideSearch> searches;
  for (const GivenBody& body : surfaces.Bodies())
  {
    searches.emplace_back(body, static_cast<int>(sides.Names.size()), surfaces, runtime);
    sides.Names.insert(sides.Names.end(), body.Sides.Names.begin(), body.Sides.Names.end());
  }
  const SurfaceFacetList list = ListFacets(facets, mesh, surfaces);
  SideChanges changes(facets, mesh, list, searches, surfaces, partition);
  changes.FindNearest(runtime);
  changes.Improve(runtime);
  sides.SideOf = changes.Take();
  LeaveWholes(facets, partition.Group(), sides);
  return sides;
}

} // namespace vfm
