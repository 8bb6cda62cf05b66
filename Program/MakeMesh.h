/**
 * MakeMesh: runs a mesher on the input of all ranks and tells what it says.
 */
#pragma once

#include "Arguments.h"
#include "ChooseArrays.h"

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkMultiProcessController;
class vtkUnstructuredGrid;
class vtkVolumeFractionMeshAlgorithm;

namespace vfm
{

/// The mesher with its options. Throws InputError (WrongArguments) on options that it does not have.
vtkSmartPointer<vtkVolumeFractionMeshAlgorithm> MakeMesher(const Arguments& arguments);

/// Collective: this rank's part of the mesh. Shows the progress on a terminal unless quiet, and warnings, on rank 0.
/// Throws InputError (RefusedMesh; InternalError for lack of memory) with the mesher's message.
vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(vtkVolumeFractionMeshAlgorithm& mesher,
  vtkDataObject* data, const ChosenArrays& arrays, bool isQuiet,
  vtkMultiProcessController* controller);

} // namespace vfm
