/**
 * PrintSummary: prints the table of a summary.
 */
#pragma once

#include "Report/MeshSummary.h"
#include "Report/Sets/MaterialBins.h"

#include <iosfwd>

namespace vfm
{

/// Time of a stage of the program.
struct StageTime
{
  std::string Name;
  double Seconds;
};

/// Prints the tables of materials, state, fragments and dihedral angles, and the times.
/// @param particles  paths of files with the particles beside other files
void PrintSummary(const MeshSummary& summary, const std::vector<std::string>& particles,
  const std::vector<StageTime>& times, std::ostream& to);

/// Prints the table of bins; nothing if there are none.
void PrintBins(const std::vector<MaterialBin>& bins, std::ostream& to);

} // namespace vfm
