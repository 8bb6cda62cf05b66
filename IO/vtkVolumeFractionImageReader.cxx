#include "vtkVolumeFractionImageReader.h"

#include "Base/Runtime.h"
#include "ControllerRanks.h"
#include "FailedOutput.h"
#include "FindProblem.h"
#include "ImageExtent.h"
#include "Images/DealImage.h"
#include "Images/ImageFile.h"
#include "Ranks/WorkTogether.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkVolumeFractionImageReader);
vtkCxxSetObjectMacro(vtkVolumeFractionImageReader, Controller, vtkMultiProcessController);

namespace
{

bool IsReal(vtkDataArray* values)
{
  return values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE;
}

/// Row by row; its columns are the axes of the image.
std::array<double, 9> GetDirection(const vfm::ImagePlace& place)
{
  std::array<double, 9> direction;
  for (int i = 0; i < 9; ++i)
  {
    direction[i] = place.Axes[i % 3][i / 3];
  }
  return direction;
}

/// FindProblem of a step(ranks) that all processes do together.
template <class Step>
std::string FindProblemOfAll(vtkMultiProcessController* controller, const Step& step)
{
  return vfm::FindProblem(
    [&]
    {
      vfm::ControllerRanks ranks(controller);
      vfm::WorkTogether(ranks, [&] { step(ranks); });
    });
}

} // namespace

vtkVolumeFractionImageReader::vtkVolumeFractionImageReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionImageReader::~vtkVolumeFractionImageReader()
{
  this->SetController(nullptr);
}

void vtkVolumeFractionImageReader::Open()
{
  this->File.reset();
  const bool isSet =
    std::any_of(this->Spacing, this->Spacing + 3, [](double s) { return s != 0.0; });
  if (isSet && !std::all_of(this->Spacing, this->Spacing + 3, [](double s) { return s > 0.0; }))
  {
    throw vfm::InputError("Spacing must be above 0 along all axes, or 0 for that of the file.");
  }
  this->File = vfm::OpenImageFile(this->FileName, this->CellArray);
  if (isSet)
  {
    this->File->SetSpacing({ { this->Spacing[0], this->Spacing[1], this->Spacing[2] } });
  }
}

int vtkVolumeFractionImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->Problem = FindProblemOfAll(
    this->Controller, [this](vfm::Ranks&) { this->Open(); }); // RequestData tells it, once
  if (!this->Problem.empty())
  {
    this->File.reset();
  }
  const vfm::ImagePlace place = this->File ? this->File->Place() : vfm::ImagePlace();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  for (int a = 0; this->File && a < 3; ++a)
  {
    extent[2 * a + 1] = static_cast<int>(place.Size[a]) - (this->File->IsOfCells() ? 0 : 1);
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), place.Origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), place.Spacing.data(), 3);
  info->Set(vtkDataObject::DIRECTION(), GetDirection(place).data(), 9);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkVolumeFractionImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(Pipeline::UPDATE_EXTENT(), extent);
  std::string problem = this->Problem;
  if (problem.empty())
  {
    problem = FindProblemOfAll(
      this->Controller, [&](vfm::Ranks& ranks) { this->Read(extent, ranks, image); });
  }
  if (!problem.empty())
  {
    vfm::Fail(this, outputVector, ("Cannot read " + this->FileName + ": " + problem).c_str());
  }
  return 1;
}

void vtkVolumeFractionImageReader::Read(const int extent[6], vfm::Ranks& ranks, vtkImageData* image)
{
  const vfm::ImagePlace& place = this->File->Place();
  const bool isEmpty = vfm::IsEmptyExtent(extent), isOfCells = this->File->IsOfCells();
  vfm::IndexBox box;
  if (!isEmpty)
  {
    box = isOfCells ? vfm::FindCells(extent, place.Size) : vfm::FindPoints(extent);
  }
  const vtkSmartPointer<vtkDataArray> values = vfm::ReadPart(*this->File, box, ranks);
  if (isEmpty)
  {
    return;
  }
  image->SetExtent(const_cast<int*>(extent));
  image->SetOrigin(place.Origin.data());
  image->SetSpacing(place.Spacing.data());
  image->SetDirectionMatrix(GetDirection(place).data());
  values->SetName(isOfCells ? this->CellArray.c_str() : IsReal(values) ? "Values" : "Labels");
  image->GetAttributes(isOfCells ? vtkDataObject::CELL : vtkDataObject::POINT)->SetScalars(values);
}

void vtkVolumeFractionImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "CellArray: " << this->CellArray << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
