#include "SpyPlotFile.h"

#include "Base/Runtime.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace vfm
{

/// Reads a file from its begin on, never past its end, and tells where it is when something is wrong.
class ByteReader
{
public:
  explicit ByteReader(const std::string& path) : Path(path), Stream(path, std::ios::binary)
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!this->Stream || error)
    {
      throw InputError(
        path + " cannot be read: " + (error ? error.message() : std::strerror(errno)) + ".");
    }
    this->Size = static_cast<std::int64_t>(size);
  }

  [[noreturn]] void Fail(const std::string& problem) const
  {
    throw InputError(this->Path + " is cut or damaged in " + this->Place + " near byte " +
      std::to_string(this->Position) + ": " + problem + ".");
  }
  std::vector<unsigned char> Bytes(std::int64_t count)
  {
    this->Reserve(count);
    std::vector<unsigned char> bytes(static_cast<std::size_t>(count));
    if (!this->Stream.read(reinterpret_cast<char*>(bytes.data()), count))
    {
      this->Fail("it cannot be read");
    }
    this->Position += count;
    return bytes;
  }
  void Seek(std::int64_t position)
  {
    this->Position = position;
    this->Reserve(0);
    this->Stream.seekg(position);
  }
  void Skip(std::int64_t count)
  {
    this->Reserve(count);
    this->Position += count;
    this->Stream.ignore(count); // keeps what is buffered, as seeking does not
  }
  int Int() { return static_cast<std::int32_t>(this->Number(4)); }
  double Double()
  {
    const std::uint64_t bits = this->Number(8);
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  /// A position in the file.
  std::int64_t Offset()
  {
    const double value = this->Double();
    if (!(value >= 0.0 && value <= static_cast<double>(this->Size)))
    {
      std::ostringstream text;
      text << "it points to byte " << std::setprecision(15) << value << " of " << this->Size;
      this->Fail(text.str());
    }
    return static_cast<std::int64_t>(value);
  }
  /// Of that many bytes, up to the first that is 0.
  std::string Text(int size)
  {
    const std::vector<unsigned char> bytes = this->Bytes(size);
    return std::string(bytes.begin(), std::find(bytes.begin(), bytes.end(), 0));
  }
  /// A chunk, its length first, of so many bytes and run-length code of count values.
  void SkipRuns(std::int64_t before, std::int64_t count)
  {
    const std::vector<unsigned char> code = this->Bytes(this->Int());
    const std::int64_t size = static_cast<std::int64_t>(code.size());
    std::int64_t values = 0, next = before;
    while (values < count && next < size)
    {
      const int run = code[next];
      values += run < 128 ? run : run - 128;
      next += run < 128 ? 5 : 1 + 4 * (run - 128);
    }
    if (values != count || next > size)
    {
      this->Fail("a chunk of " + std::to_string(size) + " bytes does not hold " +
        std::to_string(count) + " values");
    }
  }

  std::int64_t Position = 0;
  std::string Path, Place = "the header";

private:
  void Reserve(std::int64_t count) const
  {
    if (count < 0 || count > this->Size - this->Position)
    {
      this->Fail(
        std::to_string(count) + " bytes are to follow, the file has " + std::to_string(this->Size));
    }
  }
  std::uint64_t Number(int size)
  {
    std::uint64_t value = 0;
    this->Reserve(size);
    for (int i = 0; i < size; ++i)
    {
      value = value << 8 | (this->Stream.get() & 0xff);
    }
    this->Position += size;
    return value;
  }

  std::ifstream Stream;
  std::int64_t Size = 0;
};

namespace
{

constexpr int OldestVersion = 101, NewestVersion = 105;
constexpr int GroupSize = 100; // times that a group header has room for
constexpr int LargestLevel = 100, SmallestBlock = 3;

std::string PlaceOfStep(std::size_t step)
{
  return "step " + std::to_string(step);
}

void SkipTracers(ByteReader& file)
{
  const int count = file.Int();
  for (int chunk = 0; count > 0 && chunk < 7; ++chunk) // coordinates, block and cell in it
  {
    file.SkipRuns(0, count);
  }
}

void SkipHistogram(ByteReader& file)
{
  const int count = file.Int();
  file.Skip(count > 0 ? 4 : 0);
  for (int i = 0; i < count; ++i)
  {
    file.Skip(4 + 6 * 8);
    if (file.Int() > 0) // bins
    {
      file.Skip(file.Int());
    }
  }
}

} // namespace

SpyPlotFile::SpyPlotFile(const std::string& path) : FilePath(path)
{
  ByteReader file(path);
  this->ReadHeader(file);
  file.Place = "the tables of arrays";
  this->CellFields = this->ReadTable(file);
  this->MaterialFields = this->ReadTable(file);
  this->ReadGroups(file);
  for (std::size_t step = 0; step < this->Dumps.size(); ++step)
  {
    file.Place = PlaceOfStep(step);
    this->ReadDump(file, this->Dumps[step]);
  }
}

void SpyPlotFile::ReadHeader(ByteReader& file)
{
  const auto refuse = [this](const std::string& text) { throw InputError(this->FilePath + text); };
  if (file.Text(8) != "spydata")
  {
    refuse(" is no SpyPlot file: it does not begin with spydata.");
  }
  file.Skip(128); // a description
  this->Version = file.Int();
  if (this->Version < OldestVersion || this->Version > NewestVersion)
  {
    refuse(" is of version " + std::to_string(this->Version) + " of the format. Versions " +
      std::to_string(OldestVersion) + " to " + std::to_string(NewestVersion) + " are read.");
  }
  const int bits = this->Version >= 102 ? file.Int() : 64;
  if (bits != 32 && bits != 64)
  {
    file.Fail("file positions have " + std::to_string(bits) + " bits");
  }
  file.Skip(4 * 4); // compression, number of this file and of all, geometry
  const int dimensions = file.Int();
  if (dimensions != 3)
  {
    refuse(
      " has " + std::to_string(dimensions) + " dimensions. Cells in three dimensions are needed.");
  }
  file.Skip(2 * 4 + 6 * 8); // materials, bounds
  this->NumberOfBlocks = file.Int();
  if (this->Version >= 105 && file.Int() != 0)
  {
    refuse(" has markers of materials, which are not supported.");
  }
  file.Skip(4 + (this->Version >= 105 ? 5 * 4 : 0)); // levels, unused
}

std::vector<SpyPlotFile::Field> SpyPlotFile::ReadTable(ByteReader& file) const
{
  std::vector<Field> fields;
  const int count = file.Int();
  for (int i = 0; i < count; ++i)
  {
    file.Skip(30); // a short name
    const std::string name = file.Text(80);
    if (name.size() == 80)
    {
      file.Fail("the name of an array does not end");
    }
    fields.push_back({ name, file.Int() });
  }
  return fields;
}

void SpyPlotFile::ReadGroups(ByteReader& file)
{
  for (int count = GroupSize; count == GroupSize;)
  {
    file.Place = "the list of times";
    const std::int64_t here = file.Position, group = file.Offset();
    if (group <= here)
    {
      file.Fail("it points back");
    }
    file.Seek(group);
    count = file.Int();
    if (count < 0 || count > GroupSize)
    {
      file.Fail(std::to_string(count) + " times are no number of times");
    }
    file.Skip(4 * GroupSize); // cycles
    std::vector<Dump> dumps(GroupSize);
    for (Dump& dump : dumps)
    {
      dump.Time = file.Double();
    }
    file.Skip(this->Version >= 102 ? 8 * GroupSize : 0); // time steps
    for (int i = 0; i < GroupSize; ++i)
    {
      dumps[i].Position = i < count ? file.Offset() : (file.Skip(8), 0);
      if (i < count && !std::isfinite(dumps[i].Time))
      {
        file.Fail("a time is not finite");
      }
    }
    this->Dumps.insert(this->Dumps.end(), dumps.begin(), dumps.begin() + count);
  }
  if (this->Dumps.empty())
  {
    throw InputError(this->FilePath + " holds no times.");
  }
}

void SpyPlotFile::ReadDump(ByteReader& file, Dump& dump)
{
  file.Seek(dump.Position);
  const int count = file.Int();
  if (count <= 0)
  {
    file.Fail("it has " + std::to_string(count) + " arrays");
  }
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i)
  {
    names.push_back(this->FindName(file, file.Int()));
    dump.Variables.push_back({ names.back(), 0 });
  }
  for (Variable& variable : dump.Variables)
  {
    variable.Position = file.Offset();
  }
  std::sort(names.begin(), names.end());
  if (&dump != this->Dumps.data() && names != this->ArrayNames)
  {
    throw InputError(this->FilePath + " holds other arrays in " + file.Place + " than in step 0.");
  }
  this->ArrayNames = std::move(names);
  SkipTracers(file);
  SkipHistogram(file);
  dump.Blocks = file.Position;
  for (const Block& block : this->ReadBlocks(file))
  {
    for (int size : block.Size)
    {
      file.SkipRuns(8, size + 1); // after the first node and a step
    }
  }
}

/// 'NAME - N' for field NAME of material N.
std::string SpyPlotFile::FindName(const ByteReader& file, int variable) const
{
  const bool isOfCells = variable < static_cast<int>(this->CellFields.size());
  const std::vector<Field>& fields = isOfCells ? this->CellFields : this->MaterialFields;
  const int material = isOfCells ? 0 : variable % 100;
  const auto found = std::find_if(fields.begin(), fields.end(),
    [&](const Field& field) { return field.Number == variable - material; });
  if (found == fields.end() || (!isOfCells && material == 0))
  {
    file.Fail("there is no array " + std::to_string(variable));
  }
  return found->Name + (isOfCells ? "" : " - " + std::to_string(material));
}

/// Those that hold cells.
std::vector<SpyPlotFile::Block> SpyPlotFile::ReadBlocks(ByteReader& file) const
{
  const int count = file.Int();
  if (count != this->NumberOfBlocks)
  {
    file.Fail("it has " + std::to_string(count) + " blocks, the header " +
      std::to_string(this->NumberOfBlocks));
  }
  std::vector<Block> blocks;
  for (int number = 0; number < count; ++number)
  {
    Block block{ number, { file.Int(), file.Int(), file.Int() } };
    const bool isUsed = file.Int() != 0;
    file.Skip(4); // whether it is active
    const int level = file.Int();
    file.Skip(this->Version >= 103 ? 6 * 4 : 0); // bounds
    const int* size = block.Size;
    if (isUsed &&
      (*std::min_element(size, size + 3) < SmallestBlock || level < 0 || level > LargestLevel ||
        1.0 * size[0] * size[1] * size[2] > std::numeric_limits<std::int32_t>::max()))
    {
      file.Fail("block " + std::to_string(number) + " has " + std::to_string(size[0]) + " x " +
        std::to_string(size[1]) + " x " + std::to_string(size[2]) + " cells on level " +
        std::to_string(level));
    }
    if (isUsed)
    {
      blocks.push_back(block);
    }
  }
  return blocks;
}

std::vector<double> SpyPlotFile::Times() const
{
  std::vector<double> times;
  for (const Dump& dump : this->Dumps)
  {
    times.push_back(dump.Time);
  }
  return times;
}

void SpyPlotFile::CheckArrays(
  double time, const std::function<bool(const std::string&)>& isWanted) const
{
  const auto dump = std::min_element(this->Dumps.begin(), this->Dumps.end(),
    [time](const Dump& a, const Dump& b)
    { return std::abs(a.Time - time) < std::abs(b.Time - time); });
  const std::string step = PlaceOfStep(dump - this->Dumps.begin());
  ByteReader file(this->FilePath);
  file.Place = step;
  file.Seek(dump->Blocks);
  const std::vector<Block> blocks = this->ReadBlocks(file);
  for (const Variable& variable : dump->Variables)
  {
    if (!isWanted(variable.Name))
    {
      continue;
    }
    file.Seek(variable.Position);
    for (const Block& block : blocks)
    {
      for (int plane = 0; plane < block.Size[2]; ++plane)
      {
        file.Place = "'" + variable.Name + "' of " + step + ", block " +
          std::to_string(block.Number) + ", plane " + std::to_string(plane);
        file.SkipRuns(0, static_cast<std::int64_t>(block.Size[0]) * block.Size[1]);
      }
    }
  }
}

} // namespace vfm
