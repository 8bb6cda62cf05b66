#include "vtkVolumeFractionVoxelReader.h"

#include "Base/Runtime.h"
#include "ControllerRanks.h"
#include "FailedOutput.h"
#include "FindProblem.h"
#include "ImageExtent.h"
#include "Ranks/Agreement.h"
#include "ReadVoxels.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkVolumeFractionVoxelReader);
vtkCxxSetObjectMacro(vtkVolumeFractionVoxelReader, Controller, vtkMultiProcessController);

vtkVolumeFractionVoxelReader::vtkVolumeFractionVoxelReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionVoxelReader::~vtkVolumeFractionVoxelReader()
{
  this->SetController(nullptr);
}

vfm::VoxelFile vtkVolumeFractionVoxelReader::Inspect() const
{
  return vfm::InspectVoxels(this->FileName,
    { this->Dimensions[0], this->Dimensions[1], this->Dimensions[2] },
    static_cast<vfm::AxisOrder>(this->AxisOrder));
}

vfm::Index3 vtkVolumeFractionVoxelReader::FindSize() const
{
  for (int a = 0; a < 3; ++a)
  {
    if (!(this->Spacing[a] > 0.0) || !std::isfinite(this->Spacing[a] + this->Origin[a]))
    {
      throw vfm::InputError("Spacing must be above 0, and Origin finite.");
    }
  }
  const vfm::Index3 cells = this->Inspect().Cells;
  // A text of which the size is not told yet is refused when it is read.
  return *std::min_element(cells.begin(), cells.end()) > 0 ? cells : vfm::Index3{};
}

int vtkVolumeFractionVoxelReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vfm::Index3 cells{};
  this->Problem.clear(); // told by RequestData, once
  try
  {
    vfm::ControllerRanks ranks(this->Controller);
    vfm::WorkTogether(ranks, [&] { cells = this->FindSize(); });
  }
  catch (const vfm::InputError& error)
  {
    this->Problem = error.what();
    cells = {};
  }
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  for (int a = 0; a < 3 && cells[0] > 0; ++a)
  {
    extent[2 * a + 1] = static_cast<int>(cells[a]);
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), this->Origin, 3);
  info->Set(vtkDataObject::SPACING(), this->Spacing, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkVolumeFractionVoxelReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(Pipeline::UPDATE_EXTENT(), extent);
  std::string problem = this->Problem;
  if (problem.empty())
  {
    problem = vfm::FindProblem([&] { this->Read(extent, image); });
  }
  if (!problem.empty())
  {
    vfm::Fail(this, outputVector, ("Cannot read " + this->FileName + ": " + problem).c_str());
  }
  return 1;
}

void vtkVolumeFractionVoxelReader::Read(const int extent[6], vtkImageData* image) const
{
  const vfm::VoxelFile file = this->Inspect();
  const vfm::IndexBox box =
    vfm::IsEmptyExtent(extent) ? vfm::IndexBox() : vfm::FindCells(extent, file.Cells);
  const auto arrays = vfm::ReadVoxels(file, box);
  if (vfm::IsEmptyExtent(extent))
  {
    return;
  }
  image->SetExtent(const_cast<int*>(extent));
  image->SetOrigin(this->Origin);
  image->SetSpacing(this->Spacing);
  for (const auto& array : arrays)
  {
    image->GetCellData()->AddArray(array);
  }
  image->GetCellData()->SetActiveScalars(arrays[0]->GetName());
}

void vtkVolumeFractionVoxelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const auto& values)
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  os << indent << "FileName: " << this->FileName << "\n";
  print("Dimensions", this->Dimensions);
  print("Origin", this->Origin);
  print("Spacing", this->Spacing);
  os << indent << "AxisOrder: " << this->AxisOrder << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
