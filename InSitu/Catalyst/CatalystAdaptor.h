/**
 * CatalystAdaptor: runs ParaView Catalyst scripts (version 2) inside a simulation, on its fields.
 *
 * A build uses one of two libraries. Legacy Catalyst is ParaView's own library. Catalyst 2 is
 * libcatalyst, which loads an implementation (of ParaView or others) at run time.
 *
 * Scripts find the grid as the input "input", composite data with one image per box, whose arrays
 * are the memory of the simulation. Images of finer levels have smaller cells; cells below finer
 * levels are hidden (vtkGhostType).
 * - Legacy Catalyst: vtkMultiBlockDataSet with one block per box of every rank. The global numbers
 *   are its field data.
 * - Catalyst 2: vtkPartitionedDataSetCollection; "box0" contains the first box of each rank, and so
 *   on. The global numbers are field data of each of them.
 */
#pragma once

#include "HostGrid.h"

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// Number of the whole simulation, equal on all ranks, for instance the number of fragments or the
/// energy. Scripts may use it as a trigger.
struct HostNumber
{
  std::string Name;
  double Value = 0.0;
};

class CatalystRun;

/// Catalyst in a process. Only one may be made during the life of the process, after MPI_Init; it
/// must be destroyed before MPI_Finalize. All calls are collective.
///
/// No function throws or ends the process. A failure on any rank is reported on all ranks, even if
/// some wait in a filter of this project for a rank whose script has failed. Ranks can only hang if
/// a script fails on some of them while others wait in a filter or writer of ParaView itself.
///
/// With Catalyst 2, it depends on the implementation whether the failure of a script is reported.
/// ParaView reports it since 6.0; earlier only if other ranks wait in a filter of this project.
class CatalystAdaptor
{
public:
  /// Starts Catalyst. A script that cannot be read is not run, see GetError.
  /// @param communicator  ranks of the simulation; it is duplicated, so that messages stay apart
  /// @param scripts  paths of Python scripts, which see the environment of the process
  /// @note Catalyst 2: libcatalyst loads the implementation that the environment variables
  ///   CATALYST_IMPLEMENTATION_NAME and CATALYST_IMPLEMENTATION_PATHS name. Without scripts any
  ///   implementation is accepted.
  CatalystAdaptor(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~CatalystAdaptor();
  CatalystAdaptor(const CatalystAdaptor&) = delete;
  CatalystAdaptor& operator=(const CatalystAdaptor&) = delete;

  /// Passes a step to the scripts.
  ///
  /// Legacy Catalyst: VTK data are made only if a script requests the step. A script that cannot be
  /// loaded is not run any more; one that fails in a step is called again in the next. Scripts see
  /// `last` as info.dataDescription.GetForceOutput().
  ///
  /// Catalyst 2: each step is passed; VTK data are made when a script updates the input. After a
  /// failure no further step is passed. Scripts see `last` as catalyst/state/last of
  /// info.catalyst_params.
  /// @param grid  boxes of this rank; its arrays must not change during this call
  /// @param time  time of the simulation
  /// @param step  number of the step, increasing
  /// @param numbers  numbers of the whole simulation, equal on all ranks
  /// @param last  whether no other step follows
  /// @return false, on all ranks, if a script fails or has been excluded before, or if the grid is
  ///   invalid on any rank; GetError returns the reason
  bool Process(const HostGrid& grid, double time, int step,
    const std::vector<HostNumber>& numbers = {}, bool last = false);

  /// Returns all failures, one per line, equal on all ranks; empty if there are none. Python has
  /// printed the traceback.
  const std::string& GetError() const;

  /// Returns the number of steps that were passed to scripts.
  int GetNumberOfStepsMade() const;

private:
  std::unique_ptr<CatalystRun> Run;
  std::string Error;
};

} // namespace vfm
