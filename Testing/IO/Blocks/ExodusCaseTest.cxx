/// Exodus files of hexahedra, in the formats of netCDF that the writer makes.
#include "Blocks/ExodusCase.h"
#include "FileCases.h"
#include "Meshes/Exodus/WriteNetcdf.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

using namespace vfm;

namespace
{

constexpr int Cells = 3; // along each axis
const vfm::testing::Folder TestFolder;
const std::string Path = TestFolder / "case.e";

struct Contents
{
  /// Cells of each element block, x fastest.
  std::vector<std::vector<Index>> Blocks{ { 26, 0, 5 }, {} };
  std::string Type = "HEX8";
  bool HasTime = true;
  Index FirstNode = 1; // 1 in intact files

  Contents()
  {
    for (Index cell = 26; cell-- > 1;)
    {
      if (cell != 5)
      {
        this->Blocks[1].push_back(cell);
      }
    }
  }
};

template <class Values>
void Add(NetcdfLayout& layout, const std::string& name, NetcdfKind kind,
  const std::vector<std::size_t>& dimensions, const Values& values,
  const std::vector<NetcdfText>& attributes = {})
{
  layout.Variables.push_back(
    { name, kind, dimensions, [values] { return NetcdfValues(values); }, attributes });
}

void AddNodes(NetcdfLayout& layout)
{
  constexpr Index nodes = Cells + 1;
  const std::size_t count = layout.AddDimension("num_nodes", nodes * nodes * nodes);
  for (int a = 0; a < 3; ++a)
  {
    std::vector<double> x;
    for (Index n = 0; n < nodes * nodes * nodes; ++n)
    {
      const Index place[3] = { n % nodes, n / nodes % nodes, n / nodes / nodes };
      x.push_back(0.5 * static_cast<double>(place[a]));
    }
    Add(
      layout, std::string("coord") + "xyz" [a], NetcdfKind::Real, { count }, x);
  }
}

std::vector<Index> CornersOf(const std::vector<Index>& cells, Index first)
{
  constexpr Index nodes = Cells + 1;
  std::vector<Index> corners;
  for (const Index cell : cells)
  {
    const Index low =
      cell % Cells + nodes * (cell / Cells % Cells + nodes * (cell / Cells / Cells)) + first;
    for (const Index step : { 0, 1, 5, 4, 16, 17, 21, 20 })
    {
      corners.push_back(low + step);
    }
  }
  return corners;
}

/// Writes a file of a cube. The variable "a" of each cell is its number; only block 2 has "b".
void Write(const std::string& path, const Contents& contents, NetcdfFormat format)
{
  NetcdfLayout layout;
  const std::size_t time = contents.HasTime ? layout.AddDimension("time_step", 0) : 0;
  const std::size_t letters = layout.AddDimension("len_name", 4);
  const std::size_t two = layout.AddDimension("num_elem_var", 2);
  const std::size_t eight = layout.AddDimension("num_nod_per_el", 8);
  const std::size_t blocks =
    layout.AddDimension("num_el_blk", static_cast<Index>(contents.Blocks.size()));
  layout.AddDimension("num_dim", 3);
  AddNodes(layout);
  Add(layout, "eb_prop1", NetcdfKind::Int, { blocks },
    contents.Blocks.size() == 1 ? std::vector<Index>{ 10 } : std::vector<Index>{ 10, 20 });
  Add(layout, "name_elem_var", NetcdfKind::Text, { two, letters }, std::string("b\0\0\0a   ", 8));
  std::vector<std::size_t> counts;
  for (std::size_t b = 0; b < contents.Blocks.size(); ++b)
  {
    const std::string number = std::to_string(b + 1);
    const std::vector<Index>& cells = contents.Blocks[b];
    counts.push_back(
      layout.AddDimension("num_el_in_blk" + number, static_cast<Index>(cells.size())));
    Add(layout, "connect" + number, NetcdfKind::Int, { counts[b], eight },
      CornersOf(cells, contents.FirstNode), { { "elem_type", contents.Type } });
  }
  for (std::size_t b = 0; contents.HasTime && b < contents.Blocks.size(); ++b)
  {
    const std::string block = "eb" + std::to_string(b + 1);
    const std::vector<double> values(contents.Blocks[b].begin(), contents.Blocks[b].end());
    Add(layout, "vals_elem_var2" + block, NetcdfKind::Real, { time, counts[b] }, values);
    if (b == 1)
    {
      Add(layout, "vals_elem_var1" + block, NetcdfKind::Real, { time, counts[b] }, values);
    }
  }
  if (contents.HasTime)
  {
    Add(layout, "time_whole", NetcdfKind::Real, { time }, std::vector<double>{ 0.5 });
  }
  OutputSet files(path);
  WriteNetcdf(layout, path, format, files);
  files.Rename();
}

/// Returns the message of the error of reading, or an empty text.
std::string Refusal(const std::string& path)
{
  try
  {
    Ranks alone;
    const auto file = OpenBlockFile(path, alone);
    file->Read(0, file->Names(), alone);
    return "";
  }
  catch (const InputError& error)
  {
    return error.what();
  }
}

class ExodusCaseTest : public ::testing::TestWithParam<NetcdfFormat>
{
};

TEST_P(ExodusCaseTest, ReadsCellsInAnyOrder)
{
  Write(Path, {}, GetParam());
  Ranks alone;
  const auto file = OpenBlockFile(Path, alone);
  EXPECT_EQ(file->Times(), std::vector<double>{ 0.5 });
  EXPECT_EQ(file->Names(), (std::vector<std::string>{ "a", "b" }));
  EXPECT_TRUE(file->Has("object_id"));
  EXPECT_FALSE(file->Has("c"));
  InputBlocks blocks =
    FindInputBlocks({ file->Read(0, { "a", "b", "object_id" }, alone), {} }, alone);
  EXPECT_EQ(blocks.Coordinates[2], (std::vector<double>{ 0.0, 0.5, 1.0, 1.5 }));
  std::map<Index, Index> ids;
  for (const InputBlock& block : blocks.Blocks)
  {
    const auto a = block.Arrays->Find("a"), id = block.Arrays->Find("object_id");
    EXPECT_EQ(block.Arrays->Find("b") == nullptr, block.Number == 0);
    ForCells(block.Box,
      [&](const Index3& cell)
      {
        const Index number = cell[0] + Cells * (cell[1] + Cells * cell[2]);
        EXPECT_EQ(a->Get(block.CellId(cell), 0), static_cast<double>(number));
        ids[number] = static_cast<Index>(id->Get(block.CellId(cell), 0));
      });
  }
  EXPECT_EQ(ids.size(), 27u);
  EXPECT_TRUE(ids[0] == 10 && ids[5] == 10 && ids[26] == 10 && ids[1] == 20);
}

TEST_P(ExodusCaseTest, TruncatedFilesAreRefused)
{
  Write(Path, {}, GetParam());
  std::string bytes;
  {
    std::ifstream stream(Path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(stream), {});
  }
  for (std::size_t size = 0; size < bytes.size(); size += 101)
  {
    std::ofstream(Path, std::ios::binary) << bytes.substr(0, size);
    EXPECT_NE(Refusal(Path), "") << size;
  }
}

TEST_P(ExodusCaseTest, OtherContentsAreRefused)
{
  Contents contents;
  contents.Type = "TETRA4";
  Write(Path, contents, GetParam());
  EXPECT_NE(Refusal(Path).find("Block 0: cell 0 is of the type 'TETRA4'"), std::string::npos);
  contents.Type = "SHELL4"; // elements of two dimensions are ignored
  Write(Path, contents, GetParam());
  EXPECT_NE(Refusal(Path).find("The input has no cells"), std::string::npos);
  contents = Contents();
  contents.FirstNode = 12;
  Write(Path, contents, GetParam());
  EXPECT_NE(Refusal(Path).find("does not have eight points of the mesh"), std::string::npos);
}

TEST_P(ExodusCaseTest, PartsHaveTheSameTimes)
{
  const std::string parts[] = { Path + ".2.0", Path + ".2.1" };
  Contents contents;
  const std::vector<std::vector<Index>> all = contents.Blocks;
  for (int p = 0; p < 2; ++p)
  {
    contents.Blocks = { all[p] };
    Write(parts[p], contents, GetParam());
  }
  EXPECT_EQ(Refusal(parts[1]), "");
  contents.HasTime = false;
  Write(parts[1], contents, GetParam());
  if (GetParam() == NetcdfFormat::Classic)
  {
    std::fstream(parts[1], std::ios::binary | std::ios::in | std::ios::out)
      .seekp(7)
      .put(0); // records
  }
  EXPECT_EQ(Refusal(parts[0]), parts[1] + ": it holds 0 times, but " + parts[0] + " holds 1.");
  std::filesystem::remove(parts[1]);
  EXPECT_EQ(Refusal(parts[0]), parts[1] + " (one of 2 files): No such file or directory.");
}

INSTANTIATE_TEST_SUITE_P(
  Formats, ExodusCaseTest, ::testing::Values(NetcdfFormat::Classic, NetcdfFormat::Wide));

} // namespace
