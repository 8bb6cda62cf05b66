#include "EmptyMesh.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace vfm
{

void SetNoElements(vtkUnstructuredGrid* mesh)
{
  mesh->AllocateExact(1, 1);
  mesh->InsertNextCell(VTK_EMPTY_CELL, 0, nullptr);
  mesh->GetCellTypesArray()->Reset(); // keeps its memory
  mesh->GetCells()->GetOffsetsArray()->SetNumberOfTuples(1);
}

void MakeEmpty(vtkDataObject* data)
{
  data->Initialize();
  if (vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::SafeDownCast(data))
  {
    vtkNew<vtkPoints> points;
    mesh->SetPoints(points);
    SetNoElements(mesh);
  }
}

} // namespace vfm
