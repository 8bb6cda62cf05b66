/**
 * CatalystAdaptor: runs ParaView Catalyst scripts (version 2) on the fields of a simulation, inside it.
 *
 * The scripts find the grid as the input "input": a vtkMultiBlockDataSet with an image for every box of every rank,
 * whose arrays are the host's memory, and with the global numbers as field data. Images of finer levels have smaller cells; cells
 * below those of finer levels are hidden (vtkGhostType). Nothing here throws, ends the host or
 * leaves ranks behind: what fails anywhere is told on all ranks, also to those that wait in a filter of this project for a rank
 * whose script has raised. A script may hang the ranks only by itself, when it raises on some of them while others wait for these in
 * a filter or writer of ParaView's own.
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

class CatalystAdaptor
{
public:
  /// communicator: the ranks of the simulation; duplicated, so messages stay apart. scripts: paths of Python scripts,
  /// which see the environment of the process. A script that cannot be read is left out: see GetError.
  CatalystAdaptor(MPI_Comm communicator, const std::vector<std::string>& scripts);
  ~CatalystAdaptor();
  CatalystAdaptor(const CatalystAdaptor&) = delete;
  CatalystAdaptor& operator=(const CatalystAdaptor&) = delete;

  /// Asks the scripts whether they want this step and hands it to those that do. Makes no VTK data when none does.
  /// The host's arrays must stay as they are during this call alone. time: of the simulation; step: counts up;
  /// last: whether no other step follows (the scripts see it as info.dataDescription.GetForceOutput()).
  /// False, on all ranks alike, when a script failed now or was left out before, or the grid is wrong on any rank;
  /// then GetError tells. A script whose code cannot be loaded is left out from then on; one that fails in a
  /// step is called again in the next.
  bool Process(const HostGrid& grid, double time, int step,
    const std::vector<HostNumber>& numbers = {}, bool last = false);

  /// What failed, the same text on all ranks, one failure a line; empty when all is well. Python has printed where.
  const std::string& GetError() const;

  /// The steps for which VTK data were made.
  int GetNumberOfStepsMade() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};

} // namespace vfm
