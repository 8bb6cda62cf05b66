#include "Geometry/Geometry.h"

#include "Elements/PeriodicIds.h"
#include "Geometry/EdgeFacets.h"
#include "Geometry/EntityNumbers.h"
#include "Geometry/Junctions.h"
#include "Geometry/MeasureSurfaces.h"

#include <mutex>

namespace vfm
{
namespace
{

using Pair = GeometryTables::Pair;
using SurfaceSet = std::vector<int>;
using CurveNumbers = EntityNumbers<SurfaceSet>;

/// Key of a surface: its two sides (SurfaceOf), their materials, and the smooth
/// side (DivideInterfaces).
using SurfaceKey = std::array<int, 5>;

using SurfaceNumbers = EntityNumbers<SurfaceKey>;

/// Returns the two sides of a surface, which its smooth sides have in common.
std::array<Index, 2> InterfaceOf(const SurfaceKey& key)
{
  return { { key[0], key[1] } };
}

SurfaceKey KeyOf(const Facet& facet, int side)
{
  const Pair pair = SurfaceOf(facet);
  const int first = pair[0] == facet.Fragments[0] ? 0 : 1;
  return { { pair[0], pair[1], facet.Materials[first], facet.Materials[1 - first], side } };
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

/// Returns the lowest number of the smooth sides of the interface of each surface; 0: the interface
/// is not divided. Numbers of the sides of an interface follow each other.
std::vector<int> FindFirstSides(const SurfaceNumbers& surfaces, Ranks& ranks)
{
  std::vector<std::array<Index, 2>> interfaces;
  std::vector<int> lowest;
  for (std::size_t s = 0; s < surfaces.Keys.size(); ++s)
  {
    const SurfaceKey& key = surfaces.Keys[s];
    if (key[4] > 0 && (interfaces.empty() || interfaces.back() != InterfaceOf(key)))
    {
      interfaces.push_back(InterfaceOf(key));
      lowest.push_back(surfaces.Ids[s]);
    }
  }
  KeyMerge<std::array<Index, 2>>(interfaces, ranks)
    .Merge(lowest, 1, [](int& a, int b) { a = std::min(a, b); });
  std::vector<int> firsts;
  for (const SurfaceKey& key : surfaces.Keys)
  {
    firsts.push_back(key[4] > 0 ? lowest[FindSorted(interfaces, InterfaceOf(key))] : 0);
  }
  return firsts;
}

/// @param names  of sides
std::vector<std::string> ListPatchNames(
  const SurfaceNumbers& surfaces, const std::vector<std::string>& names, Ranks& ranks)
{
  std::vector<std::string> patches;
  for (const SurfaceKey& key : surfaces.Keys)
  {
    const auto side = static_cast<std::size_t>(key[4]);
    patches.push_back(side < names.size() ? names[side] : "");
  }
  const bool areNamed = ranks.Any(std::any_of(
    patches.begin(), patches.end(), [](const std::string& name) { return !name.empty(); }));
  return areNamed ? patches : std::vector<std::string>();
}

/// @param names  of sides
/// @pre Collective.
void FillSurfaceTables(const SurfaceNumbers& surfaces, const std::vector<std::string>& names,
  Ranks& ranks, GeometryTables& tables)
{
  const std::vector<int> firsts = FindFirstSides(surfaces, ranks);
  for (std::size_t s = 0; s < surfaces.Keys.size(); ++s)
  {
    const SurfaceKey& key = surfaces.Keys[s];
    const int id = surfaces.Ids[s];
    Pair volumes{ { std::max(key[0], 0), key[1] } }, materials{ { key[2], key[3] } };
    for (int volume : volumes)
    {
      if (volume > 0)
      {
        tables.VolumeSurfaces.push_back({ { volume, id } });
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
    tables.SurfaceParts.push_back(firsts[s] > 0 ? id - firsts[s] + 1 : 0);
  }
  tables.PatchNames = ListPatchNames(surfaces, names, ranks);
  std::sort(tables.VolumeSurfaces.begin(), tables.VolumeSurfaces.end());
  tables.HasAllSurfaces = ranks.Count() == 1;
  if (!tables.HasAllSurfaces)
  {
    tables.SurfaceIds = surfaces.Ids;
  }
}

/// Returns the keys of the surfaces of facets. Some of facets that other ranks own are wrong,
/// because their side may be unknown.
EntityKeys<SurfaceKey> ListKeys(
  const std::vector<Facet>& facets, const std::vector<int>& sides, Runtime& runtime)
{
  std::vector<std::pair<SurfaceKey, bool>> keys;
  std::mutex lock;
  runtime.For(0, static_cast<Index>(facets.size()),
    [&](Index first, Index last)
    {
      std::array<RecentSurfaces, 2> known; // of owned facets, and of others
      for (Index q = first; q < last; ++q)
      {
        const bool isOwned = facets[q].IsOwned;
        known[isOwned ? 0 : 1].Find(KeyOf(facets[q], sides[q]),
          [&](const SurfaceKey& key)
          {
            const std::lock_guard<std::mutex> guard(lock);
            keys.emplace_back(key, isOwned);
            return 0;
          });
      }
    });
  return EntityKeys<SurfaceKey>(std::move(keys));
}

/// Numbers the surfaces of facets.
/// @pre Collective.
SurfaceNumbers NumberSurfaces(
  const std::vector<Facet>& facets, const std::vector<int>& sides, Runtime& runtime)
{
  Ranks& ranks = runtime.Group();
  EntityKeys<SurfaceKey> keys = ListKeys(facets, sides, runtime);
  int most = 0;
  for (const SurfaceKey& key : keys.Keys)
  {
    most = std::max(most, key[1]);
  }
  // First sides begin with -6, the sides of the domain. Homes of keys shall have about the same
  // number of keys, so values have no gaps.
  const auto width = static_cast<Index>(ranks.Max(most)) + 1;
  const auto value = [width](const SurfaceKey& key) { return (key[0] + 6) * width + key[1]; };
  const OwnedKeyNumbers numbers = NumberOwnedKeys(keys.Keys, keys.IsOwned, value, ranks);
  return { std::move(keys.Keys), numbers, "surfaces" };
}

/// Fills the surfaces.
void FillSurfaces(const std::vector<Facet>& facets, const std::vector<int>& sides,
  const SurfaceNumbers& numbers, Runtime& runtime, Mesh& mesh)
{
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
  std::vector<std::pair<Index, bool>> all;
  std::vector<Index> owned;
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Index point = junctions.Points()[p].Points[0];
    if (junctions.IsVertex(p))
    {
      const bool isOwned = IsOwned(mesh, junctions.Points()[p]);
      all.emplace_back(IdOfOwner(mesh, mesh.PointIds[point]), isOwned);
      if (isOwned)
      {
        owned.push_back(point);
      }
    }
  }
  EntityKeys<Index> keys(std::move(all));
  const OwnedKeyNumbers found = NumberOwnedKeys(
    keys.Keys, keys.IsOwned, [](Index id) { return id; }, ranks);
  const EntityNumbers<Index> numbers(std::move(keys.Keys), found, "vertices");
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Index point = junctions.Points()[p].Points[0];
    if (junctions.IsVertex(p))
    {
      mesh.GeometryDimension[point] = 0;
      mesh.GeometryId[point] = numbers.Find(IdOfOwner(mesh, mesh.PointIds[point]));
    }
  }
  mesh.Vertices.Points = Buffer<Index>(owned.size());
  mesh.Vertices.VertexId = Buffer<int>(owned.size());
  std::copy(owned.begin(), owned.end(), mesh.Vertices.Points.begin());
  std::transform(owned.begin(), owned.end(), mesh.Vertices.VertexId.begin(),
    [&mesh](Index point) { return mesh.GeometryId[point]; });
  return numbers.Total;
}

/// @pre Collective. mesh.Curves and the vertices are filled.
void FillCurveTables(const CurveNumbers& curves, Ranks& ranks, Mesh& mesh)
{
  GeometryTables& tables = mesh.Tables;
  for (std::size_t c = 0; c < curves.Keys.size(); ++c)
  {
    for (int surface : curves.Keys[c])
    {
      tables.SurfaceCurves.push_back({ { surface, curves.Ids[c] } });
    }
  }
  std::sort(tables.SurfaceCurves.begin(), tables.SurfaceCurves.end());
  tables.CurveEnds.assign(curves.Keys.size(), 0);
  for (std::size_t at = 0; at < mesh.Curves.Points.size(); ++at)
  {
    const Index point = mesh.Curves.Points[at];
    if (mesh.GeometryDimension[point] == 0)
    {
      const int curve = mesh.Curves.CurveId[at / 2];
      ++tables.CurveEnds[FindSorted(curves.Ids, curve)];
      tables.CurveVertices.push_back({ { curve, mesh.GeometryId[point] } });
    }
  }
  SharedRows(curves.Ids, curves.IsShared, ranks)
    .Merge(tables.CurveEnds, 1, [](int& a, int b) { a += b; });
  SortUnique(tables.CurveVertices);
  tables.HasAllCurves = ranks.Count() == 1;
  if (!tables.HasAllCurves)
  {
    tables.CurveIds = curves.Ids;
  }
}

/// Fills the curves; returns their number. The vertices must be classified already.
/// @param surfaces  number of surfaces of all ranks
Index FillCurves(const Junctions& junctions, Index surfaces, Ranks& ranks, Mesh& mesh)
{
  std::vector<const Junction*> owned;
  std::vector<std::pair<SurfaceSet, bool>> sets;
  for (const Junction& edge : junctions.Edges())
  {
    const bool isOwned = IsOwned(mesh, edge);
    sets.emplace_back(edge.Surfaces, isOwned);
    if (isOwned)
    {
      owned.push_back(&edge);
    }
  }
  const CurveNumbers numbers =
    NumberSets(EntityKeys<SurfaceSet>(std::move(sets)), surfaces, "curves", ranks);
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Junction& point = junctions.Points()[p];
    if (!junctions.IsVertex(p)) // then edges at the point are on its surfaces
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
  FillCurveTables(numbers, ranks, mesh);
  return numbers.Total;
}

} // namespace

void ClassifyGeometry(const std::vector<Facet>& facets, const DividedFacets& divided,
  Runtime& runtime, Mesh& mesh, MeshReport& report)
{
  Ranks& ranks = runtime.Group();
  const SurfaceNumbers surfaces = NumberSurfaces(facets, divided.SideOf, runtime);
  FillSurfaces(facets, divided.SideOf, surfaces, runtime, mesh);
  FillSurfaceTables(surfaces, divided.Names, ranks, mesh.Tables);
  ClassifySurfacePoints(mesh);
  const Junctions junctions(mesh);
  report.NumberOfSurfaces = surfaces.Total;
  report.NumberOfVertices = FillVertices(junctions, ranks, mesh);
  report.NumberOfCurves = FillCurves(junctions, surfaces.Total, ranks, mesh);
  mesh.Tables.EdgeFacets = ListEdgeFacets(facets, divided.SideOf, mesh);
  MeasureSurfaces(surfaces.Ids, surfaces.IsShared, mesh, runtime);
}

} // namespace vfm
