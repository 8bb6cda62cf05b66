#include "Blocks/SpyPlotFile.h"

#include "Ranks/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfm
{
namespace
{

constexpr int OldestVersion = 101, NewestVersion = 105;
constexpr int GroupSize = 100; // capacity of a group header, times
constexpr int LargestLevel = 100, SmallestBlock = 3;

std::string PlaceOfStep(std::size_t step)
{
  return "step " + std::to_string(step);
}

void SkipTracers(SpyPlotStream& file)
{
  const int count = file.Int();
  for (int chunk = 0; count > 0 && chunk < 7; ++chunk) // coordinates, block, cell in the block
  {
    file.Values(count);
  }
}

void SkipHistogram(SpyPlotStream& file)
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

/// Returns the values of a block without its ghost cells.
/// @param size  number of cells along each axis, ghost cells included
Buffer<float> ReadPlanes(SpyPlotStream& file, const Index3& size)
{
  Buffer<float> values((size[0] - 2) * (size[1] - 2) * (size[2] - 2));
  float* to = values.begin();
  const std::string place = file.Place;
  for (Index k = 0; k < size[2]; ++k)
  {
    file.Place = place + std::to_string(k);
    const std::vector<float> plane = file.Values(size[0] * size[1]);
    for (Index j = 1; k > 0 && k + 1 < size[2] && j + 1 < size[1]; ++j)
    {
      to = std::copy_n(plane.data() + j * size[0] + 1, size[0] - 2, to);
    }
  }
  return values;
}

} // namespace

SpyPlotFile::SpyPlotFile(const std::string& path) : FilePath(path)
{
  SpyPlotStream file(path);
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

void SpyPlotFile::ReadHeader(SpyPlotStream& file)
{
  const auto reject = [this](const std::string& text) { throw InputError(this->FilePath + text); };
  if (file.Text(8) != "spydata")
  {
    reject(" is not a SpyPlot file: it does not begin with spydata.");
  }
  file.Skip(128); // a description
  this->Version = file.Int();
  if (this->Version < OldestVersion || this->Version > NewestVersion)
  {
    reject(" is of version " + std::to_string(this->Version) + " of the format. Versions " +
      std::to_string(OldestVersion) + " to " + std::to_string(NewestVersion) + " are supported.");
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
    reject(
      " has " + std::to_string(dimensions) + " dimensions. Cells in three dimensions are needed.");
  }
  file.Skip(2 * 4 + 6 * 8); // materials, bounds
  this->NumberOfBlocks = file.Int();
  if (this->Version >= 105 && file.Int() != 0)
  {
    reject(" has markers of materials, which are not supported.");
  }
  file.Skip(4 + (this->Version >= 105 ? 5 * 4 : 0)); // levels, unused
}

std::vector<SpyPlotFile::Field> SpyPlotFile::ReadTable(SpyPlotStream& file) const
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

void SpyPlotFile::ReadGroups(SpyPlotStream& file)
{
  for (int count = GroupSize; count == GroupSize;)
  {
    file.Place = "the list of times";
    const std::int64_t here = file.GetPosition(), group = file.Offset();
    if (group <= here)
    {
      file.Fail("it points back");
    }
    file.Seek(group);
    count = file.Int();
    if (count < 0 || count > GroupSize)
    {
      file.Fail(std::to_string(count) + " times are listed, 0 to 100 are possible");
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

void SpyPlotFile::ReadDump(SpyPlotStream& file, Dump& dump)
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
  std::vector<std::string> first = this->Names();
  std::sort(first.begin(), first.end());
  if (names != first)
  {
    throw InputError(this->FilePath + " holds other arrays in " + file.Place + " than in step 0.");
  }
  SkipTracers(file);
  SkipHistogram(file);
  dump.Blocks = file.GetPosition();
  this->ReadBlocks(file);
}

/// Returns the name of an array; 'NAME - N' for the array NAME of material N.
std::string SpyPlotFile::FindName(const SpyPlotStream& file, int variable) const
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

std::vector<SpyPlotBlock> SpyPlotFile::ReadBlocks(SpyPlotStream& file) const
{
  const int count = file.Int();
  if (count != this->NumberOfBlocks)
  {
    file.Fail("it has " + std::to_string(count) + " blocks, the header " +
      std::to_string(this->NumberOfBlocks));
  }
  std::vector<SpyPlotBlock> blocks;
  for (int number = 0; number < count; ++number)
  {
    SpyPlotBlock block;
    block.Number = number;
    const auto& size = block.Size = { { file.Int(), file.Int(), file.Int() } };
    const bool isUsed = file.Int() != 0;
    file.Skip(4); // whether it is active
    const int level = file.Int();
    file.Skip(this->Version >= 103 ? 6 * 4 : 0); // bounds
    if (isUsed &&
      (*std::min_element(size.begin(), size.end()) < SmallestBlock || level < 0 ||
        level > LargestLevel ||
        1.0 * size[0] * size[1] * size[2] > std::numeric_limits<std::int32_t>::max()))
    {
      file.Fail("block " + std::to_string(number) + " has " + std::to_string(size[0]) + " x " +
        std::to_string(size[1]) + " x " + std::to_string(size[2]) + " cells on level " +
        std::to_string(level));
    }
    if (isUsed)
    {
      blocks.push_back(std::move(block));
    }
  }
  for (SpyPlotBlock& block : blocks)
  {
    for (int a = 0; a < 3; ++a)
    {
      block.Nodes[a] = file.Nodes(block.Size[a] + 1);
    }
  }
  return blocks;
}

std::vector<SpyPlotBlock> SpyPlotFile::ReadBlocks(std::size_t step) const
{
  SpyPlotStream file(this->FilePath);
  file.Place = PlaceOfStep(step);
  file.Seek(this->Dumps[step].Blocks);
  return this->ReadBlocks(file);
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

std::vector<std::string> SpyPlotFile::Names() const
{
  std::vector<std::string> names;
  for (const Variable& variable : this->Dumps[0].Variables)
  {
    names.push_back(variable.Name);
  }
  return names;
}

std::vector<Buffer<float>> SpyPlotFile::ReadArray(std::size_t step, const std::string& name,
  const std::vector<SpyPlotBlock>& blocks, std::size_t first, std::size_t last) const
{
  const std::vector<Variable>& variables = this->Dumps[step].Variables;
  const auto variable = std::find_if(
    variables.begin(), variables.end(), [&name](const Variable& own) { return own.Name == name; });
  SpyPlotStream file(this->FilePath);
  file.Seek(variable->Position);
  std::vector<Buffer<float>> arrays;
  for (std::size_t b = 0; b < last; ++b)
  {
    file.Place = "'" + name + "' of " + PlaceOfStep(step) + ", block " +
      std::to_string(blocks[b].Number) + ", plane ";
    if (b >= first)
    {
      arrays.push_back(ReadPlanes(file, blocks[b].Size));
      continue;
    }
    for (Index plane = 0; plane < blocks[b].Size[2]; ++plane)
    {
      file.SkipChunk();
    }
  }
  return arrays;
}

} // namespace vfm
