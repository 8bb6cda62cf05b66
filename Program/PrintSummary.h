/**
 * PrintSummary: the table of a summary.
 */
#pragma once

#include "Summary/MeshSummary.h"

#include <iosfwd>

namespace vfm
{

struct StageTime
{
  std::string Name;
  double Seconds;
};

void PrintSummary(
  const MeshSummary& summary, const std::vector<StageTime>& times, std::ostream& to);

} // namespace vfm
