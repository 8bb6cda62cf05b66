#include "GatherGeometry.h"

#include "GatherMesh.h"
#include "Ranks/WorkTogether.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace vfm
{
namespace
{

using MeshPointer = vtkSmartPointer<vtkUnstructuredGrid>;

/// By the number of corners of the cells: vertices, edges, facets.
int TypeOf(vtkIdType corners)
{
  constexpr int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_QUAD };
  return types[corners - 1];
}

vtkCellArray* CellsOf(vtkPolyData* data)
{
  return data->GetNumberOfVerts() > 0 ? data->GetVerts()
    : data->GetNumberOfLines() > 0    ? data->GetLines()
                                      : data->GetPolys();
}

/// Its cells with ids in the order of the ranks, which GatherMesh keeps.
MeshPointer AsMesh(vtkPolyData* part, vtkIdType firstId)
{
  auto mesh = MeshPointer::New();
  mesh->SetPoints(part->GetPoints());
  if (part->GetNumberOfCells() > 0)
  {
    mesh->SetCells(TypeOf(CellsOf(part)->GetCellSize(0)), CellsOf(part));
  }
  mesh->GetPointData()->ShallowCopy(part->GetPointData());
  mesh->GetCellData()->ShallowCopy(part->GetCellData());
  mesh->GetFieldData()->ShallowCopy(part->GetFieldData());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalCellIds");
  ids->SetNumberOfValues(part->GetNumberOfCells());
  std::iota(ids->Begin(), ids->End(), firstId);
  mesh->GetCellData()->SetGlobalIds(ids);
  return mesh;
}

/// The places of the cells in their order.
std::vector<vtkIdType> SortCells(vtkUnstructuredGrid* mesh)
{
  vtkDataArray* numbers = mesh->GetCellData()->GetScalars();
  vtkNew<vtkIdList> own, other; // both at a time, which a cell array need not hold as such
  const auto isBefore = [&](vtkIdType a, vtkIdType b)
  {
    const double of[2] = { numbers->GetComponent(a, 0), numbers->GetComponent(b, 0) };
    mesh->GetCells()->GetCellAtId(a, own);
    mesh->GetCells()->GetCellAtId(b, other);
    return of[0] != of[1]
      ? of[0] < of[1]
      : std::lexicographical_compare(own->begin(), own->end(), other->begin(), other->end());
  };
  std::vector<vtkIdType> order(mesh->GetNumberOfCells());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), isBefore);
  return order;
}

vtkSmartPointer<vtkPolyData> FromMesh(vtkUnstructuredGrid* mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(mesh->GetPoints());
  data->GetPointData()->ShallowCopy(mesh->GetPointData());
  data->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  mesh->GetCellData()->RemoveArray("GlobalCellIds");
  const std::vector<vtkIdType> order = SortCells(mesh);
  data->GetCellData()->CopyAllocate(mesh->GetCellData(), mesh->GetNumberOfCells());
  vtkNew<vtkCellArray> cells;
  for (std::size_t c = 0; c < order.size(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetCells()->GetCellAtId(order[c], size, corners);
    cells->InsertNextCell(size, corners);
    data->GetCellData()->CopyData(mesh->GetCellData(), order[c], static_cast<vtkIdType>(c));
  }
  const int type = order.empty() ? VTK_EMPTY_CELL : mesh->GetCellType(0);
  if (type == VTK_VERTEX)
  {
    data->SetVerts(cells);
  }
  else if (type == VTK_LINE)
  {
    data->SetLines(cells);
  }
  else
  {
    data->SetPolys(cells);
  }
  return data;
}

} // namespace

vtkSmartPointer<vtkPolyData> GatherGeometry(vtkPolyData* part, Ranks& ranks)
{
  const std::vector<vtkIdType> counts =
    GatherItems(ranks, std::vector<vtkIdType>{ part->GetNumberOfCells() });
  const vtkIdType first =
    std::accumulate(counts.begin(), counts.begin() + ranks.Rank(), vtkIdType(1));
  MeshPointer mesh;
  WorkTogether(ranks, [&] { mesh = AsMesh(part, first); });
  const MeshPointer whole = GatherMesh(mesh, ranks);
  vtkSmartPointer<vtkPolyData> data;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        data = FromMesh(whole);
      }
    });
  return data;
}

} // namespace vfm
