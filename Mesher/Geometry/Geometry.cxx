#include "Geometry/Geometry.h"

#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Geometry/Junctions.h"
#include "Geometry/MeasureSurfaces.h"
#include "Geometry/SmoothSides.h"

#include <mutex>

namespace vfm
{
namespace
{

using Pair = GeometryTables::Pair;
using SurfaceSet = std::vector<int>;
using EdgeFacet = std::array<std::int64_t, 5>;

/// Key of a surface: its two sides (SurfaceOf), their materials, and the smooth
/// side (FindSmoothSides).
using SurfaceKey = std::array<int, 5>;

SurfaceKey KeyOf(const Facet& facet, int side)
{
  const Pair pair = SurfaceOf(facet);
  const int first = pair[0] == facet.Fragments[0] ? 0 : 1;
  return { { pair[0], pair[1], facet.Materials[first], facet.Materials[1 - first], side } };
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

/// Returns the numbering of the distinct keys of all ranks.
template <class Key>
Numbering<Key> Gather(Ranks& ranks, const std::vector<Key>& keys)
{
  return Numbering<Key>(GatherItems(ranks, Numbering<Key>(keys).All()));
}

/// Cache of surface numbers. Facets close to each other belong to few surfaces.
class RecentSurfaces
{
public:
  /// Returns the number of a surface; calls lookUp(key) if it is not in the cache.
  template <class LookUp>
  int Find(const SurfaceKey& key, const LookUp& lookUp)
  {
    const auto hash = static_cast<unsigned>(key[0]) * 961u + static_cast<unsigned>(key[1]) * 31u +
      static_cast<unsigned>(key[4]);
    Entry& entry = this->Entries[hash % this->Entries.size()];
    if (!entry.IsUsed || entry.Key != key)
    {
      entry = { key, lookUp(key), true };
    }
    return entry.Number;
  }

private:
  struct Entry
  {
    SurfaceKey Key;
    int Number;
    bool IsUsed;
  };
  std::array<Entry, 256> Entries{};
};

/// Returns the numbering of the distinct sets of all ranks. A set is sent as its
/// size and its members.
Numbering<SurfaceSet> GatherSets(Ranks& ranks, const std::vector<SurfaceSet>& sets)
{
  const Numbering<SurfaceSet> distinct(sets);
  std::vector<int> flat;
  for (const SurfaceSet& set : distinct.All())
  {
    flat.push_back(static_cast<int>(set.size()));
    flat.insert(flat.end(), set.begin(), set.end());
  }
  flat = GatherItems(ranks, flat);
  std::vector<SurfaceSet> all;
  for (auto at = flat.begin(); at != flat.end(); at += 1 + *at)
  {
    all.emplace_back(at + 1, at + 1 + *at);
  }
  return Numbering<SurfaceSet>(std::move(all));
}

struct Work
{
  const std::vector<Facet>& Facets;
  const std::vector<int> Sides; // side of each facet
  Runtime& Run;
  Mesh& Result;
  Ranks& Group = Run.Group();
  const int Corners = Result.CornersOfFacet();
};

/// Stores a facet with the smaller material first; the normal points to it.
void SetFacet(Work& work, std::size_t q, const Facet& facet)
{
  Index* points = work.Result.Surfaces.Points.data() + work.Corners * q;
  std::copy_n(facet.Points.begin(), work.Corners, points);
  int* pair = work.Result.Surfaces.MaterialPair.data() + 2 * q;
  std::reverse_copy(facet.Materials.begin(), facet.Materials.end(), pair);
  if (pair[0] > pair[1])
  {
    std::swap(pair[0], pair[1]);
    std::swap(points[1], points[work.Corners - 1]);
  }
}

void FillSurfaceTables(Work& work, const std::vector<SurfaceKey>& surfaces)
{
  GeometryTables& tables = work.Result.Tables;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const SurfaceKey& key = surfaces[s];
    Pair volumes{ { std::max(key[0], 0), key[1] } }, materials{ { key[2], key[3] } };
    for (int volume : volumes)
    {
      if (volume > 0)
      {
        tables.VolumeSurfaces.push_back({ { volume, static_cast<int>(s) + 1 } });
      }
    }
    if (materials[0] > materials[1])
    {
      std::swap(materials[0], materials[1]);
      std::swap(volumes[0], volumes[1]);
    }
    tables.SurfaceVolumes.push_back(volumes);
    tables.SurfaceMaterials.push_back(materials);
    tables.SurfaceSides.push_back(key[0] < 0 ? -1 - key[0] : -1);
    const bool isNext = s > 0 && std::equal(key.begin(), key.begin() + 2, surfaces[s - 1].begin());
    tables.SurfaceParts.push_back(key[4] == 0 ? 0 : isNext ? tables.SurfaceParts.back() + 1 : 1);
  }
  std::sort(tables.VolumeSurfaces.begin(), tables.VolumeSurfaces.end());
}

/// Returns the keys of the surfaces of owned facets; some occur repeatedly.
std::vector<SurfaceKey> ListKeys(const Work& work)
{
  std::vector<SurfaceKey> keys;
  std::mutex lock;
  work.Run.For(0, static_cast<Index>(work.Facets.size()),
    [&](Index first, Index last)
    {
      RecentSurfaces known;
      for (Index q = first; q < last; ++q)
      {
        if (work.Facets[q].IsOwned) // the sides of other facets may be unknown
        {
          known.Find(KeyOf(work.Facets[q], work.Sides[q]),
            [&](const SurfaceKey& key)
            {
              const std::lock_guard<std::mutex> guard(lock);
              keys.push_back(key);
              return 0;
            });
        }
      }
    });
  return keys;
}

Index FillSurfaces(Work& work)
{
  const Numbering<SurfaceKey> numbers = Gather(work.Group, ListKeys(work));
  SurfaceFacets& surfaces = work.Result.Surfaces;
  const std::size_t count = work.Facets.size();
  surfaces.Points = Buffer<Index>(work.Corners * count);
  surfaces.SurfaceId = Buffer<int>(count);
  surfaces.MaterialPair = Buffer<int>(2 * count);
  surfaces.DomainSide = Buffer<int>(count);
  surfaces.IsOwned.resize(count);
  work.Run.For(0, static_cast<Index>(count),
    [&](Index first, Index last)
    {
      RecentSurfaces numbered;
      for (Index q = first; q < last; ++q)
      {
        const Facet& facet = work.Facets[q];
        SetFacet(work, q, facet);
        surfaces.SurfaceId[q] = numbered.Find(KeyOf(facet, work.Sides[q]),
          [&numbers](const SurfaceKey& key) { return numbers.Find(key); });
        surfaces.DomainSide[q] = facet.DomainSide;
        surfaces.IsOwned[q] = facet.IsOwned;
      }
    });
  FillSurfaceTables(work, numbers.All());
  return numbers.Count();
}

void ClassifySurfacePoints(Work& work)
{
  Mesh& mesh = work.Result;
  mesh.GeometryDimension = Buffer<int>(mesh.PointIds.size(), 3);
  const Index* point = mesh.Surfaces.Points.data();
  for (int surface : mesh.Surfaces.SurfaceId)
  {
    for (const Index* end = point + work.Corners; point < end; ++point)
    {
      mesh.GeometryDimension[*point] = 2;
      mesh.GeometryId[*point] = surface;
    }
  }
}

bool IsOwned(const Work& work, const Junction& junction)
{
  return work.Result.Surfaces.IsOwned[junction.First] != 0;
}

Index FillVertices(Work& work, const Junctions& junctions)
{
  Mesh& mesh = work.Result;
  std::vector<Index> points, ids;
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Index point = junctions.Points()[p].Points[0];
    if (junctions.IsVertex(p) && IsOwned(work, junctions.Points()[p]))
    {
      points.push_back(point);
      ids.push_back(IdOfOwner(mesh, mesh.PointIds[point]));
    }
  }
  const Numbering<Index> numbers = Gather(work.Group, ids);
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Index point = junctions.Points()[p].Points[0];
    if (junctions.IsVertex(p))
    {
      mesh.GeometryDimension[point] = 0;
      mesh.GeometryId[point] = numbers.Find(IdOfOwner(mesh, mesh.PointIds[point]));
    }
  }
  mesh.Vertices.Points = Buffer<Index>(points.size());
  mesh.Vertices.VertexId = Buffer<int>(points.size());
  std::copy(points.begin(), points.end(), mesh.Vertices.Points.begin());
  std::transform(points.begin(), points.end(), mesh.Vertices.VertexId.begin(),
    [&mesh](Index point) { return mesh.GeometryId[point]; });
  return numbers.Count();
}

void FillCurveTables(Work& work, const std::vector<SurfaceSet>& curves)
{
  Mesh& mesh = work.Result;
  GeometryTables& tables = mesh.Tables;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    for (int surface : curves[c])
    {
      tables.SurfaceCurves.push_back({ { surface, static_cast<int>(c) + 1 } });
    }
  }
  std::sort(tables.SurfaceCurves.begin(), tables.SurfaceCurves.end());
  std::vector<std::int64_t> ends(curves.size(), 0);
  std::vector<Pair> pairs;
  for (std::size_t at = 0; at < mesh.Curves.Points.size(); ++at)
  {
    const Index point = mesh.Curves.Points[at];
    if (mesh.GeometryDimension[point] == 0)
    {
      const int curve = mesh.Curves.CurveId[at / 2];
      ++ends[curve - 1];
      pairs.push_back({ { curve, mesh.GeometryId[point] } });
    }
  }
  work.Group.Sum(ends);
  tables.CurveEnds.assign(ends.begin(), ends.end());
  tables.CurveVertices = Gather(work.Group, pairs).All();
}

/// Fills the curves. The vertices must be classified already.
Index FillCurves(Work& work, const Junctions& junctions)
{
  std::vector<const Junction*> owned;
  std::vector<SurfaceSet> sets;
  for (const Junction& edge : junctions.Edges())
  {
    if (IsOwned(work, edge))
    {
      owned.push_back(&edge);
      sets.push_back(edge.Surfaces);
    }
  }
  const Numbering<SurfaceSet> numbers = GatherSets(work.Group, sets);
  Mesh& mesh = work.Result;
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Junction& point = junctions.Points()[p];
    if (!junctions.IsVertex(p))
    {
      mesh.GeometryDimension[point.Points[0]] = 1;
      mesh.GeometryId[point.Points[0]] = numbers.Find(point.Surfaces);
    }
  }
  std::stable_sort(owned.begin(), owned.end(),
    [](const Junction* a, const Junction* b) { return a->Surfaces < b->Surfaces; });
  mesh.Curves.Points = Buffer<Index>(2 * owned.size());
  mesh.Curves.CurveId = Buffer<int>(owned.size());
  for (std::size_t e = 0; e < owned.size(); ++e)
  {
    std::copy_n(owned[e]->Points.begin(), 2, mesh.Curves.Points.data() + 2 * e);
    mesh.Curves.CurveId[e] = numbers.Find(owned[e]->Surfaces);
  }
  FillCurveTables(work, numbers.All());
  return numbers.Count();
}

bool IsKnownFromPoints(const Work& work, std::size_t q)
{
  const Mesh& mesh = work.Result;
  const Index* points = mesh.Surfaces.Points.data() + work.Corners * q;
  int inside = 0, others = 0;
  for (int c = 0; c < work.Corners; ++c)
  {
    if (mesh.GeometryDimension[points[c]] == 2)
    {
      ++inside;
      others += mesh.GeometryId[points[c]] != mesh.Surfaces.SurfaceId[q];
    }
  }
  return inside > 0 && others == 0;
}

/// Fills EdgeFacets. The points must be classified already.
void ListEdgeFacets(Work& work)
{
  const Mesh& mesh = work.Result;
  std::vector<EdgeFacet> mine;
  for (std::size_t q = 0; q < work.Facets.size(); ++q)
  {
    if (work.Sides[q] > 0 && work.Facets[q].IsOwned && !IsKnownFromPoints(work, q))
    {
      EdgeFacet facet{ { -1, -1, -1, -1, mesh.Surfaces.SurfaceId[q] } };
      const Index* points = mesh.Surfaces.Points.data() + work.Corners * q;
      std::transform(points, points + work.Corners, facet.begin() + (4 - work.Corners),
        [&mesh](Index point) { return IdOfOwner(mesh, mesh.PointIds[point]); });
      std::sort(facet.begin(), facet.begin() + 4);
      mine.push_back(facet);
    }
  }
  work.Result.Tables.EdgeFacets = Gather(work.Group, mine).All();
}

} // namespace

void ClassifyGeometry(const std::vector<Facet>& facets, const std::vector<FeatureKind>& kinds,
  const Partition& partition, Runtime& runtime, Mesh& mesh, MeshReport& report)
{
  Work work{ facets, FindSmoothSides(facets, kinds, mesh, partition), runtime, mesh };
  report.NumberOfSurfaces = FillSurfaces(work);
  ClassifySurfacePoints(work);
  const Junctions junctions(work.Result);
  report.NumberOfVertices = FillVertices(work, junctions);
  report.NumberOfCurves = FillCurves(work, junctions);
  ListEdgeFacets(work);
  MeasureSurfaces(work.Result, runtime);
}

} // namespace vfm
