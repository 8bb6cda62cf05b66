#include "Report/Sets/MeshEntities.h"

#include "Base/Sorted.h"
#include "Elements/EqualFaces.h"
#include "Elements/MidNodes.h"
#include "Geometry/Junctions.h"
#include "Report/FlatData.h"
#include "Report/MatchFaces.h"
#include "Report/MeshMaterials.h"
#include "Report/Sets/NamedSurfaces.h"

#include <iterator>
#include <map>

namespace vfm
{
namespace
{

/// Key of a surface, in the order of ClassifyGeometry: its two sides, the smaller first (a volume,
/// 0 for nothing, -1 - side outside the domain), and the smooth side.
using SurfaceKey = std::array<int, 3>;

/// Returns, for each point, the lowest of its copies at split interfaces, or itself.
std::vector<Index> FindFirstCopies(const MeshData& mesh)
{
  std::vector<Index> first(mesh.NumberOfPoints);
  std::map<Index, Index> firstOfId;
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    first[point] = mesh.OriginalPointIds
      ? firstOfId.emplace(mesh.OriginalPointIds[point], point).first->second
      : point;
  }
  return first;
}

std::vector<int> NumberVolumes(const MeshData& mesh)
{
  if (mesh.Fragment)
  {
    return { mesh.Fragment, mesh.Fragment + mesh.NumberOfElements };
  }
  Ranks alone;
  const int voidId = FindVoidId(mesh, alone);
  std::vector<int> volumes(mesh.Material, mesh.Material + mesh.NumberOfElements);
  std::replace(volumes.begin(), volumes.end(), 0, voidId);
  return volumes;
}

bool OwnsFacet(const MeshData& mesh, const MeshFacet& facet)
{
  return facet.DomainSide != NoSide || OwnsFace(mesh.Material[facet.Element], facet.Behind);
}

/// Returns the volume behind each facet of the element that owns the face, or 0.
std::vector<int> FindVolumesBehind(
  const MeshData& mesh, const std::vector<int>& volumes, const std::vector<Index>& firstCopies)
{
  const std::vector<MeshFacet>& facets = *mesh.Facets;
  std::vector<int> behind(facets.size(), 0);
  ForEqualFaces(
    facets.size(),
    [&](Index f) { return SortedIds(PointsOfSide(mesh, facets[f]), firstCopies.data()); },
    [&](std::span<const NumberedFace> same)
    {
      const auto other = std::find_if(same.begin(), same.end(),
        [&](const NumberedFace& face) { return !OwnsFacet(mesh, facets[face.Number]); });
      for (const NumberedFace& face : same)
      {
        const bool hasVolume = facets[face.Number].Behind != NothingBehind && other != same.end();
        behind[face.Number] = hasVolume ? volumes[facets[other->Number].Element] : 0;
      }
    });
  return behind;
}

std::vector<SurfaceEntity> FindSurfaces(
  const MeshData& mesh, const std::vector<int>& volumes, const std::vector<Index>& firstCopies)
{
  const std::vector<int> volumesBehind = FindVolumesBehind(mesh, volumes, firstCopies);
  std::map<SurfaceKey, SurfaceEntity> found;
  for (std::size_t f = 0; f < volumesBehind.size(); ++f)
  {
    const MeshFacet& facet = (*mesh.Facets)[f];
    if (!OwnsFacet(mesh, facet))
    {
      continue;
    }
    const int own = volumes[facet.Element], behind = volumesBehind[f];
    const int other = facet.DomainSide != NoSide ? -1 - facet.DomainSide : behind;
    const SurfaceKey key{ { std::min(own, other), std::max(own, other), facet.Surface } };
    const std::array<int, 2> materials{ { mesh.Material[facet.Element],
      std::max(facet.Behind, 0) } };
    SurfaceEntity& surface = found
                               .emplace(key,
                                 SurfaceEntity{ { { own, behind } }, materials, facet.DomainSide,
                                   facet.Surface, facet.Behind != NothingBehind, {} })
                               .first->second;
    surface.Sides.push_back(facet);
  }
  std::vector<SurfaceEntity> surfaces;
  for (auto& entry : found)
  {
    surfaces.push_back(std::move(entry.second));
  }
  return surfaces;
}

/// Classifies the points inside volumes and on surfaces.
void ClassifyPoints(
  const MeshData& mesh, const std::vector<Index>& firstCopies, MeshEntities& entities)
{
  entities.PointDimension.assign(mesh.NumberOfPoints, DimensionOfVolumes);
  entities.PointEntity.assign(mesh.NumberOfPoints, entities.Volumes.front());
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    mesh.ForNodes(element,
      [&](const Index* first, const Index* last)
      {
        std::for_each(first, last,
          [&](Index point) { entities.PointEntity[point] = entities.Volumes[element]; });
      });
  }
  const int count = CornersOfSide(mesh);
  for (std::size_t s = 0; s < entities.Surfaces.size(); ++s)
  {
    for (const ElementSide& side : entities.Surfaces[s].Sides)
    {
      const FaceIds corners = PointsOfSide(mesh, side);
      std::vector<Index> points = MidsOfFace(mesh, side.Element, side.Side);
      points.insert(points.end(), corners.begin(), corners.begin() + count);
      for (Index point : points)
      {
        point = firstCopies[point];
        entities.PointDimension[point] = DimensionOfSurfaces;
        entities.PointEntity[point] = static_cast<int>(s) + 1;
      }
    }
  }
}

/// Classifies further copies of points like the first ones.
void ClassifyCopies(const std::vector<Index>& firstCopies, MeshEntities& entities)
{
  for (std::size_t p = 0; p < firstCopies.size(); ++p)
  {
    entities.PointDimension[p] = entities.PointDimension[firstCopies[p]];
    entities.PointEntity[p] = entities.PointEntity[firstCopies[p]];
  }
}

/// Returns a mesh with only the facets of the surfaces, for Junctions.
Mesh MakeFacets(
  const MeshData& mesh, const std::vector<Index>& firstCopies, const MeshEntities& entities)
{
  std::vector<Index> points;
  std::vector<int> ids;
  const int count = CornersOfSide(mesh);
  for (std::size_t s = 0; s < entities.Surfaces.size(); ++s)
  {
    for (const ElementSide& side : entities.Surfaces[s].Sides)
    {
      const FaceIds corners = PointsOfSide(mesh, side);
      std::transform(corners.begin(), corners.begin() + count, std::back_inserter(points),
        [&firstCopies](Index point) { return firstCopies[point]; });
      ids.push_back(static_cast<int>(s) + 1);
    }
  }
  Mesh made;
  made.Corners = mesh.Corners;
  made.PointIds = Buffer<Index>(mesh.NumberOfPoints);
  made.GeometryId = Buffer<int>(mesh.NumberOfPoints);
  std::copy(entities.PointEntity.begin(), entities.PointEntity.end(), made.GeometryId.begin());
  made.Surfaces.Points = Buffer<Index>(points.size());
  std::copy(points.begin(), points.end(), made.Surfaces.Points.begin());
  made.Surfaces.SurfaceId = Buffer<int>(ids.size());
  std::copy(ids.begin(), ids.end(), made.Surfaces.SurfaceId.begin());
  return made;
}

void FindVertices(const Junctions& junctions, MeshEntities& entities)
{
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    if (junctions.IsVertex(p))
    {
      const Index point = junctions.Points()[p].Points[0];
      entities.Vertices.push_back(point);
      entities.PointDimension[point] = 0;
      entities.PointEntity[point] = static_cast<int>(entities.Vertices.size());
    }
  }
}

void FindCurves(const Junctions& junctions, MeshEntities& entities)
{
  std::map<std::vector<int>, int> numbers; // of curves, by their surfaces
  for (const Junction& edge : junctions.Edges())
  {
    numbers.emplace(edge.Surfaces, 0);
  }
  for (auto& [surfaces, number] : numbers)
  {
    entities.Curves.push_back({ surfaces, {}, {} });
    number = static_cast<int>(entities.Curves.size());
  }
  for (std::size_t p = 0; p < junctions.Points().size(); ++p)
  {
    const Junction& point = junctions.Points()[p];
    if (!junctions.IsVertex(p))
    {
      entities.PointDimension[point.Points[0]] = 1;
      entities.PointEntity[point.Points[0]] = numbers.at(point.Surfaces);
    }
  }
  for (const Junction& edge : junctions.Edges())
  {
    CurveEntity& curve = entities.Curves[numbers.at(edge.Surfaces) - 1];
    curve.Edges.push_back(edge.Points);
    for (Index end : edge.Points)
    {
      if (entities.PointDimension[end] == 0)
      {
        curve.Vertices.push_back(entities.PointEntity[end]);
      }
    }
  }
  for (CurveEntity& curve : entities.Curves)
  {
    SortUnique(curve.Vertices);
  }
}

/// Classifies the mid nodes of edges of curves.
void ClassifyMids(
  const MeshData& mesh, const std::vector<Index>& firstCopies, MeshEntities& entities)
{
  std::map<EdgeIds, int> curves; // by the points of their edges
  for (std::size_t c = 0; c < entities.Curves.size(); ++c)
  {
    for (const std::array<Index, 2>& edge : entities.Curves[c].Edges)
    {
      curves[MakeEdgeIds(edge[0], edge[1])] = static_cast<int>(c) + 1;
    }
  }
  const int count = CornersOfSide(mesh);
  for (const SurfaceEntity& surface : entities.Surfaces)
  {
    for (const ElementSide& side : surface.Sides)
    {
      const FaceIds corners = PointsOfSide(mesh, side);
      const std::vector<Index> mids = MidsOfFace(mesh, side.Element, side.Side);
      for (int c = 0; !mids.empty() && c < count; ++c)
      {
        const auto curve =
          curves.find(MakeEdgeIds(firstCopies[corners[c]], firstCopies[corners[(c + 1) % count]]));
        if (curve != curves.end())
        {
          entities.PointDimension[firstCopies[mids[c]]] = 1;
          entities.PointEntity[firstCopies[mids[c]]] = curve->second;
        }
      }
    }
  }
}

} // namespace

MeshEntities FindMeshEntities(const MeshData& mesh)
{
  MeshEntities entities;
  entities.Volumes = NumberVolumes(mesh);
  const std::vector<Index> firstCopies = FindFirstCopies(mesh);
  entities.Surfaces = FindSurfaces(mesh, entities.Volumes, firstCopies);
  ClassifyPoints(mesh, firstCopies, entities);
  if (IsFlat(mesh))
  {
    ClassifyCopies(firstCopies, entities);
    return entities;
  }
  const Junctions junctions(MakeFacets(mesh, firstCopies, entities));
  FindVertices(junctions, entities);
  FindCurves(junctions, entities);
  if (mesh.MidsPerElement > 0)
  {
    ClassifyMids(mesh, firstCopies, entities);
  }
  ClassifyCopies(firstCopies, entities);
  return entities;
}

} // namespace vfm
