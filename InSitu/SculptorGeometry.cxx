/**
 * The calls of Sculptor.h for the geometry that a mesh resolves.
 */
#include "Sculptor.h"

#include "SculptorCalls.h"

#include "vtkIntArray.h"

using vfm::NotNull;
using vfm::SculptorSession;
using vfm::WithSession;

int sculptor_get_geometry(int sculptor, const int** dimensions, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      *NotNull(dimensions, "dimensions") = session.GetPointValues<int>("GeometryDimension");
      *NotNull(ids, "ids") = session.GetPointValues<int>("GeometryId");
    });
}

int sculptor_get_surfaces(
  int sculptor, int64_t* facets, int* corners, const int64_t** connectivity, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::GeometryParts::Cells cells = session.GetGeometryCells(2);
      *NotNull(facets, "facets") = cells.Count;
      *NotNull(corners, "corners") = cells.Corners;
      *NotNull(connectivity, "connectivity") = cells.Points;
      *NotNull(ids, "ids") = cells.Ids;
    });
}

int sculptor_get_curves(int sculptor, int64_t* edges, const int64_t** connectivity, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::GeometryParts::Cells cells = session.GetGeometryCells(1);
      *NotNull(edges, "edges") = cells.Count;
      *NotNull(connectivity, "connectivity") = cells.Points;
      *NotNull(ids, "ids") = cells.Ids;
    });
}

int sculptor_get_vertices(int sculptor, int64_t* vertices, const int64_t** points, const int** ids)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      const vfm::GeometryParts::Cells cells = session.GetGeometryCells(0);
      *NotNull(vertices, "vertices") = cells.Count;
      *NotNull(points, "points") = cells.Points;
      *NotNull(ids, "ids") = cells.Ids;
    });
}

int sculptor_get_bounds(
  int sculptor, const char* table, int* rows, int* columns, const int** values)
{
  return WithSession(sculptor,
    [=](SculptorSession& session)
    {
      vtkIntArray* array = session.GetGeometryTable(NotNull(table, "table"));
      *NotNull(rows, "rows") = static_cast<int>(array->GetNumberOfTuples());
      *NotNull(columns, "columns") = array->GetNumberOfComponents();
      *NotNull(values, "values") = array->GetPointer(0);
    });
}
