/**
 * SpyPlotFile: a binary file of the shock code CTH (SpyPlot), versions 101 to 105.
 *
 * After a header and two tables of arrays, group headers list the times, a hundred each. Every time has
 * its variables with their positions, tracers, a histogram, the blocks of cells, and the node
 * coordinates of these. A variable is a plane of cells after the other along z, a block after the other.
 * Coordinates, planes and tracers are run-length coded (SpyPlotStream). Every block has a layer of ghost
 * cells.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/IndexBox.h"
#include "Blocks/SpyPlotStream.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vfm
{

struct SpyPlotBlock
{
  int Number = 0; ///< in the file
  Index3 Size{};  ///< cells along each axis, with the layers of ghost cells
  std::array<std::vector<float>, 3> Nodes; ///< (Size + 1)
};

class SpyPlotFile
{
public:
  /// Checks all but the values in cells. Throws InputError: where and what is wrong.
  explicit SpyPlotFile(const std::string& path);

  const std::string& Path() const { return this->FilePath; }
  /// Whether it has a single block, whose nodes may be anywhere; those of more blocks are evenly spaced.
  bool IsFlat() const { return this->NumberOfBlocks == 1; }
  std::vector<double> Times() const;
  /// Names of the arrays, the same at every time.
  std::vector<std::string> Names() const;

  /// Returns the blocks of a step that hold cells.
  std::vector<SpyPlotBlock> ReadBlocks(std::size_t step) const;
  /// Returns the values of an array in the cells of the blocks first .. last, without last, of those
  /// that hold cells; x fastest, without ghost cells. Throws InputError.
  std::vector<Buffer<float>> ReadArray(std::size_t step, const std::string& name,
    const std::vector<SpyPlotBlock>& blocks, std::size_t first, std::size_t last) const;

private:
  struct Field // of cells, or of each material
  {
    std::string Name;
    int Number;
  };
  struct Variable
  {
    std::string Name;
    std::int64_t Position;
  };
  struct Dump
  {
    double Time = 0.0;
    std::int64_t Position = 0, Blocks = 0; // where it begins, and its list of blocks
    std::vector<Variable> Variables;
  };

  void ReadHeader(SpyPlotStream& file);
  std::vector<Field> ReadTable(SpyPlotStream& file) const;
  void ReadGroups(SpyPlotStream& file);
  void ReadDump(SpyPlotStream& file, Dump& dump);
  std::string FindName(const SpyPlotStream& file, int variable) const;
  std::vector<SpyPlotBlock> ReadBlocks(SpyPlotStream& file) const;

  std::string FilePath;
  int Version = 0, NumberOfBlocks = 0;
  std::vector<Field> CellFields, MaterialFields;
  std::vector<Dump> Dumps;
};

} // namespace vfm
