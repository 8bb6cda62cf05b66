/// Mesh files are the same from any number of ranks; no file remains after a failed write.
#include "Meshes/WriteMesh.h"
#include "RankMeshes.h"
#include "State/ViewMesh.h"
#include "Summary/MeshFields.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace vfm;
using namespace vfm::testing;

namespace
{

namespace fs = std::filesystem;

/// An empty folder, removed at the end.
class Folder
{
public:
  Folder() { fs::create_directory(this->Path); }
  ~Folder() { fs::remove_all(this->Path); }
  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }
  std::size_t CountFiles() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Path), fs::directory_iterator()));
  }

private:
  const fs::path Path = fs::path(::testing::TempDir()) / ("vfm_files_" + std::to_string(getpid()));
};

/// Returns a file in which the date and time of the Exodus QA record are set to zeros.
std::string ReadWithoutDate(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  constexpr std::size_t recordLength = 33;
  const std::size_t record = bytes.rfind("VolumeFractionMesh");
  const std::size_t first = record + 2 * recordLength, last = record + 4 * recordLength;
  for (std::size_t i = first; path.find(".e") != std::string::npos && i < last; ++i)
  {
    bytes[i] = std::isdigit(static_cast<unsigned char>(bytes[i])) ? '0' : bytes[i];
  }
  return bytes;
}

using Work = std::function<void(const MeshData&, Ranks&)>;

/// Calls work on each rank with its part of a mesh of three materials.
void WithMesh(int count, MeshMaker make, const Work& work)
{
  const MeshCase whole = MakePolycrystalCase(3, 8);
  const std::vector<IndexBox> boxes = CutBox(whole.Grid.Global(), count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole.Grid, boxes[ranks.Rank()]);
      RankRuntime runtime(ranks);
      MeshReport report;
      const Mesh mesh =
        make(grid, CopyToLocal(whole.Grid, whole.Fractions, grid), {}, runtime, report);
      MeshData data = ViewMesh(mesh, OutputState(), ListDomain(whole.Grid, ImageFrame()));
      data.Fields.push_back(
        { "MaterialNames", std::vector<std::string>{ "one", "\"two\" & <more>", "three" } });
      data.Fields.push_back({ "MaterialIds", std::vector<int>{ 1, 2, 3 } });
      data.Time = 0.5;
      work(data, ranks);
    });
}

} // namespace

TEST(WriteMesh, FilesAreTheSameFromAnyNumberOfRanks)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    for (const char* name : { "mesh.vtu", "mesh.inp", "mesh.exo" })
    {
      const Folder folder;
      const std::string path = folder / name;
      std::vector<std::string> files;
      for (int count : { 1, 2, 3 })
      {
        WithMesh(count, make,
          [&](const MeshData& mesh, Ranks& ranks) {
            WriteMesh(mesh, path, ranks, { OutputFiles::Single, {} });
          });
        files.push_back(ReadWithoutDate(path));
      }
      EXPECT_GT(files[0].size(), 10000u);
      EXPECT_EQ(files[0], files[1]) << name;
      EXPECT_EQ(files[0], files[2]) << name;
    }
  }
}

TEST(WriteMesh, EachRankWritesAPart)
{
  const Folder folder;
  WithMesh(3, MakeHexMesh,
    [&](const MeshData& mesh, Ranks& ranks)
    {
      WriteMesh(mesh, folder / "mesh.e", ranks);
      WriteMesh(mesh, folder / "mesh.pvtu", ranks);
    });
  for (const char* name : { "mesh.e.3.0", "mesh.e.3.1", "mesh.e.3.2", "mesh.pvtu",
         "mesh/mesh_0.vtu", "mesh/mesh_1.vtu", "mesh/mesh_2.vtu" })
  {
    EXPECT_TRUE(fs::is_regular_file(folder / name)) << name;
  }
}

TEST(WriteMesh, FilesThatCannotBeWrittenAreNotLeft)
{
  const Folder folder;
  fs::create_symlink("/dev/full", folder / "full.exo.2.1");
  fs::create_symlink("/dev/full", folder / "full.vtu");
  for (const auto& [name, reason] : std::vector<std::pair<std::string, std::string>>{
         { "mesh.stl", "unknown format" }, { "no/mesh.vtu", "No such file or directory" },
         { "no/mesh.inp", "No such file or directory" }, { "full.vtu", "No space left on device" },
         { "full.exo", "full.exo.2.1: No space left on device" } })
  {
    WithMesh(2, MakeHexMesh,
      [&, name = name, reason = reason](const MeshData& mesh, Ranks& ranks)
      {
        try
        {
          WriteMesh(mesh, folder / name, ranks);
          ADD_FAILURE() << name;
        }
        catch (const InputError& error)
        {
          EXPECT_NE(std::string(error.what()).find(folder / name), std::string::npos)
            << error.what();
          EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
      });
  }
  EXPECT_EQ(folder.CountFiles(), 2u);
}
