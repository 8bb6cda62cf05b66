/**
 * RequestPiece: the request of filters and writers of meshes to their input.
 */
#pragma once

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

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

} // namespace vfm
