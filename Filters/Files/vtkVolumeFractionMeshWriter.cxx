#include "vtkVolumeFractionMeshWriter.h"

#include "CollectivePipeline.h"
#include "ControllerRanks.h"
#include "FailedOutput.h"
#include "MeshDataOfGrid.h"
#include "Ranks/WorkTogether.h"
#include "RequestPiece.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

/// Returns whether the filter that made the mesh has particles in another output.
bool HasParticles(const vfm::MeshData& mesh)
{
  const std::vector<double> counts = vfm::NumbersOfField(mesh.Fields, "Particles");
  return std::any_of(counts.begin(), counts.end(), [](double count) { return count > 0.0; });
}

} // namespace

vtkCxxSetObjectMacro(vtkVolumeFractionMeshWriter, Controller, vtkMultiProcessController);

vtkVolumeFractionMeshWriter::vtkVolumeFractionMeshWriter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkVolumeFractionMeshWriter::~vtkVolumeFractionMeshWriter()
{
  this->SetController(nullptr);
}

vtkExecutive* vtkVolumeFractionMeshWriter::CreateDefaultExecutive()
{
  return vfm::CollectivePipeline::Make([this] { return this->Controller; });
}

int vtkVolumeFractionMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkTypeBool vtkVolumeFractionMeshWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vfm::RequestPiece(this->Controller, inputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkVolumeFractionMeshWriter::Write()
{
  // RequestData resets the error; it is not called if the input failed.
  this->SetErrorCode(vtkErrorCode::UserError);
  return this->Superclass::Write();
}

void vtkVolumeFractionMeshWriter::WriteData()
{
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  try
  {
    vfm::ControllerRanks ranks(this->Controller);
    vfm::WorkTogether(ranks,
      [&]
      {
        const char* why = vfm::FindFailure(mesh);
        if (*why)
        {
          throw vfm::InputError(std::string("The mesh could not be made: ") + why);
        }
        const vfm::StoredMesh stored = vfm::MeshDataOf(mesh);
        this->WriteMesh(stored.Data, this->FileName, ranks);
        if (ranks.Rank() == 0 && HasParticles(stored.Data))
        {
          vtkWarningMacro(<< this->FileName
                          << " has no particles: they are the output Particles "
                             "of the filter. Save that output, too.");
        }
      });
  }
  catch (const vfm::InputError& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("Cannot write " << this->FileName << ": " << error.what());
  }
}

void vtkVolumeFractionMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
}
