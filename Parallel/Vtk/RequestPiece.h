/**
 * RequestPiece: the request of filters and writers of meshes to their input, and the ghost layers
 * that filters claim to have.
 */
#pragma once

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace vfm
{

/// Requests the piece of this rank from the first input, without ghost cells.
inline void RequestPiece(vtkMultiProcessController* controller, vtkInformationVector** inputVector)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(),
    controller ? controller->GetLocalProcessId() : 0);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(),
    controller ? controller->GetNumberOfProcesses() : 1);
  input->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

/// Sets a number of ghost layers on all outputs of a filter that never marks ghost cells, so that a
/// later request for ghost layers does not run it again.
inline void ClaimGhostLayers(vtkInformationVector* outputVector)
{
  constexpr int claimed = 4;
  const auto levels = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS();
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Set(levels, std::max(info->Get(levels), claimed));
  }
}

} // namespace vfm
