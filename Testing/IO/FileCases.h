/**
 * Folders and meshes on several ranks for tests of mesh files.
 */
#pragma once

#include "RankMeshes.h"
#include "Report/FragmentTargets.h"
#include "Report/MeshFields.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <unistd.h>

namespace vfm
{
namespace testing
{

/// An empty folder, removed at the end.
class Folder
{
public:
  Folder() { std::filesystem::create_directory(this->Path); }
  ~Folder() { std::filesystem::remove_all(this->Path); }
  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }
  std::size_t CountFiles() const
  {
    return static_cast<std::size_t>(std::distance(
      std::filesystem::directory_iterator(this->Path), std::filesystem::directory_iterator()));
  }

private:
  inline static int Count = 0;
  const std::filesystem::path Path = std::filesystem::path(::testing::TempDir()) /
    ("vfm_files_" + std::to_string(getpid()) + "_" + std::to_string(Count++));
};

inline std::string ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/// Two unit cubes of materials 1 and 2 along x. The second one ends inside of the domain, at
/// x = 2.
struct TwoCubes
{
  explicit TwoCubes(Index firstId = 1)
  {
    for (Index z = 0; z < 2; ++z)
    {
      for (Index y = 0; y < 2; ++y)
      {
        for (Index x = 0; x < 3; ++x)
        {
          this->Points.insert(this->Points.end(), { 1.0 * x, 1.0 * y, 1.0 * z });
          this->PointIds.push_back(firstId + 10 * static_cast<Index>(this->PointIds.size()));
        }
      }
    }
    for (Index x = 0; x < 2; ++x)
    {
      for (Index corner : { 0, 1, 4, 3, 6, 7, 10, 9 })
      {
        this->Elements.push_back(corner + x);
      }
    }
    MeshData& data = this->Data;
    data.NumberOfPoints = 12;
    data.NumberOfElements = 2;
    data.Points = this->Points.data();
    data.Elements = this->Elements.data();
    data.PointIds = this->PointIds.data();
    data.ElementIds = this->ElementIds.data();
    data.Material = this->Material.data();
    data.Fields = { { "DomainBounds", std::vector<double>{ 0, 3, 0, 1, 0, 1 }, 6 },
      { "MaterialNames", std::vector<std::string>{ "a \"b\"", "c" } },
      { "MaterialIds", std::vector<int>{ 1, 2 } } };
  }

  std::vector<double> Points;
  std::vector<Index> Elements, PointIds, ElementIds{ 5, 8 };
  std::vector<int> Material{ 1, 2 };
  MeshData Data;
};

/// A mesh of one rank with the tables of the mesher.
struct FileCase
{
  MeshData Mesh;
  FieldArrays Materials; ///< as MesherResult::MaterialFields
  MeshReport Report;
};

/// Changes a mesh and its fields; collective.
using MeshChange = std::function<void(Mesh&, FieldArrays&, Ranks&)>;

/// Calls work on each rank with its part of a mesh of three materials, one of which has a name that
/// XML and HTML must escape.
template <class Work>
void WithMesh(int count, MeshMaker make, const Work& work, const MeshOptions& options = {},
  const MeshChange& change = {})
{
  const MeshCase whole = MakePolycrystalCase(3, 8);
  const std::vector<IndexBox> boxes = CutBox(whole.Grid.Global(), count);
  const Materials table{ { "Void", "one", "\"two\" & <more>", "three" }, { 0, 1, 2, 3 } };
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole.Grid, boxes[ranks.Rank()]);
      RankRuntime runtime(ranks);
      FileCase part;
      Mesh mesh =
        make(grid, CopyToLocal(whole.Grid, whole.Fractions, grid), options, runtime, part.Report);
      FieldArrays fields = ListReport(mesh, part.Report, table, options, {},
        ListFragmentTargets(
          part.Report.Fragments, TableMode::On, part.Report.NumberOfFragments, ranks));
      for (FieldArray& field : ListDomain(whole.Grid, ImageFrame()))
      {
        fields.push_back(std::move(field));
      }
      if (change)
      {
        change(mesh, fields, ranks);
      }
      part.Mesh = ViewMesh(mesh, OutputState(), fields);
      part.Mesh.Time = 0.5;
      part.Materials = ListMaterials(part.Report, table, options);
      work(part, ranks);
    });
}

} // namespace testing
} // namespace vfm
