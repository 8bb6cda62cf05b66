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
namespace
{

bool HasPoints(const int* extent)
{
  return extent[0] <= extent[1] && extent[2] <= extent[3] && extent[4] <= extent[5];
}

} // namespace

void SetNoElements(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(VTK_EMPTY_CELL);
  types->Reset(); // keeps its memory
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(0, nullptr);
  cells->GetOffsetsArray()->SetNumberOfTuples(1);
  mesh->SetCells(types, cells);
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
  // VTK 9.3 and later end the program at negative numbers of points.
  if (image && extent && HasPoints(extent))
  {
    image->SetExtent(extent);
  }
}

} // namespace vfm
