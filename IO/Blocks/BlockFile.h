/**
 * BlockFile: reads files of blocks of cells on any number of levels, at one or more times: SpyPlot
 * files of CTH, AMReX plotfiles and Exodus files of hexahedra.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace vfm
{

/// Input of blocks of cells, from one file or several. It holds the structure; values are read on
/// demand. It does not change after it is opened.
class BlockFile
{
public:
  virtual ~BlockFile() = default;

  /// Returns the times of all steps, ascending; empty if the file has one step without a time.
  const std::vector<double>& Times() const { return this->StepTimes; }
  /// Returns the names of the cell arrays, in the order of the file; equal on all ranks.
  const std::vector<std::string>& Names() const { return this->ArrayNames; }
  /// Returns whether an array can be read; arrays that few users need are not among Names().
  virtual bool Has(const std::string& name) const
  {
    return std::find(this->ArrayNames.begin(), this->ArrayNames.end(), name) !=
      this->ArrayNames.end();
  }

  /// Reads the blocks that this rank takes, without ghost cells.
  /// @param step  index into Times(); 0 without times
  /// @param names  arrays to read
  /// @return blocks of this rank; their order and number depend on the number of ranks
  /// @throws InputError  if a file cannot be read; the message contains the file and the place
  /// @pre Collective
  virtual std::vector<InputBlock> Read(
    std::size_t step, const std::vector<std::string>& names, Ranks& ranks) const = 0;

protected:
  std::vector<double> StepTimes;
  std::vector<std::string> ArrayNames;
};

constexpr const char* SpyPlotSuffix = ".spcth";

/// Tests whether a path is a SpyPlot file (suffix .spcth), the folder of an AMReX plotfile or an
/// Exodus file.
bool IsBlockFile(const std::string& path);

/// Opens a file or folder. Each rank checks the structure of the files that it will read.
/// @throws InputError  if a file cannot be read, is damaged or has another format
/// @pre Collective
std::unique_ptr<BlockFile> OpenBlockFile(const std::string& path, Ranks& ranks);

/// Opens a case of the shock code CTH: one binary file (SpyPlotFile), or a text that lists several.
/// @throws InputError  same conditions as OpenBlockFile
std::unique_ptr<BlockFile> OpenSpyPlot(const std::string& path, const Ranks& ranks);

/// Opens a plotfile of a code based on AMReX (BoxLib).
///
/// A plotfile is a folder. Its text file Header lists the arrays, the levels with their ratios and
/// cell sizes, and the boxes of each level. Level_0/Cell_H and so on list the cells of each box and
/// its place in a binary file of the same folder. That file holds a line of text per box, then its
/// values, one array after another, x fastest. Particles are ignored.
/// @throws InputError  same conditions as OpenBlockFile
std::unique_ptr<BlockFile> OpenPlotfile(const std::string& folder);

/// Tests whether a path is a folder that contains a file Header.
bool IsPlotfile(const std::string& path);

/// Returns the suffixes of Exodus files, for instance ".e".
std::vector<std::string> GetExodusSuffixes();
/// Tests whether a path has one of these suffixes, or is FILE.N.RANK with any FILE, a part of a
/// decomposed file (N may be 1), and is no folder.
bool IsExodusFile(const std::string& path);

} // namespace vfm
