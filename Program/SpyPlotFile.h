/**
 * SpyPlotFile: the structure of a binary file of the shock code CTH (SpyPlot), versions 101 to 105, checked before ParaView's
 * reader gets the file: that one trusts all counts and positions and crashes on a file that is cut.
 *
 * Numbers are big endian, file positions are doubles. After a header and two tables of arrays, group headers list the times, a
 * hundred each; every time has its variables with their positions, tracers, a histogram, the blocks of cells, and the node
 * coordinates of these. A variable is a plane of cells after the other along z, a block after the other. Coordinates, planes
 * and tracers are run-length coded: a byte n < 128 and a value that counts n times, or 128 + n and n values, of 4 bytes.
 */
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vfm
{

class ByteReader;

class SpyPlotFile
{
public:
  /// Checks all but the values in cells. Throws InputError: where and what is wrong.
  explicit SpyPlotFile(const std::string& path);

  const std::string& Path() const { return this->FilePath; }
  /// Whether it has one block alone: then ParaView's reader takes all files for those of a flat mesh.
  bool IsFlat() const { return this->NumberOfBlocks == 1; }
  std::vector<double> Times() const;
  /// Names of the arrays that every time holds, in alphabetical order.
  const std::vector<std::string>& Names() const { return this->ArrayNames; }

  /// Checks the values in cells of the arrays that are wanted, at the time that is nearest. Throws InputError.
  void CheckArrays(double time, const std::function<bool(const std::string&)>& isWanted) const;

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
  struct Block
  {
    int Number, Size[3]; // cells with ghost cells
  };

  void ReadHeader(ByteReader& file);
  std::vector<Field> ReadTable(ByteReader& file) const;
  void ReadGroups(ByteReader& file);
  void ReadDump(ByteReader& file, Dump& dump);
  std::string FindName(const ByteReader& file, int variable) const;
  std::vector<Block> ReadBlocks(ByteReader& file) const;

  std::string FilePath;
  int Version = 0, NumberOfBlocks = 0;
  std::vector<Field> CellFields, MaterialFields;
  std::vector<Dump> Dumps;
  std::vector<std::string> ArrayNames;
};

} // namespace vfm
