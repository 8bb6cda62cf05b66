/**
 * HostCommunicator: the ranks of a host code's MPI communicator, for VTK, with messages of their own.
 */
#pragma once

#include "vtkSmartPointer.h"

#include <mpi.h>

class vtkMultiProcessController;

namespace vfm
{

class HostCommunicator
{
public:
  HostCommunicator() = default;
  /// Frees the duplicate; collective unless MPI has ended.
  ~HostCommunicator();
  HostCommunicator(const HostCommunicator&) = delete;
  HostCommunicator& operator=(const HostCommunicator&) = delete;

  /// The ranks of a Fortran handle. Throws InputError when MPI does not run or it is no communicator.
  void Set(int communicator);
  /// Collective when called first: null where MPI does not run, else the controller of a duplicate of what was Set, or of
  /// MPI_COMM_WORLD. It belongs to this.
  vtkMultiProcessController* GetController();

private:
  void Free();

  MPI_Comm Given = MPI_COMM_NULL, Mine = MPI_COMM_NULL;
  vtkSmartPointer<vtkMultiProcessController> Controller;
};

} // namespace vfm
