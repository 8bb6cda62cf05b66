/**
 * CatalystAdaptor: runs ParaView Catalyst scripts (version 2) on the fields of a simulation, inside it. Built of one of two kinds: of
 * the first by ParaView's own library, of the second by libcatalyst, which takes any implementation (ParaView's, others) when it runs.
 *
 * The scripts find the grid as the input "input": composite data with an image for every box,
 * whose arrays are the host's memory. Images of finer levels have smaller cells; cells
 * below those of finer levels are hidden (vtkGhostType). First kind: vtkMultiBlockDataSet, a block for every box of every rank, the
 * global numbers are its field data. Second kind: vtkPartitionedDataSetCollection, "box0" the first box of each rank and so on, the
 * global numbers are field data of each of these.
 *
 * Nothing here throws, ends the host or leaves ranks behind: what fails anywhere is told on all ranks, also to those that wait in a
 * filter of this project for a rank whose script has raised. A script may hang the ranks only by itself, when it raises on some of
 * them while others wait for these in a filter or writer of ParaView's own. In the second kind it depends on the implementation
 * whether a script's failure is told: ParaView's does from 6.0 on, before only where other ranks wait in a filter of this project.
 *
 * One in the life of a process; all calls are collective. Make it after MPI_Init, destroy it before MPI_Finalize.
 */
#pragma once

#include "HostGrid.h"

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// A number of the whole simulation, same on all ranks, that a script may wait for: how many fragments, how much energy.
struct HostNumber
{
  std::string Name;
  double Value = 0.0;
};

class CatalystRun;

class CatalystAdaptor
{
public:
  /// communicator: the ranks of the simulation; duplicated, so messages stay apart. scripts: paths of Python scripts,
  /// which see the environment of the process. A script that cannot be read is left out: see GetError. Second kind: libcatalyst loads the
  /// implementation that CATALYST_IMPLEMENTATION_NAME and CATALYST_IMPLEMENTATION_PATHS tell; without scripts any will do.
  CatalystAdaptor(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~CatalystAdaptor();
  CatalystAdaptor(const CatalystAdaptor&) = delete;
  CatalystAdaptor& operator=(const CatalystAdaptor&) = delete;

  /// Hands the step to the scripts. The host's arrays must stay as they are during this call alone. time: of the simulation;
  /// step: counts up; last: whether no other step follows.
  /// False, on all ranks alike, when a script failed now or was left out before, or the grid is wrong on any rank;
  /// then GetError tells.
  /// First kind: scripts are asked whether they want the step; VTK data are made when any does. A script whose code cannot be loaded is left
  /// out from then on; one that fails in a step is called again in the next. They see last as
  /// info.dataDescription.GetForceOutput().
  /// Second kind: each step is handed over; VTK data are made when a script updates the input. After a failure no other step is.
  /// They see last as catalyst/state/last of info.catalyst_params.
  bool Process(const HostGrid& grid, double time, int step,
    const std::vector<HostNumber>& numbers = {}, bool last = false);

  /// What failed, the same text on all ranks, one failure a line; empty when all is well. Python has printed where.
  const std::string& GetError() const;

  /// The steps that were handed over.
  int GetNumberOfStepsMade() const;

private:
  std::unique_ptr<CatalystRun> Run;
  std::string Error;
};

} // namespace vfm
