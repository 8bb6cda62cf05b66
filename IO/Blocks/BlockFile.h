/**
 * BlockFile: a file, or several, of blocks of cells on any number of levels, at one or more times.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <memory>
#include <string>
#include <vector>

namespace vfm
{

class BlockFile
{
public:
  virtual ~BlockFile() = default;

  /// Times of all steps, ascending.
  const std::vector<double>& Times() const { return this->StepTimes; }
  /// Names of the arrays in cells, in the order of the file.
  const std::vector<std::string>& Names() const { return this->ArrayNames; }

  /// Collective. Returns this rank's part of the blocks of a step, with the arrays of these names,
  /// without ghost cells. Throws InputError that names the file and the place.
  virtual std::vector<InputBlock> Read(
    std::size_t step, const std::vector<std::string>& names, Ranks& ranks) const = 0;

protected:
  std::vector<double> StepTimes;
  std::vector<std::string> ArrayNames;
};

constexpr const char* SpyPlotSuffix = ".spcth";

/// Whether it is a SpyPlot file (by its suffix .spcth), or the folder of an AMReX plotfile.
bool IsBlockFile(const std::string& path);

/// Checks the structure, on every rank of its part. Throws InputError.
std::unique_ptr<BlockFile> OpenBlockFile(const std::string& path, const Ranks& ranks);

/// Opens a case of the shock code CTH: a file that names binary files (SpyPlotFile), or one of these.
std::unique_ptr<BlockFile> OpenSpyPlot(const std::string& path, const Ranks& ranks);

/// Opens a plotfile of a code on AMReX (BoxLib).
///
/// It is a folder. Its text file Header lists the arrays, the levels with their ratios and cell sizes,
/// and the boxes of each level; Level_0/Cell_H and so on give the boxes as cells, and for each its place
/// in a binary file of the same folder: a line of text, then the values, an array after the other, x
/// fastest. Particles are ignored.
std::unique_ptr<BlockFile> OpenPlotfile(const std::string& folder);

/// Whether it is a folder that holds a file Header.
bool IsPlotfile(const std::string& path);

} // namespace vfm
