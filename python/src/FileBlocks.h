/**
 * FileBlocks: blocks of cells that were read from a file, as Python holds them.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

struct FileBlocks
{
  std::string Path;
  std::vector<double> Times; ///< of all steps
  double Time = 0.0;         ///< of the step that was read
  std::vector<std::string> Names,
    Fractions; ///< arrays that were read, and those that hold materials
  std::vector<InputBlock> Blocks;
};

/// Reads a SpyPlot case or an AMReX plotfile. step: negative ones count from the end. names: all without
/// them. Throws InputError when the file has no such step or array.
FileBlocks ReadFileBlocks(
  const std::string& path, int step, const std::optional<std::vector<std::string>>& names);

} // namespace vfm
