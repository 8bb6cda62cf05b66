/**
 * Implements the calls of Sculptor.h for the geometry that a mesh resolves.
 */
#include "Sculptor.h"

#include "SculptorCalls.h"

using vfm::NotNull;
using vfm::SculptorSession;
using vfm::WithSession;

namespace
{

/// Returns the points and ids of facets, edges or vertices, null if there are none.
void ReturnCells(const vfm::Buffer<vfm::Index>& own, const vfm::Buffer<int>& ownIds, int64_t* count,
  const char* nameOfCount, const int64_t** points, const char* nameOfPoints, const int** ids)
{
  *NotNull(count, nameOfCount) = static_cast<int64_t>(ownIds.size());
  *NotNull(points, nameOfPoints) = ownIds.empty() ? nullptr : own.data();
  *NotNull(ids, "ids") = ownIds.empty() ? nullptr : ownIds.data();
}

} // namespace

int sculptor_get_geometry(int sculptor, const int** dimensions, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::Mesh& mesh = session.GetMesh();
      *NotNull(dimensions, "dimensions") = mesh.GeometryDimension.data();
      *NotNull(ids, "ids") = mesh.GeometryId.data();
    });
}

int sculptor_get_surfaces(
  int sculptor, int64_t* facets, int* corners, const int64_t** connectivity, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::Mesh& mesh = session.GetMesh();
      const vfm::SurfaceFacets& own = mesh.Surfaces;
      *NotNull(corners, "corners") = own.SurfaceId.empty() ? 0 : mesh.CornersOfFacet();
      ReturnCells(own.Points, own.SurfaceId, facets, "facets", connectivity, "connectivity", ids);
    });
}

int sculptor_get_curves(int sculptor, int64_t* edges, const int64_t** connectivity, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::CurveEdges& own = session.GetMesh().Curves;
      ReturnCells(own.Points, own.CurveId, edges, "edges", connectivity, "connectivity", ids);
    });
}

int sculptor_get_vertices(int sculptor, int64_t* vertices, const int64_t** points, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::VertexPoints& own = session.GetMesh().Vertices;
      ReturnCells(own.Points, own.VertexId, vertices, "vertices", points, "points", ids);
    });
}

int sculptor_get_bounds(
  int sculptor, const char* table, int* rows, int* columns, const int** values)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::FieldArray& own = session.GetGeometryTable(NotNull(table, "table"));
      const auto& numbers = std::get<std::vector<int>>(own.Values);
      *NotNull(rows, "rows") = static_cast<int>(numbers.size()) / own.Components;
      *NotNull(columns, "columns") = own.Components;
      *NotNull(values, "values") = numbers.data();
    });
}
