#include "Geometry/Geometry.h"

#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Geometry/Junctions.h"
#include "Geometry/MeasureSurfaces.h"

#include <mutex>

namespace vfm
{
namespace
{

using Pair = GeometryTables::Pair;
using SurfaceSet = std::vector<int>;
using EdgeFacet = std::array<std::int64_t, 5>;

/// Key of a surface: its two sides (SurfaceOf), their materials, and the smooth
/// side (DivideInterfaces).
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

/// Stores a facet with the smaller material first; the normal points to it.
void SetFacet(std::size_t q, const Facet& facet, int corners, SurfaceFacets& surfaces)
{
  Index* points = surfaces.Points.data() + corners * q;
  std::copy_n(facet.Points.begin(), corners, points);
  int* pair = surfaces.MaterialPair.data() + 2 * q;
  std::reverse_copy(facet.Materials.begin(), facet.Materials.end(), pair);
  if (pair[0] > pair[1])
  {
    std::swap(pair[0], pair[1]);
    std::swap(points[1], points[corners - 1]);
  }
}

/// @param names  of sides
void FillSurfaceTables(const std::vector<SurfaceKey>& surfaces,
  const std::vector<std::string>& names, GeometryTables& tables)
{
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
    const std::size_t side = static_cast<std::size_t>(key[4]);
    tables.PatchNames.push_back(side < names.size() ? names[side] : "");
  }
  if (std::all_of(tables.PatchNames.begin(), tables.PatchNames.end(),
        [](const std::string& name) { return name.empty(); }))
  {
    tables.PatchNames.clear();
  }
  std::sort(tables.VolumeSurfaces.begin(), tables.VolumeSurfaces.end());
}

/// Returns the keys of the surfaces of owned facets; some occur repeatedly.
std::vector<SurfaceKey> ListKeys(
  const std::vector<Facet>& facets, const std::vector<int>& sides, Runtime& runtime)
{
  std::vector<SurfaceKey> keys;
  std::mutex lock;
  runtime.For(0, static_cast<Index>(facets.size()),
    [&](Index first, Index last)
    {
      RecentSurfaces known;
      for (Index q = first; q < last; ++q)
      {
        if (facets[q].IsOwned) // the sides of other facets may be unknown
        {
          known.Find(KeyOf(facets[q], sides[q]),
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

/// Fills the surfaces; returns their number.
Index FillSurfaces(
  const std::vector<Facet>& facets, const DividedFacets& divided, Runtime& runtime, Mesh& mesh)
{
  const std::vector<int>& sides = divided.SideOf;
  const Numbering<SurfaceKey> numbers = Gather(runtime.Group(), ListKeys(facets, sides, runtime));
  SurfaceFacets& surfaces = mesh.Surfaces;
  const int corners = mesh.CornersOfFacet();
  const std::size_t count = facets.size();
  surfaces.Points = Buffer<Index>(corners * count);
  surfaces.SurfaceId = Buffer<int>(count);
  surfaces.MaterialPair = Buffer<int>(2 * count);
  surfaces.DomainSide = Buffer<int>(count);
  surfaces.IsOwned.resize(count);
  runtime.For(0, static_cast<Index>(count),
    [&](Index first, Index last)
    {
      RecentSurfaces numbered;
      for (Index q = first; q < last; ++q)
      {
        const Facet& facet = facets[q];
        SetFacet(q, facet, corners, surfaces);
        surfaces.SurfaceId[q] = numbered.Find(
          KeyOf(facet, sides[q]), [&numbers](const SurfaceKey& key) { return numbers.Find(key); });
        surfaces.DomainSide[q] = facet.DomainSide;
        surfaces.IsOwned[q] = facet.IsOwned;
      }
    });
  FillSurfaceTables(numbers.All(), divided.Names, mesh.Tables);
  return numbers.Count();
}

void ClassifySurfacePoints(Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  mesh.GeometryDimension = Buffer<int>(mesh.PointIds.size(), 3);
  const Index* point = mesh.Surfaces.Points.data();
  for (int surface : mesh.Surfaces.SurfaceId)
  {
    for (const Index* end = point + corners; point < end; ++point)
    {
      mesh.GeometryDimension[*point] = 2;
      mesh.GeometryId[*point] = surface;
    }
  }
}

bool IsOwned(const Mesh& mesh, const Junction& junction)
{
  return mesh.Surfaces.IsOwned[junction.First] != 0;
}

/// Fills the vertices; returns their number.
Index FillVertices(const Junctions& junctions, Ranks& ranks, Mesh& mesh)
{
  std::vector<Index> points, ids;
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Index point = junctions.Points()[p].Points[0];
    if (junctions.IsVertex(p) && IsOwned(mesh, junctions.Points()[p]))
    {
      points.push_back(point);
      ids.push_back(IdOfOwner(mesh, mesh.PointIds[point]));
    }
  }
  const Numbering<Index> numbers = Gather(ranks, ids);
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

void FillCurveTables(const std::vector<SurfaceSet>& curves, Ranks& ranks, Mesh& mesh)
{
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
  ranks.Sum(ends);
  tables.CurveEnds.assign(ends.begin(), ends.end());
  tables.CurveVertices = Gather(ranks, pairs).All();
}

/// Fills the curves; returns their number. The vertices must be classified already.
Index FillCurves(const Junctions& junctions, Ranks& ranks, Mesh& mesh)
{
  std::vector<const Junction*> owned;
  std::vector<SurfaceSet> sets;
  for (const Junction& edge : junctions.Edges())
  {
    if (IsOwned(mesh, edge))
    {
      owned.push_back(&edge);
      sets.push_back(edge.Surfaces);
    }
  }
  const Numbering<SurfaceSet> numbers = GatherSets(ranks, sets);
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
  FillCurveTables(numbers.All(), ranks, mesh);
  return numbers.Count();
}

/// Returns whether the surface of a facet is that of its points inside surfaces.
bool IsKnownFromPoints(const Mesh& mesh, std::size_t q)
{
  const int corners = mesh.CornersOfFacet();
  const Index* points = mesh.Surfaces.Points.data() + corners * q;
  int inside = 0, others = 0;
  for (int c = 0; c < corners; ++c)
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
void ListEdgeFacets(
  const std::vector<Facet>& facets, const std::vector<int>& sides, Ranks& ranks, Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  std::vector<EdgeFacet> mine;
  for (std::size_t q = 0; q < facets.size(); ++q)
  {
    if (sides[q] > 0 && facets[q].IsOwned && !IsKnownFromPoints(mesh, q))
    {
      EdgeFacet facet{ { -1, -1, -1, -1, mesh.Surfaces.SurfaceId[q] } };
      const Index* points = mesh.Surfaces.Points.data() + corners * q;
      std::transform(points, points + corners, facet.begin() + (4 - corners),
        [&mesh](Index point) { return IdOfOwner(mesh, mesh.PointIds[point]); });
      std::sort(facet.begin(), facet.begin() + 4);
      mine.push_back(facet);
    }
  }
  mesh.Tables.EdgeFacets = Gather(ranks, mine).All();
}

} // namespace

void ClassifyGeometry(const std::vector<Facet>& facets, const DividedFacets& divided,
  Runtime& runtime, Mesh& mesh, MeshReport& report)
{
  Ranks& ranks = runtime.Group();
  report.NumberOfSurfaces = FillSurfaces(facets, divided, runtime, mesh);
  ClassifySurfacePoints(mesh);
  const Junctions junctions(mesh);
  report.NumberOfVertices = FillVertices(junctions, ranks, mesh);
  report.NumberOfCurves = FillCurves(junctions, ranks, mesh);
  ListEdgeFacets(facets, divided.SideOf, ranks, mesh);
  MeasureSurfaces(mesh, runtime);
}

} // namespace vfm
