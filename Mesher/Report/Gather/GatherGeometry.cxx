#include "Report/Gather/GatherGeometry.h"

#include "Ranks/NumberKeys.h"
#include "Ranks/WorkTogether.h"
#include "Report/Gather/GatherMesh.h"
#include "Report/MeshFields.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

/// Cells of one kind on this rank.
struct OwnCells
{
  const char* Name;
  int Corners;
  const Buffer<Index>& Points;   ///< points of the mesh, Corners per cell
  std::vector<MeshArray> Arrays; ///< cells are sorted by the first array
  FieldArrays Fields;
};

std::vector<OwnCells> ListCells(const Mesh& mesh)
{
  const auto numbers = [](const char* name, const Buffer<int>& values, int components = 1) {
    return MeshArray{ name, ValueType::Int, components, {}, values.data() };
  };
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const GeometryTables& tables = mesh.Tables;
  return { { "Surfaces", mesh.CornersOfFacet(), surfaces.Points,
             { numbers("SurfaceId", surfaces.SurfaceId),
               numbers("MaterialPair", surfaces.MaterialPair, 2),
               numbers("DomainSide", surfaces.DomainSide) },
             tables.HasAllSurfaces ? ListSurfaces(tables) : FieldArrays() },
    { "Curves", 2, mesh.Curves.Points, { numbers("CurveId", mesh.Curves.CurveId) },
      tables.HasAllCurves ? ListCurves(tables) : FieldArrays() },
    { "Vertices", 1, mesh.Vertices.Points, { numbers("VertexId", mesh.Vertices.VertexId) },
      tables.HasAllCurves ? ListVertices(tables) : FieldArrays() } };
}

void SetCellIds(std::vector<Index> ids, StoredMesh& cells)
{
  cells.Data.ElementIds = cells.Store(std::move(ids));
  cells.Data.ElementArrays.back().Values = cells.Data.ElementIds;
}

/// Returns the cells with the points that they use, and ids from firstId on as last array.
StoredMesh ViewCells(const Mesh& mesh, const OwnCells& own, Index firstId)
{
  std::vector<Index> used(own.Points.begin(), own.Points.end()), elements, pointIds;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::transform(own.Points.begin(), own.Points.end(), std::back_inserter(elements),
    [&used](Index point)
    { return std::lower_bound(used.begin(), used.end(), point) - used.begin(); });
  std::vector<double> points;
  for (Index point : used)
  {
    points.insert(
      points.end(), mesh.Points.data() + 3 * point, mesh.Points.data() + 3 * (point + 1));
    pointIds.push_back(mesh.UnsplitPointIds()[point]);
  }
  StoredMesh cells;
  MeshData& data = cells.Data;
  data.Corners = own.Corners;
  data.NumberOfPoints = static_cast<Index>(used.size());
  data.NumberOfElements = static_cast<Index>(elements.size()) / own.Corners;
  data.Points = cells.Store(std::move(points));
  data.Elements = cells.Store(std::move(elements));
  data.PointIds = cells.Store(std::move(pointIds));
  data.PointArrays = { { "GlobalPointIds", ValueType::Id, 1, {}, data.PointIds } };
  data.ElementArrays = own.Arrays;
  data.ElementArrays.push_back({ "GlobalCellIds", ValueType::Id, 1, {}, nullptr });
  std::vector<Index> ids(data.NumberOfElements);
  std::iota(ids.begin(), ids.end(), firstId);
  SetCellIds(std::move(ids), cells);
  return cells;
}

/// Sorts cells by their numbers, then by their points, and removes their ids.
StoredMesh SortCells(StoredMesh cells)
{
  const MeshData& data = cells.Data;
  const auto* numbers = static_cast<const int*>(data.ElementArrays[0].Values);
  std::vector<Index> order(data.NumberOfElements), ids(data.NumberOfElements);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b)
    {
      return numbers[a] != numbers[b]
        ? numbers[a] < numbers[b]
        : std::lexicographical_compare(
            data.Element(a), data.Element(a + 1), data.Element(b), data.Element(b + 1));
    });
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    ids[order[place]] = static_cast<Index>(place) + 1;
  }
  SetCellIds(std::move(ids), cells);
  Ranks alone;
  StoredMesh sorted = OrderMesh(data, alone);
  sorted.Memory.insert(sorted.Memory.end(), cells.Memory.begin(), cells.Memory.end());
  sorted.Data.ElementArrays.pop_back();
  return sorted;
}

} // namespace

std::vector<GeometryPart> GatherGeometry(const Mesh& mesh, Ranks& ranks)
{
  std::vector<GeometryPart> parts;
  for (const OwnCells& own : ListCells(mesh))
  {
    const auto count = static_cast<Index>(own.Points.size()) / own.Corners;
    const Index firstId = SumOfLowerRanks(count, ranks) + 1;
    StoredMesh part;
    WorkTogether(ranks, [&] { part = ViewCells(mesh, own, firstId); });
    StoredMesh whole = GatherMesh(part.Data, ranks);
    WorkTogether(ranks,
      [&]
      {
        if (ranks.Rank() == 0 && whole.Data.NumberOfElements > 0)
        {
          whole.Memory.insert(whole.Memory.end(), part.Memory.begin(), part.Memory.end());
          parts.push_back({ own.Name, SortCells(std::move(whole)) });
          parts.back().Cells.Data.Fields = own.Fields;
        }
      });
  }
  return parts;
}

} // namespace vfm
