#include "vtkVolumeFractionPartReader.h"

#include "ControllerRanks.h"
#include "FailedOutput.h"
#include "Images/ImageSource.h"
#include "LabelNameFields.h"
#include "Ranks/WorkTogether.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <new>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkCxxSetObjectMacro(vtkVolumeFractionPartReader, Controller, vtkMultiProcessController);

namespace
{

bool IsEmptyExtent(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

/// Returns the points of an extent that is not empty.
vfm::IndexBox FindPoints(const int extent[6])
{
  return { { { extent[0], extent[2], extent[4] } },
    { { vfm::Index(extent[1]) + 1, vfm::Index(extent[3]) + 1, vfm::Index(extent[5]) + 1 } } };
}

/// Returns the cells of an extent of points. Next to a flat extent (VTK makes slices, and pieces of
/// less than a cell), one layer of cells is returned.
vfm::IndexBox FindCells(const int extent[6], const vfm::Index3& cells)
{
  vfm::IndexBox box;
  for (int a = 0; a < 3; ++a)
  {
    const bool isFlat = extent[2 * a] == extent[2 * a + 1];
    box.Lower[a] = std::min<vfm::Index>(extent[2 * a], isFlat ? cells[a] - 1 : cells[a]);
    box.Upper[a] = std::max(vfm::Index(extent[2 * a + 1]), box.Lower[a] + (isFlat ? 1 : 0));
  }
  return box;
}

/// Returns the direction matrix, row-major; its columns are the axes of the image.
std::array<double, 9> GetDirection(const vfm::ImagePlace& place)
{
  std::array<double, 9> direction;
  for (int i = 0; i < 9; ++i)
  {
    direction[i] = place.Axes[i % 3][i / 3];
  }
  return direction;
}

/// Calls step(ranks) together with all ranks. Returns the reason of a failure, or "".
template <class Step>
std::string FindProblem(vtkMultiProcessController* controller, const Step& step)
{
  try
  {
    vfm::ControllerRanks ranks(controller);
    vfm::WorkTogether(ranks, [&] { step(ranks); });
    return "";
  }
  catch (const vfm::InputError& error)
  {
    return error.what();
  }
  catch (const std::bad_alloc&)
  {
    return "not enough memory.";
  }
}

vtkSmartPointer<vtkDataArray> AdoptValues(vfm::TypedValues& values)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(values.Type));
  const vtkIdType count = values.Bytes.size() / vfm::WidthOfType(values.Type);
  array->SetName(values.Name.c_str());
  array->SetVoidArray(values.Bytes.release(), count, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

} // namespace

vtkVolumeFractionPartReader::vtkVolumeFractionPartReader() : Source(new vfm::ImageSource)
{
  this->SetNumberOfInputPorts(0);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionPartReader::~vtkVolumeFractionPartReader()
{
  this->SetController(nullptr);
}

int vtkVolumeFractionPartReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->Problem = FindProblem(this->Controller,
    [this](vfm::Ranks&) { *this->Source = this->Open(); }); // RequestData reports it, once
  if (!this->Problem.empty())
  {
    *this->Source = vfm::ImageSource();
  }
  const vfm::ImagePlace& place = this->Source->Place;
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  for (int a = 0; a < 3 && place.Size[a] > 0; ++a)
  {
    extent[2 * a + 1] = static_cast<int>(place.Size[a]) - (this->Source->IsOfCells ? 0 : 1);
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), place.Origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), place.Spacing.data(), 3);
  info->Set(vtkDataObject::DIRECTION(), GetDirection(place).data(), 9);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkVolumeFractionPartReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(Pipeline::UPDATE_EXTENT(), extent);
  std::string problem = this->Problem;
  if (problem.empty())
  {
    problem =
      FindProblem(this->Controller, [&](vfm::Ranks& ranks) { this->Read(extent, ranks, image); });
  }
  const std::string& warning = this->Source->Warning;
  if (problem.empty() && !warning.empty() &&
    (!this->Controller || this->Controller->GetLocalProcessId() == 0))
  {
    vtkWarningMacro(<< this->FileName << ": " << warning);
  }
  if (!problem.empty())
  {
    vfm::Fail(this, outputVector, ("Cannot read " + this->FileName + ": " + problem).c_str());
  }
  return 1;
}

void vtkVolumeFractionPartReader::Read(const int extent[6], vfm::Ranks& ranks, vtkImageData* image)
{
  const vfm::ImagePlace& place = this->Source->Place;
  const bool areOfCells = this->Source->IsOfCells, isEmpty = IsEmptyExtent(extent);
  vfm::IndexBox box;
  if (!isEmpty)
  {
    box = areOfCells ? FindCells(extent, place.Size) : FindPoints(extent);
  }
  std::vector<vfm::TypedValues> arrays = this->Source->Read(box, ranks);
  vfm::AddLabelNames(this->Source->Names, image->GetFieldData());
  if (isEmpty)
  {
    return;
  }
  image->SetExtent(const_cast<int*>(extent));
  image->SetOrigin(place.Origin.data());
  image->SetSpacing(place.Spacing.data());
  image->SetDirectionMatrix(GetDirection(place).data());
  vtkDataSetAttributes* attributes =
    image->GetAttributes(areOfCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  for (vfm::TypedValues& values : arrays)
  {
    attributes->AddArray(AdoptValues(values));
  }
  attributes->SetActiveScalars(attributes->GetArrayName(0));
}

void vtkVolumeFractionPartReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
