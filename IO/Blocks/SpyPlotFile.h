/**
 * SpyPlotFile: reads a binary file of the shock code CTH (SpyPlot), versions 101 to 105.
 *
 * The file begins with a header and two tables of arrays. Group headers list the times, up to 100
 * each. Each time has its variables with their positions, tracers, a histogram, the blocks of cells
 * and their node coordinates. A variable is stored block by block, and in a block plane by plane
 * along z. Coordinates, planes and tracers are run-length coded (SpyPlotStream). Each block has one
 * layer of ghost cells.
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

/// Block of cells that is in use at a step.
struct SpyPlotBlock
{
  int Number = 0; ///< number in the file, from 0
  Index3 Size{};  ///< number of cells along each axis, ghost cells included
  std::array<std::vector<float>, 3> Nodes; ///< node coordinates per axis, Size + 1 each
};

/// Structure of a SpyPlot file. It does not change after construction. Each function opens the file
/// again, so that threads may read at the same time.
class SpyPlotFile
{
public:
  /// Reads and checks the whole file, except the values in cells.
  /// @throws InputError  contains the path, the place in the file and the problem
  explicit SpyPlotFile(const std::string& path);

  const std::string& Path() const { return this->FilePath; }
  /// Returns whether the file has a single block, whose nodes may have any spacing. Several blocks
  /// are evenly spaced.
  bool IsFlat() const { return this->NumberOfBlocks == 1; }
  std::vector<double> Times() const;
  /// Returns the names of the arrays, which are equal at all times.
  std::vector<std::string> Names() const;

  /// Returns the blocks that are in use at a step.
  std::vector<SpyPlotBlock> ReadBlocks(std::size_t step) const;
  /// Reads the values of an array in some blocks of a step.
  /// @param blocks  result of ReadBlocks(step)
  /// @param first,last  range of indices into `blocks`, without `last`
  /// @return one array per block of the range, x fastest, without ghost cells
  /// @throws InputError  contains the path, the place in the file and the problem
  std::vector<Buffer<float>> ReadArray(std::size_t step, const std::string& name,
    const std::vector<SpyPlotBlock>& blocks, std::size_t first, std::size_t last) const;

private:
  struct Field // quantity of cells, or of each material in a cell
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
    std::int64_t Position = 0, Blocks = 0; // places of the step and of its list of blocks
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
