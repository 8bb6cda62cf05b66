/**
 * History: table of mass, momentum and energy of each body at each step.
 */
#pragma once

#include "Solver.h"

#include <fstream>
#include <string>

namespace impact
{

class History
{
public:
  /// Opens the table and writes its header.
  /// @param[in] path  .csv file that rank 0 writes; if empty, no file is written
  /// @throws std::runtime_error  if the file cannot be written, on all ranks
  /// @pre Collective
  History(const Domain& domain, const std::string& path);

  /// Writes a row with the totals of points in the grid and of points that have left it.
  /// @pre Collective
  void Add(std::int64_t step, const Solver& motion);

private:
  void Check();

  const Domain& Grid;
  std::string Path;
  std::ofstream File; // open only on rank 0
};

} // namespace impact
