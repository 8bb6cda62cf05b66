#include "ShareHead.h"

#include "Base/Runtime.h"
#include "PackMesh.h"
#include "Ranks/Agreement.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace vfm
{
namespace
{

using MeshPointer = vtkSmartPointer<vtkUnstructuredGrid>;

/// The first element alone: files of no element would not keep the arrays.
MeshPointer TakeFirst(vtkUnstructuredGrid* mesh)
{
  vtkIdType size = 0;
  const vtkIdType* points = nullptr;
  mesh->GetCells()->GetCellAtId(0, size, points);
  auto first = MeshPointer::New();
  vtkNew<vtkPoints> coordinates;
  first->GetPointData()->CopyAllOn();
  first->GetPointData()->CopyAllocate(mesh->GetPointData(), size);
  std::vector<vtkIdType> corners;
  for (vtkIdType c = 0; c < size; ++c)
  {
    corners.push_back(coordinates->InsertNextPoint(mesh->GetPoint(points[c])));
    first->GetPointData()->CopyData(mesh->GetPointData(), points[c], c);
  }
  first->SetPoints(coordinates);
  first->GetCellData()->CopyAllOn();
  first->GetCellData()->CopyAllocate(mesh->GetCellData(), 1);
  first->InsertNextCell(mesh->GetCellType(0), size, corners.data());
  first->GetCellData()->CopyData(mesh->GetCellData(), vtkIdType(0), vtkIdType(0));
  first->GetFieldData()->ShallowCopy(mesh->GetFieldData());
  return first;
}

void Empty(vtkDataSetAttributes* data)
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    data->GetAbstractArray(a)->SetNumberOfTuples(0);
  }
}

} // namespace

MeshPointer ShareHead(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  const bool isFilled = mesh->GetNumberOfCells() > 0;
  const double first = -ranks.Max(isFilled ? -ranks.Rank() : -ranks.Count());
  if (first >= ranks.Count())
  {
    throw InputError("The mesh is empty.");
  }
  if (!ranks.Any(!isFilled))
  {
    return mesh;
  }
  Bytes head;
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == static_cast<int>(first))
      {
        head = PackGrid(TakeFirst(mesh));
      }
    });
  const std::vector<Bytes> heads = ranks.Gather(head);
  if (isFilled)
  {
    return mesh;
  }
  MeshPointer whole = UnpackGrid(heads[static_cast<std::size_t>(first)]);
  auto empty = MeshPointer::New();
  vtkNew<vtkPoints> none;
  empty->SetPoints(none);
  empty->AllocateExact(0, 0);
  empty->GetPointData()->ShallowCopy(whole->GetPointData());
  empty->GetCellData()->ShallowCopy(whole->GetCellData());
  empty->GetFieldData()->ShallowCopy(whole->GetFieldData());
  Empty(empty->GetPointData());
  Empty(empty->GetCellData());
  return empty;
}

} // namespace vfm
