#include "Base/ParseText.h"
#include "Blocks/BlockFile.h"
#include "Blocks/PlotfileText.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "NamedFile.h"
#include "SwapBytes.h"

#include <limits>

namespace vfm
{
namespace
{

constexpr int LargestCount = 1 << 24; // largest number of arrays or blocks
constexpr int LargestLevel = 40;

/// Place and format of the values of a box. The arrays follow one another.
struct BoxValues
{
  std::int64_t Position = 0;
  int Width = 8; ///< bytes per value
  bool SwapBytes = false;
};

class Plotfile : public BlockFile
{
public:
  explicit Plotfile(const std::string& folder);

  std::vector<InputBlock> Read(
    std::size_t step, const std::vector<std::string>& names, Ranks& ranks) const override;

private:
  struct Block
  {
    std::string Path;
    std::int64_t Position = 0;
    IndexBox Box;
    int Level = 0;
  };

  void ReadHeader();
  void ReadSizes(PlotfileText& file);
  void ReadLevels(PlotfileText& file);
  void ReadBlocks(const std::string& path, int level, int count);
  BoxValues FindValues(PlotfileText& file, const Block& block) const;
  InputBlock ReadBlock(const Block& block, const std::vector<std::string>& names) const;

  std::string Folder;
  Vector3 Origin{};
  std::vector<Vector3> CellSizes; // one per level
  std::vector<Block> Blocks;      // in the order of the levels, level 0 first
};

/// Reads values and swaps their bytes if necessary.
template <class Value>
std::shared_ptr<const void> ReadValues(PlotfileText& file, Index count, bool swaps)
{
  const auto values = std::make_shared<Buffer<Value>>(count);
  file.Bytes(reinterpret_cast<char*>(values->data()), count * sizeof(Value));
  for (Value& value : *values)
  {
    value = swaps ? SwapBytes(value) : value;
  }
  return { values, values->data() };
}

} // namespace

Plotfile::Plotfile(const std::string& folder) : Folder(folder)
{
  this->ReadHeader();
}

void Plotfile::ReadHeader()
{
  PlotfileText file(this->Folder + "/Header");
  if (IsSameWord(file.Word("the name of the format").substr(0, 10), "checkpoint"))
  {
    throw InputError(this->Folder +
      " is a checkpoint of AMReX, not a plotfile. Let the simulation write a plotfile.");
  }
  const int arrays = static_cast<int>(file.Int(1, LargestCount, "a number of arrays"));
  for (int i = 0; i < arrays; ++i)
  {
    this->ArrayNames.push_back(file.Word("the names of " + std::to_string(arrays) + " arrays"));
  }
  if (file.Int(1, 3, "a number of dimensions") != 3)
  {
    throw InputError(
      this->Folder + " is not three-dimensional. Cells in three dimensions are needed.");
  }
  this->StepTimes = { file.Real("a time") };
  this->CellSizes.resize(1 + file.Int(0, LargestLevel, "the finest level"));
  this->ReadSizes(file);
  if (file.Int(0, 2, "the kind of coordinates") != 0)
  {
    throw InputError(this->Folder + " is not on Cartesian coordinates.");
  }
  file.Int(0, 0, "a 0 after the kind of coordinates");
  this->ReadLevels(file);
}

void Plotfile::ReadSizes(PlotfileText& file)
{
  for (int i = 0; i < 6; ++i)
  {
    const double corner = file.Real("the corners of the domain");
    this->Origin[i % 3] = i < 3 ? corner : this->Origin[i % 3];
  }
  for (std::size_t level = 1; level < this->CellSizes.size(); ++level)
  {
    file.Int(2, LargestCount, "the ratio of each level to the next");
  }
  for (std::size_t level = 0; level < this->CellSizes.size(); ++level)
  {
    file.Box("the cells of the domain on each level");
  }
  for (std::size_t level = 0; level < this->CellSizes.size(); ++level)
  {
    file.Int(0, std::numeric_limits<int>::max(), "the step of each level");
  }
  for (Vector3& size : this->CellSizes)
  {
    for (double& width : size)
    {
      width = file.Real("the sizes of cells");
      if (width <= 0.0)
      {
        file.Fail("sizes of cells above 0");
      }
    }
  }
}

void Plotfile::ReadLevels(PlotfileText& file)
{
  for (int level = 0; level < static_cast<int>(this->CellSizes.size()); ++level)
  {
    const std::string place = " of level " + std::to_string(level);
    file.Int(level, level, "the beginning" + place);
    const int count = static_cast<int>(file.Int(1, LargestCount, "the number of boxes" + place));
    file.Real("the time" + place);
    file.Int(0, std::numeric_limits<int>::max(), "the step" + place);
    for (int i = 0; i < 6 * count; ++i)
    {
      file.Real("the corners of all boxes" + place);
    }
    const std::string path = file.Word("the folder" + place);
    const std::size_t slash = path.find('/');
    if (slash == std::string::npos || path.find('/', slash + 1) != std::string::npos)
    {
      file.Fail("the folder and the name of the files" + place);
    }
    PrefixErrors(this->Folder + "/Header: ",
      [&] { this->ReadBlocks(FindNamedFile(this->Folder + "/Header", path), level, count); });
  }
}

/// Reads the list of the boxes of a level.
/// @param path  path of the level's files without their ends, for instance FOLDER/Level_0/Cell
void Plotfile::ReadBlocks(const std::string& path, int level, int count)
{
  PlotfileText file(path + "_H");
  file.Int(1, 1, "version 1 of its format");
  file.Int(0, 1, "its storage mode, 0 or 1");
  const std::int64_t arrays = static_cast<std::int64_t>(this->ArrayNames.size());
  file.Int(arrays, arrays, "as many arrays as Header, " + std::to_string(arrays));
  file.Int(0, 0, "no ghost cells");
  const std::string same = "as many boxes as Header, " + std::to_string(count);
  file.Signs("(", same);
  file.Int(count, count, same);
  file.Int(0, 0, same);
  std::vector<Block> blocks;
  for (int b = 0; b < count; ++b)
  {
    blocks.emplace_back();
    blocks.back().Box = file.Box(same);
    blocks.back().Level = level;
  }
  file.Signs(")", same);
  file.Int(count, count, same);
  for (Block& block : blocks)
  {
    if (file.Word("the files of all boxes") != "FabOnDisk:")
    {
      file.Fail("the files of all boxes");
    }
    const std::string name = file.Word("the files of all boxes");
    PrefixErrors(path + "_H: ", [&] { block.Path = FindNamedFile(path, name); });
    block.Position = file.Int(0, std::numeric_limits<std::int64_t>::max(), "positions in files");
  }
  this->Blocks.insert(this->Blocks.end(), blocks.begin(), blocks.end());
}

/// Reads and checks the text line in front of the values of a box.
BoxValues Plotfile::FindValues(PlotfileText& file, const Block& block) const
{
  const std::string place = " at byte " + std::to_string(block.Position);
  const std::int64_t size = GetFileLength(block.Path);
  if (block.Position >= size)
  {
    file.Fail("a box" + place);
  }
  file.Seek(block.Position);
  file.Signs("FAB((", "a box" + place);
  const std::string numbers = "numbers of 32 or 64 bits" + place;
  const std::int64_t words = file.Int(8, 8, numbers);
  file.Signs(",(", numbers);
  const std::int64_t bits = file.Int(32, 64, numbers);
  const std::int64_t formats[2][7] = { { 8, 23, 0, 1, 9, 0, 127 }, { 11, 52, 0, 1, 12, 0, 1023 } };
  for (std::int64_t i = 1; i < words; ++i)
  {
    const std::int64_t part = formats[bits / 64][i - 1]; // the format is IEEE 754
    file.Int(part, part, numbers);
  }
  file.Signs(")),(", numbers);
  const std::int64_t bytes = file.Int(4, 8, numbers);
  file.Signs(",(", numbers);
  const std::int64_t first = file.Int(1, bytes, numbers);
  for (std::int64_t i = 1; i < bytes; ++i)
  {
    const std::int64_t next = first == 1 ? 1 + i : bytes - i;
    file.Int(next, next, numbers);
  }
  file.Signs(")))", numbers);
  if (bits != 8 * bytes || (bytes != 4 && bytes != 8) || (first != 1 && first != bytes))
  {
    file.Fail(numbers);
  }
  const IndexBox box = file.Box("a box" + place);
  if (box.Lower != block.Box.Lower || box.Upper != block.Box.Upper)
  {
    file.Fail("the same box" + place + " as the list of its level");
  }
  const std::int64_t arrays = static_cast<std::int64_t>(this->ArrayNames.size());
  file.Int(arrays, arrays, std::to_string(arrays) + " arrays" + place);
  const std::int64_t begin = file.Position() + 1;
  const std::int64_t end = begin + CountCells({ { box.NumberOfCells(), arrays, bytes } });
  if (begin < 1 || end > size)
  {
    file.Fail("bytes up to " + std::to_string(end) + ", it has " + std::to_string(size));
  }
  return { begin, static_cast<int>(bytes), (first > 1) != IsLittleEndian() };
}

InputBlock Plotfile::ReadBlock(const Block& block, const std::vector<std::string>& names) const
{
  PlotfileText file(block.Path);
  const BoxValues values = this->FindValues(file, block);
  InputBlock read;
  for (int a = 0; a < 3; ++a)
  {
    const double width = this->CellSizes[block.Level][a];
    const double start = this->Origin[a] + static_cast<double>(block.Box.Lower[a]) * width;
    read.Coordinates[a] = EvenNodes(start, width, 0, static_cast<int>(block.Box.Size(a)));
  }
  const Index cells = block.Box.NumberOfCells();
  const auto arrays = std::make_shared<PlainArrays>(cells);
  for (const std::string& name : names)
  {
    const Index place =
      std::find(this->ArrayNames.begin(), this->ArrayNames.end(), name) - this->ArrayNames.begin();
    file.Seek(values.Position + place * cells * values.Width);
    const bool isFloat = values.Width == sizeof(float);
    arrays->Add(name, isFloat ? ValueType::Float : ValueType::Double, cells, 1,
      isFloat ? ReadValues<float>(file, cells, values.SwapBytes)
              : ReadValues<double>(file, cells, values.SwapBytes));
  }
  read.Arrays = arrays;
  return read;
}

std::vector<InputBlock> Plotfile::Read(
  std::size_t, const std::vector<std::string>& names, Ranks& ranks) const
{
  std::vector<InputBlock> blocks;
  for (std::size_t b = ranks.Rank(); b < this->Blocks.size(); b += ranks.Count())
  {
    blocks.push_back(this->ReadBlock(this->Blocks[b], names));
    FinishBlock(blocks.back(), static_cast<int>(blocks.size()) - 1, ranks);
  }
  return blocks;
}

std::unique_ptr<BlockFile> OpenPlotfile(const std::string& folder)
{
  return std::make_unique<Plotfile>(folder);
}

} // namespace vfm
