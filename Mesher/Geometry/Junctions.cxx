#include "Geometry/Junctions.h"

#include "Base/Sorted.h"
#include "Elements/ElementFaces.h"

namespace vfm
{
namespace
{

/// Point or edge and a facet that contains it.
struct Incidence
{
  std::array<Index, 2> Points;
  Index Facet;
  bool operator<(const Incidence& other) const { return this->Points < other.Points; }
};

/// Returns whether each mesh point is on several surfaces.
std::vector<bool> FindShared(const Mesh& mesh)
{
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const std::size_t corners = mesh.CornersOfFacet();
  std::vector<bool> isShared(mesh.PointIds.size(), false);
  const Index* point = surfaces.Points.data();
  for (int surface : surfaces.SurfaceId)
  {
    for (const Index* end = point + corners; point < end; ++point)
    {
      if (mesh.GeometryId[*point] != surface)
      {
        isShared[*point] = true;
      }
    }
  }
  return isShared;
}

FaceIds KeyOfFacet(const Mesh& mesh, Index facet)
{
  const int corners = mesh.CornersOfFacet();
  FaceIds key{ { -1, -1, -1, -1 } };
  std::copy_n(mesh.Surfaces.Points.data() + corners * facet, corners, key.begin());
  std::sort(key.begin(), key.end());
  return key;
}

/// Returns the points or edges that are on several surfaces.
std::vector<Junction> FindJunctions(const Mesh& mesh, std::vector<Incidence> places)
{
  std::sort(places.begin(), places.end());
  std::vector<Junction> junctions;
  const auto add = [&](auto first, auto last)
  {
    Junction junction{ first->Points, {}, first->Facet };
    for (auto place = first; place != last; ++place)
    {
      junction.Surfaces.push_back(mesh.Surfaces.SurfaceId[place->Facet]);
    }
    SortUnique(junction.Surfaces);
    if (junction.Surfaces.size() > 1)
    {
      junction.First = std::min_element(first, last,
        [&mesh](const Incidence& a, const Incidence& b) {
          return KeyOfFacet(mesh, a.Facet) < KeyOfFacet(mesh, b.Facet);
        })->Facet;
      junctions.push_back(std::move(junction));
    }
  };
  ForRuns(
    places.begin(), places.end(),
    [](const Incidence& a, const Incidence& b) { return a.Points == b.Points; }, add);
  return junctions;
}

} // namespace

Junctions::Junctions(const Mesh& mesh)
{
  const std::vector<bool> isShared = FindShared(mesh);
  const Index corners = mesh.CornersOfFacet();
  std::vector<Incidence> points, edges;
  for (Index facet = 0; facet < static_cast<Index>(mesh.Surfaces.SurfaceId.size()); ++facet)
  {
    const Index* around = mesh.Surfaces.Points.data() + corners * facet;
    for (Index c = 0; c < corners; ++c)
    {
      const Index a = around[c], b = around[c + 1 < corners ? c + 1 : 0];
      if (isShared[a])
      {
        points.push_back({ { { a, a } }, facet });
        if (isShared[b])
        {
          edges.push_back({ { { std::min(a, b), std::max(a, b) } }, facet });
        }
      }
    }
  }
  this->ThePoints = FindJunctions(mesh, std::move(points));
  this->TheEdges = FindJunctions(mesh, std::move(edges));
  std::vector<int> all(this->ThePoints.size(), 0), equal(all);
  for (const Junction& edge : this->TheEdges)
  {
    for (Index end : edge.Points)
    {
      const std::size_t point = this->Find(end);
      ++all[point];
      equal[point] += edge.Surfaces == this->ThePoints[point].Surfaces;
    }
  }
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    this->IsThrough.push_back(all[p] == 2 && equal[p] == 2);
  }
}

std::size_t Junctions::Find(Index meshPoint) const
{
  const Junction point{ { { meshPoint, meshPoint } }, {}, 0 };
  return std::lower_bound(this->ThePoints.begin(), this->ThePoints.end(), point) -
    this->ThePoints.begin();
}

} // namespace vfm
