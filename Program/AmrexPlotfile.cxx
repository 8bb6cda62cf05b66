#include "AmrexPlotfile.h"

#include "OpenFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

namespace vfm
{

/// Words and numbers of a text file; what is none of those that are expected is an error that names the place.
class PlotfileText
{
public:
  explicit PlotfileText(const std::string& path) : Path(path)
  {
    try
    {
      this->Stream = OpenFile(path);
    }
    catch (const InputError& error)
    {
      throw InputError(path + " cannot be read: " + error.what());
    }
  }

  [[noreturn]] void Fail(const std::string& expected)
  {
    throw InputError(
      this->Path + " is cut, damaged or of another format: it should have " + expected + ".");
  }
  std::string Word(const std::string& what)
  {
    std::string word;
    const auto isControl = [](unsigned char c) { return std::iscntrl(c) != 0; };
    if (!(this->Stream >> word) || std::any_of(word.begin(), word.end(), isControl))
    {
      this->Fail(what);
    }
    return word;
  }
  std::int64_t Int(std::int64_t least, std::int64_t most, const std::string& what)
  {
    std::int64_t value = 0;
    if (!(this->Stream >> value) || value < least || value > most)
    {
      this->Fail(what);
    }
    return value;
  }
  double Real(const std::string& what)
  {
    double value = 0.0;
    if (!(this->Stream >> value) || !std::isfinite(value))
    {
      this->Fail(what);
    }
    return value;
  }
  void Signs(const char* signs, const std::string& what)
  {
    for (char sign = 0; *signs; ++signs)
    {
      if (!(this->Stream >> sign) || sign != *signs)
      {
        this->Fail(what);
      }
    }
  }
  /// ((i,j,k) (i,j,k) (0,0,0)): first and last cell.
  IndexBox Box(const std::string& what)
  {
    IndexBox box;
    this->Signs("(", what);
    this->Cell(box.Lower, what);
    this->Cell(box.Upper, what);
    Index3 type;
    this->Cell(type, what);
    this->Signs(")", what);
    for (int a = 0; a < 3; ++a)
    {
      ++box.Upper[a];
      if (box.Upper[a] <= box.Lower[a] || type[a] != 0)
      {
        this->Fail(what);
      }
    }
    return box;
  }
  void Seek(std::int64_t position) { this->Stream.seekg(position); }
  std::int64_t Position() { return this->Stream.tellg(); }

private:
  void Cell(Index3& cell, const std::string& what)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Signs(a == 0 ? "(" : ",", what);
      cell[a] = this->Int(-LargestIndex, LargestIndex, what);
    }
    this->Signs(")", what);
  }

  static constexpr std::int64_t LargestIndex = 1 << 30;
  std::string Path;
  std::ifstream Stream;
};

namespace
{

constexpr int LargestCount = 1 << 24; // of arrays and blocks
constexpr int LargestLevel = 40;

} // namespace

AmrexPlotfile::AmrexPlotfile(const std::string& folder) : Folder(folder)
{
  this->ReadHeader();
}

void AmrexPlotfile::ReadHeader()
{
  PlotfileText file(this->Folder + "/Header");
  file.Word("the name of the format");
  const int arrays = static_cast<int>(file.Int(1, LargestCount, "a number of arrays"));
  for (int i = 0; i < arrays; ++i)
  {
    this->ArrayNames.push_back(file.Word("the names of " + std::to_string(arrays) + " arrays"));
  }
  if (file.Int(1, 3, "a number of dimensions") != 3)
  {
    throw InputError(
      this->Folder + " is not of three dimensions. Cells in three dimensions are needed.");
  }
  file.Real("a time");
  this->NumberOfLevels = 1 + static_cast<int>(file.Int(0, LargestLevel, "the finest level"));
  for (int i = 0; i < 6; ++i)
  {
    file.Real("the corners of the domain");
  }
  for (int level = 1; level < this->NumberOfLevels; ++level)
  {
    file.Int(2, LargestCount, "the ratio of each level to the next");
  }
  for (int level = 0; level < this->NumberOfLevels; ++level)
  {
    file.Box("the cells of the domain on each level");
  }
  for (int level = 0; level < this->NumberOfLevels; ++level)
  {
    file.Int(0, std::numeric_limits<int>::max(), "the step of each level");
  }
  for (int i = 0; i < 3 * this->NumberOfLevels; ++i)
  {
    if (file.Real("the sizes of cells") <= 0.0)
    {
      file.Fail("sizes of cells above 0");
    }
  }
  if (file.Int(0, 2, "the kind of coordinates") != 0)
  {
    throw InputError(this->Folder + " is not on Cartesian coordinates.");
  }
  file.Int(0, 0, "a 0 after the kind of coordinates");
  this->ReadLevels(file);
}

void AmrexPlotfile::ReadLevels(PlotfileText& file)
{
  for (int level = 0; level < this->NumberOfLevels; ++level)
  {
    const std::string place = " of level " + std::to_string(level);
    file.Int(level, level, "the begin" + place);
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
    this->ReadBlocks(path, count);
  }
}

/// prefix: such as Level_0/Cell.
void AmrexPlotfile::ReadBlocks(const std::string& prefix, int count)
{
  const std::string path = this->Folder + "/" + prefix;
  PlotfileText file(path + "_H");
  file.Int(1, 1, "version 1 of its format");
  file.Int(0, 1, "the way it was written");
  const std::int64_t arrays = static_cast<std::int64_t>(this->ArrayNames.size());
  file.Int(arrays, arrays, "as many arrays as Header, " + std::to_string(arrays));
  file.Int(0, 0, "no ghost cells");
  const std::string same = "as many boxes as Header, " + std::to_string(count);
  file.Signs("(", same);
  file.Int(count, count, same);
  file.Int(0, 0, same);
  std::vector<Block> blocks(count);
  for (Block& block : blocks)
  {
    block.Box = file.Box(same);
  }
  file.Signs(")", same);
  file.Int(count, count, same);
  for (Block& block : blocks)
  {
    if (file.Word("the files of all boxes") != "FabOnDisk:")
    {
      file.Fail("the files of all boxes");
    }
    block.Path = std::filesystem::path(path).parent_path().string() + "/" +
      file.Word("the files of all boxes");
    block.Position = file.Int(0, std::numeric_limits<std::int64_t>::max(), "positions in files");
  }
  this->Blocks.insert(this->Blocks.end(), blocks.begin(), blocks.end());
}

void AmrexPlotfile::CheckBlock(int number) const
{
  const Block& block = this->Blocks[number];
  PlotfileText file(block.Path);
  const std::string place = " at byte " + std::to_string(block.Position);
  const std::int64_t size = static_cast<std::int64_t>(std::filesystem::file_size(block.Path));
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
  for (std::int64_t i = 1; i < words; ++i)
  {
    file.Int(0, 1 << 20, numbers);
  }
  file.Signs(")),(", numbers);
  const std::int64_t bytes = file.Int(4, 8, numbers);
  file.Signs(",(", numbers);
  for (std::int64_t i = 0; i < bytes; ++i)
  {
    file.Int(1, bytes, numbers);
  }
  file.Signs(")))", numbers);
  if (bits != 8 * bytes || (bytes != 4 && bytes != 8))
  {
    file.Fail(numbers);
  }
  const IndexBox box = file.Box("a box" + place);
  if (box.Lower != block.Box.Lower || box.Upper != block.Box.Upper)
  {
    file.Fail("the box" + place + " that the list of its level has");
  }
  const std::int64_t arrays = static_cast<std::int64_t>(this->ArrayNames.size());
  file.Int(arrays, arrays, std::to_string(arrays) + " arrays" + place);
  const std::int64_t end = file.Position() + 1 + arrays * bytes * box.NumberOfCells();
  if (end > size)
  {
    file.Fail("bytes up to " + std::to_string(end) + ", it has " + std::to_string(size));
  }
}

} // namespace vfm
