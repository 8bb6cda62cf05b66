/**
 * AmrexPlotfile: the structure of a plotfile of a code on AMReX (BoxLib), checked before VTK's reader gets it: that one trusts
 * all counts, and reads what is cut off as zeros.
 *
 * A plotfile is a folder. Its text file Header lists the arrays, the levels with their ratios and cell sizes, and the boxes of
 * each level; Level_0/Cell_H and so on give the boxes as cells, and for each its place in a binary file of the same folder:
 * a line of text, then the values, an array after the other, x fastest.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vfm
{

class PlotfileText;

class AmrexPlotfile
{
public:
  /// Checks Header and the lists of boxes. Throws InputError: where and what is wrong.
  explicit AmrexPlotfile(const std::string& folder);

  /// Of the arrays in cells, as the file has them.
  const std::vector<std::string>& Names() const { return this->ArrayNames; }
  int NumberOfBlocks() const { return static_cast<int>(this->Blocks.size()); }

  /// That the values of a block, counted from the first of level 0, are all there. Throws InputError.
  void CheckBlock(int number) const;

private:
  struct Block
  {
    std::string Path;
    std::int64_t Position = 0;
    IndexBox Box;
  };

  void ReadHeader();
  void ReadLevels(PlotfileText& file);
  void ReadBlocks(const std::string& prefix, int count);

  std::string Folder;
  std::vector<std::string> ArrayNames;
  int NumberOfLevels = 0;
  std::vector<Block> Blocks;
};

} // namespace vfm
