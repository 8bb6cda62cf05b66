/**
 * History: mass, momentum and energy of each body step by step, as a table.
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
  /// Collective. path: a .csv file, which rank 0 writes; empty: none. Throws std::runtime_error on
  /// all ranks when it cannot.
  History(const Domain& domain, const std::string& path);

  /// Collective: a row of what is in the grid, and of what has left it.
  void Add(std::int64_t step, const Solver& motion);

private:
  void Check();

  const Domain& Grid;
  std::string Path;
  std::ofstream File; // of rank 0
};

} // namespace impact
