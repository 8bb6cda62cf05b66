#include "vtkVolumeFractionFilter.h"

#include "CollectivePipeline.h"
#include "Options/SetOptions.h"
#include "RequestPiece.h"

vtkCxxSetObjectMacro(vtkVolumeFractionFilter, Controller, vtkMultiProcessController);

vtkVolumeFractionFilter::vtkVolumeFractionFilter() : Options(std::make_unique<vfm::MesherOptions>())
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionFilter::~vtkVolumeFractionFilter()
{
  this->SetController(nullptr);
}

vtkExecutive* vtkVolumeFractionFilter::CreateDefaultExecutive()
{
  return vfm::CollectivePipeline::Make([this] { return this->Controller; });
}

int vtkVolumeFractionFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vfm::ClaimGhostLayers(outputVector);
  vfm::RequestPiece(this->Controller, inputVector);
  return 1;
}

void vtkVolumeFractionFilter::SetNumber(const char* option, double value)
{
  if (vfm::SetClamped(*this->Options, option, value))
  {
    this->Modified();
  }
}

double vtkVolumeFractionFilter::GetNumber(const char* option) const
{
  return vfm::FindOption(option)->GetNumber(*this->Options);
}

void vtkVolumeFractionFilter::SetText(const char* option, const char* value)
{
  if (vfm::SetText(*this->Options, option, value ? value : ""))
  {
    this->Modified();
  }
}

const char* vtkVolumeFractionFilter::GetText(const char* option) const
{
  return ((*this->Options).*vfm::FindOption(option)->Text).c_str();
}

void vtkVolumeFractionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
