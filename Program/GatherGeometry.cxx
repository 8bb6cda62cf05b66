#include "GatherGeometry.h"

#include "MeshDataOfGrid.h"
#include "Ranks/WorkTogether.h"
#include "Summary/GatherMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace vfm
{
namespace
{

constexpr const char* CellIds = "GlobalCellIds";

/// The cells, with ids in the order of the ranks, which GatherMesh keeps.
StoredMesh ViewPart(vtkPolyData* part, Index firstId)
{
  StoredMesh mesh = MeshDataOf(part);
  std::vector<Index> ids(mesh.Data.NumberOfElements);
  std::iota(ids.begin(), ids.end(), firstId);
  mesh.Data.ElementArrays.push_back({ CellIds, ValueType::Id, 1, {}, mesh.Keep(std::move(ids)) });
  FindKnownArrays(mesh);
  return mesh;
}

/// The places of the cells in the order of their numbers, then of their points.
std::vector<Index> SortCells(const MeshData& mesh, const MeshArray& numbers)
{
  const auto isBefore = [&](Index a, Index b)
  {
    const double of[2] = { ValueAt(numbers, a), ValueAt(numbers, b) };
    return of[0] != of[1] ? of[0] < of[1]
                          : std::lexicographical_compare(mesh.Element(a), mesh.Element(a + 1),
                              mesh.Element(b), mesh.Element(b + 1));
  };
  std::vector<Index> order(mesh.NumberOfElements);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), isBefore);
  return order;
}

/// Adds an array with its tuples in that order.
void AddTuples(const MeshArray& array, const std::vector<Index>& order, vtkDataSetAttributes* data)
{
  vtkSmartPointer<vtkDataArray> copy;
  copy.TakeReference(vtkDataArray::CreateDataArray(array.Type));
  copy->SetName(array.Name.c_str());
  copy->SetNumberOfComponents(array.Components);
  copy->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
  VisitType(array.Type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      auto* to = static_cast<Value*>(copy->GetVoidPointer(0));
      for (Index tuple : order)
      {
        const Value* from = static_cast<const Value*>(array.Values) + array.Components * tuple;
        to = std::copy_n(from, array.Components, to);
      }
    });
  data->AddArray(copy);
}

vtkSmartPointer<vtkCellArray> CopyCells(const MeshData& mesh, const std::vector<Index>& order)
{
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(mesh.Corners * mesh.NumberOfElements);
  vtkIdType* to = corners->GetPointer(0);
  for (Index cell : order)
  {
    to = std::copy_n(mesh.Element(cell), mesh.Corners, to);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(mesh.Corners, corners);
  return cells;
}

vtkSmartPointer<vtkPolyData> FromMesh(const MeshData& mesh, const char* numbers)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfPoints);
  std::copy_n(mesh.Points, 3 * mesh.NumberOfPoints,
    static_cast<double*>(points->GetData()->GetVoidPointer(0)));
  data->SetPoints(points);
  std::vector<Index> order(mesh.NumberOfPoints);
  std::iota(order.begin(), order.end(), 0);
  for (const MeshArray& array : mesh.PointArrays)
  {
    AddTuples(array, order, data->GetPointData());
  }
  data->GetPointData()->SetGlobalIds(data->GetPointData()->GetArray("GlobalPointIds"));
  order = SortCells(mesh, GetArray(mesh.ElementArrays, numbers));
  for (const MeshArray& array : mesh.ElementArrays)
  {
    if (array.Name != CellIds)
    {
      AddTuples(array, order, data->GetCellData());
    }
  }
  data->GetCellData()->SetActiveScalars(numbers);
  const auto cells = CopyCells(mesh, order);
  mesh.Corners == 1     ? data->SetVerts(cells)
    : mesh.Corners == 2 ? data->SetLines(cells)
                        : data->SetPolys(cells);
  return data;
}

} // namespace

vtkSmartPointer<vtkPolyData> GatherGeometry(vtkPolyData* part, const char* numbers, Ranks& ranks)
{
  const std::vector<Index> counts =
    GatherItems(ranks, std::vector<Index>{ part->GetNumberOfCells() });
  const Index first = std::accumulate(counts.begin(), counts.begin() + ranks.Rank(), Index(1));
  StoredMesh mesh;
  WorkTogether(ranks, [&] { mesh = ViewPart(part, first); });
  const StoredMesh whole = GatherMesh(mesh.Data, ranks);
  vtkSmartPointer<vtkPolyData> data;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0 && whole.Data.NumberOfElements > 0)
      {
        data = FromMesh(whole.Data, numbers);
        data->GetFieldData()->ShallowCopy(part->GetFieldData());
      }
    });
  return data;
}

} // namespace vfm
