/**
 * FileBlocks: blocks of cells that were read from a file, for Python.
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
  std::vector<double> Times;  ///< times of all steps
  std::optional<double> Time; ///< time of the step that was read, if the file has times
  std::vector<std::string> Names,
    Fractions;        ///< arrays that were read, and the ones that hold materials
  std::string Labels; ///< array of labels; empty: none
  std::vector<InputBlock> Blocks;
};

/// Reads a SpyPlot case, an AMReX plotfile or an Exodus file.
/// @param step number of the step, from 0; negative numbers count from the end
/// @param names arrays to read; without value: all
/// @param isTrusted the limits that protect from harmful files do not apply (InputTrust)
/// @throws InputError if the file lacks the step or an array
FileBlocks ReadFileBlocks(const std::string& path, int step,
  const std::optional<std::vector<std::string>>& names, bool isTrusted);

} // namespace vfm
