#include "EmptyOutput.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
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

void EmptyOutput(vtkInformation* port)
{
  vtkDataObject* data = vtkDataObject::GetData(port);
  if (!data)
  {
    return;
  }
  data->Initialize();
  if (vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::SafeDownCast(data))
  {
    vtkNew<vtkPoints> points;
    mesh->SetPoints(points);
    SetNoElements(mesh);
  }
  int* extent = port->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  vtkImageData* image = vtkImageData::SafeDownCast(data);
  if (image && extent)
  {
    image->SetExtent(extent);
  }
}

} // namespace vfm
