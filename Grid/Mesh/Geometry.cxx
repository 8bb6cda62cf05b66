#include "Mesh/Geometry.h"

#include "Base/Sorted.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

/// A surface: what lies on its two sides, the smaller first: fragments, 0 not meshed, -1 - side beyond a side of the domain.
using SurfaceKey = std::array<int, 2>;

SurfaceKey KeyOf(const Facet& facet)
{
  const int before = facet.DomainSide < 0 ? facet.Fragments[1] : -1 - facet.DomainSide;
  return { { std::min(facet.Fragments[0], before), std::max(facet.Fragments[0], before) } };
}

/// Numbers distinct keys from 1 in their order.
template <class Key>
class Numbering
{
public:
  explicit Numbering(std::vector<Key> keys) : Keys(std::move(keys)) { SortUnique(this->Keys); }
  int Find(const Key& key) const
  {
    return static_cast<int>(
             std::lower_bound(this->Keys.begin(), this->Keys.end(), key) - this->Keys.begin()) +
      1;
  }
  Index Count() const { return static_cast<Index>(this->Keys.size()); }
  const std::vector<Key>& All() const { return this->Keys; }

private:
  std::vector<Key> Keys;
};

class GeometryFinder
{
public:
  GeometryFinder(const std::vector<Facet>& facets, const CartesianGrid& grid,
    const Partition& partition, Mesh& mesh) :
    Facets(facets), Grid(grid), Parts(partition), Result(mesh), Corners(mesh.CornersOfFacet())
  {
  }

  void Run(MeshReport& report)
  {
    report.NumberOfSurfaces = this->FillSurfaces();
    this->ClassifyPoints(report);
  }

private:
  using SurfaceSet = std::vector<int>;

  Index FillSurfaces()
  {
    std::vector<SurfaceKey> keys;
    for (const Facet& facet : this->Facets)
    {
      if (facet.IsOwned) // what is beyond the rim is not known
      {
        keys.push_back(KeyOf(facet));
      }
    }
    const Numbering<SurfaceKey> numbers(this->GatherDistinct(keys));
    SurfaceFacets& surfaces = this->Result.Surfaces;
    const std::size_t count = this->Facets.size();
    surfaces.Points = Buffer<Index>(this->Corners * count);
    surfaces.SurfaceId = Buffer<int>(count);
    surfaces.MaterialPair = Buffer<int>(2 * count);
    surfaces.DomainSide = Buffer<int>(count);
    for (std::size_t q = 0; q < count; ++q)
    {
      const Facet& facet = this->Facets[q];
      this->SetFacet(q, facet);
      surfaces.SurfaceId[q] = numbers.Find(KeyOf(facet));
      surfaces.DomainSide[q] = facet.DomainSide;
      surfaces.IsOwned.push_back(facet.IsOwned);
    }
    return numbers.Count();
  }

  /// The smaller material first; the normal points to it.
  void SetFacet(std::size_t q, const Facet& facet)
  {
    Index* points = this->Result.Surfaces.Points.data() + this->Corners * q;
    std::copy_n(facet.Points.begin(), this->Corners, points);
    int* pair = this->Result.Surfaces.MaterialPair.data() + 2 * q;
    std::reverse_copy(facet.Materials.begin(), facet.Materials.end(), pair);
    if (pair[0] > pair[1])
    {
      std::swap(pair[0], pair[1]);
      std::swap(points[1], points[this->Corners - 1]);
    }
  }

  void ClassifyPoints(MeshReport& report)
  {
    const SurfaceFacets& surfaces = this->Result.Surfaces;
    this->Result.GeometryDimension = Buffer<int>(this->Result.PointIds.size(), 3);
    std::vector<std::pair<Index, int>> on; // (point, surface)
    for (std::size_t q = 0; q < this->Facets.size(); ++q)
    {
      for (int c = 0; c < this->Corners; ++c)
      {
        const Index point = this->Facets[q].Points[c];
        on.emplace_back(point, surfaces.SurfaceId[q]);
        this->Result.GeometryDimension[point] = 2;
        this->Result.GeometryId[point] = surfaces.SurfaceId[q];
      }
    }
    SortUnique(on);
    std::map<Index, SurfaceSet> junctions; // points on several surfaces
    for (std::size_t first = 0, last = 0; first < on.size(); first = last)
    {
      while (last < on.size() && on[last].first == on[first].first)
      {
        ++last;
      }
      for (std::size_t i = first; last - first > 1 && i < last; ++i)
      {
        junctions[on[first].first].push_back(on[i].second);
      }
    }
    this->ClassifyJunctions(junctions, report);
  }

  void ClassifyJunctions(const std::map<Index, SurfaceSet>& junctions, MeshReport& report)
  {
    std::map<Index, int> edgesAlike, edges; // curve edges at a point with its own set, and all
    for (const auto& edge : this->FindCurveEdges(junctions))
    {
      for (Index point : { edge.first.first, edge.first.second })
      {
        ++edges[point];
        edgesAlike[point] += edge.second == junctions.at(point);
      }
    }
    std::vector<SurfaceSet> sets;
    std::vector<Index> ids;
    for (const auto& junction : junctions)
    {
      const Index id = this->Result.PointIds[junction.first];
      if (!this->Parts.OwnsNode(NodeOfPoint(this->Grid, this->Result, id)))
      {
        continue;
      }
      if (edges[junction.first] == 2 && edgesAlike[junction.first] == 2)
      {
        sets.push_back(junction.second);
      }
      else
      {
        ids.push_back(id);
      }
    }
    const Numbering<SurfaceSet> curves(this->GatherSets(sets));
    const Numbering<Index> vertices(GatherItems(this->Parts.Group(), ids));
    for (const auto& junction : junctions)
    {
      const bool curve = edges[junction.first] == 2 && edgesAlike[junction.first] == 2;
      this->Result.GeometryDimension[junction.first] = curve ? 1 : 0;
      this->Result.GeometryId[junction.first] =
        curve ? curves.Find(junction.second) : vertices.Find(this->Result.PointIds[junction.first]);
    }
    report.NumberOfCurves = curves.Count();
    report.NumberOfVertices = vertices.Count();
  }

  template <class Key>
  std::vector<Key> GatherDistinct(const std::vector<Key>& keys) const
  {
    return GatherItems(this->Parts.Group(), Numbering<Key>(keys).All());
  }

  /// The distinct sets of all ranks, sent as their sizes and members one after another.
  std::vector<SurfaceSet> GatherSets(const std::vector<SurfaceSet>& sets) const
  {
    const Numbering<SurfaceSet> distinct(sets);
    std::vector<int> flat;
    for (const SurfaceSet& set : distinct.All())
    {
      flat.push_back(static_cast<int>(set.size()));
      flat.insert(flat.end(), set.begin(), set.end());
    }
    flat = GatherItems(this->Parts.Group(), flat);
    std::vector<SurfaceSet> all;
    for (auto at = flat.begin(); at != flat.end(); at += 1 + *at)
    {
      all.emplace_back(at + 1, at + 1 + *at);
    }
    return all;
  }

  /// The edges of facets where several surfaces meet, with those surfaces.
  std::map<std::pair<Index, Index>, SurfaceSet> FindCurveEdges(
    const std::map<Index, SurfaceSet>& junctions) const
  {
    std::map<std::pair<Index, Index>, SurfaceSet> edges;
    for (std::size_t q = 0; q < this->Facets.size(); ++q)
    {
      for (int c = 0; c < this->Corners; ++c)
      {
        const Index a = this->Facets[q].Points[c];
        const Index b = this->Facets[q].Points[(c + 1) % this->Corners];
        if (junctions.count(a) && junctions.count(b))
        {
          SurfaceSet& set = edges[std::minmax(a, b)];
          const int surface = this->Result.Surfaces.SurfaceId[q];
          const auto at = std::lower_bound(set.begin(), set.end(), surface);
          if (at == set.end() || *at != surface)
          {
            set.insert(at, surface);
          }
        }
      }
    }
    for (auto edge = edges.begin(); edge != edges.end();)
    {
      edge = edge->second.size() < 2 ? edges.erase(edge) : std::next(edge);
    }
    return edges;
  }

  const std::vector<Facet>& Facets;
  const CartesianGrid& Grid;
  const Partition& Parts;
  Mesh& Result;
  int Corners; // of a facet
};

} // namespace

void ClassifyGeometry(const std::vector<Facet>& facets, const CartesianGrid& grid,
  const Partition& partition, Mesh& mesh, MeshReport& report)
{
  GeometryFinder(facets, grid, partition, mesh).Run(report);
}

} // namespace vfm
