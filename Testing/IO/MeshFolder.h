/**
 * MeshFolder: a temporary folder for mesh files, and a mesh of three materials on several ranks.
 */
#pragma once

#include "RankMeshes.h"
#include "State/ViewMesh.h"
#include "Summary/MeshFields.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

namespace vfm
{
namespace testing
{

namespace fs = std::filesystem;

/// An empty folder, removed at the end.
class MeshFolder
{
public:
  MeshFolder() { fs::create_directory(this->Path); }
  ~MeshFolder() { fs::remove_all(this->Path); }
  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }
  std::size_t CountFiles() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Path), fs::directory_iterator()));
  }

private:
  const fs::path Path = fs::path(::testing::TempDir()) / ("vfm_files_" + std::to_string(getpid()));
};

using Work = std::function<void(const MeshData&, Ranks&)>;

/// Calls work on each rank with its part of a mesh of three materials.
inline void WithMesh(int count, MeshMaker make, const Work& work)
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

} // namespace testing
} // namespace vfm
