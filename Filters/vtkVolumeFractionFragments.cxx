#include "vtkVolumeFractionFragments.h"

#include "CollectivePipeline.h"
#include "ControllerRanks.h"
#include "FailedOutput.h"
#include "FieldValues.h"
#include "MeshDataOfGrid.h"
#include "Ranks/WorkTogether.h"
#include "Report/FragmentTable.h"
#include "RequestPiece.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkVolumeFractionFragments);
vtkCxxSetObjectMacro(vtkVolumeFractionFragments, Controller, vtkMultiProcessController);

vtkVolumeFractionFragments::vtkVolumeFractionFragments()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionFragments::~vtkVolumeFractionFragments()
{
  this->SetController(nullptr);
}

void vtkVolumeFractionFragments::AddDensityArray(const char* name)
{
  if (name && *name)
  {
    this->DensityArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkVolumeFractionFragments::ClearDensityArrays()
{
  this->DensityArrays.clear();
  this->Modified();
}

vtkExecutive* vtkVolumeFractionFragments::CreateDefaultExecutive()
{
  return vfm::CollectivePipeline::Make([this] { return this->Controller; });
}

int vtkVolumeFractionFragments::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkVolumeFractionFragments::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vfm::RequestPiece(this->Controller, inputVector);
  return 1;
}

int vtkVolumeFractionFragments::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    vfm::ControllerRanks ranks(this->Controller);
    vfm::WorkTogether(ranks,
      [&]
      {
        vfm::StoredMesh mesh;
        vfm::WorkTogether(
          ranks, [&] { mesh = vfm::MeshDataOf(vtkUnstructuredGrid::GetData(inputVector[0])); });
        vfm::AddColumns(vfm::MakeFragmentTable(mesh.Data, this->DensityArrays, ranks),
          vtkTable::GetData(outputVector));
      });
  }
  catch (const vfm::InputError& error)
  {
    vfm::Fail(this, outputVector, error.what());
  }
  return 1;
}

void vtkVolumeFractionFragments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DensityArrays:";
  for (const std::string& name : this->DensityArrays)
  {
    os << " '" << name << "'";
  }
  os << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
