/// Surfaces of materials in files of STL: closed, oriented, with the volumes of the meshes, the
/// same bytes from any number of ranks.
#include "Meshes/Surfaces/WriteStl.h"
#include "FileCases.h"
#include "Meshes/WriteMesh.h"

#include <cmath>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Solid
{
  std::string Name;
  std::vector<Vector3> Normals, Corners; ///< normals per triangle, three corners each
};

std::vector<Solid> ReadStl(const std::string& path)
{
  std::vector<Solid> solids;
  std::istringstream text(ReadBytes(path));
  for (std::string line; std::getline(text, line);)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    Vector3 numbers{};
    if (word == "solid")
    {
      solids.push_back({ line.substr(6), {}, {} });
    }
    else if (word == "vertex" && words >> numbers[0] >> numbers[1] >> numbers[2])
    {
      solids.back().Corners.push_back(numbers);
    }
    else if (word == "facet" && words >> word >> numbers[0] >> numbers[1] >> numbers[2])
    {
      solids.back().Normals.push_back(numbers);
    }
    else if (word == "endsolid")
    {
      EXPECT_EQ(line.substr(9), solids.back().Name);
    }
  }
  return solids;
}

/// Returns the volume of a closed surface by the divergence theorem.
double VolumeOf(const Solid& solid)
{
  double volume = 0.0;
  for (std::size_t c = 0; c < solid.Corners.size(); c += 3)
  {
    volume += Dot(solid.Corners[c], Cross(solid.Corners[c + 1], solid.Corners[c + 2])) / 6.0;
  }
  return volume;
}

/// Returns how many edges of triangles have no opposite edge, and how many occur more than once.
Index CountOpenEdges(const Solid& solid)
{
  std::map<std::array<Vector3, 2>, int> edges;
  for (std::size_t c = 0; c < solid.Corners.size(); ++c)
  {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    ++edges[{ solid.Corners[c], solid.Corners[next] }];
  }
  return std::count_if(edges.begin(), edges.end(),
    [&edges](const auto& edge) {
      return edge.second != 1 || edges.count({ edge.first[1], edge.first[0] }) != 1;
    });
}

double LargestNormalError(const Solid& solid)
{
  double largest = 0.0;
  for (std::size_t t = 0; t < solid.Normals.size(); ++t)
  {
    const Vector3* corners = &solid.Corners[3 * t];
    const Vector3 normal = Unit(Cross(corners[1] - corners[0], corners[2] - corners[0]));
    largest = std::max(largest, Norm(normal - solid.Normals[t]));
  }
  return largest;
}

/// Expects a closed surface for each material, with its volume in the mesh.
void CheckSolids(const std::vector<Solid>& solids, const FieldArrays& materials)
{
  const std::vector<double> volumes = NumbersOfField(materials, "MeshVolume");
  ASSERT_EQ(solids.size(), volumes.size());
  for (std::size_t s = 0; s < solids.size(); ++s)
  {
    EXPECT_EQ(CountOpenEdges(solids[s]), 0) << solids[s].Name;
    EXPECT_LT(LargestNormalError(solids[s]), 2e-6) << solids[s].Name;
    const double error = VolumeOf(solids[s]) / volumes[s] - 1.0;
    EXPECT_LT(std::abs(error), 1e-12) << solids[s].Name;
    std::cout << solids[s].Name << ": " << solids[s].Normals.size() << " triangles, volume "
              << VolumeOf(solids[s]) << ", relative difference " << error << "\n";
  }
}

} // namespace

TEST(WriteStl, TwoCubes)
{
  const Folder folder;
  Ranks alone;
  WriteMesh(TwoCubes().Data, folder / "cubes.stl", alone);
  const std::vector<Solid> solids = ReadStl(folder / "cubes.stl");
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[0].Name, "a _b_");
  EXPECT_EQ(solids[1].Name, "c");
  for (const Solid& solid : solids)
  {
    EXPECT_EQ(solid.Normals.size(), 24u);
    EXPECT_EQ(CountOpenEdges(solid), 0);
    EXPECT_DOUBLE_EQ(VolumeOf(solid), 1.0);
  }
  EXPECT_EQ(ReadBytes(folder / "cubes.stl").substr(0, 116),
    "solid a _b_\nfacet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 0.5 0.5\n"
    "endloop\nendfacet\nfacet normal ");
}

/// The names of materials in the names of files: separators of folders and repetitions.
TEST(WriteStl, OneFilePerMaterial)
{
  const Folder folder;
  Ranks alone;
  for (const char* name : { "a/b", "../c", "" })
  {
    TwoCubes cubes;
    cubes.Data.Fields[1] = { "MaterialNames", std::vector<std::string>{ name, name } };
    WriteMesh(cubes.Data, folder / "of_{}.stl", alone);
  }
  EXPECT_EQ(folder.CountFiles(), 6u);
  for (const char* name : { "a_b", "a_b_2", ".._c", ".._c_2", "", "_2" })
  {
    const std::vector<Solid> solids = ReadStl(folder / (std::string("of_") + name + ".stl"));
    ASSERT_EQ(solids.size(), 1u) << name;
    EXPECT_EQ(solids[0].Name, name);
    EXPECT_DOUBLE_EQ(VolumeOf(solids[0]), 1.0);
  }
}

TEST(WriteStl, ClosedWithTheVolumesOfTheMesh)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const Folder folder;
    std::vector<std::string> files;
    for (int count : { 1, 3 })
    {
      WithMesh(count, make,
        [&](const FileCase& part, Ranks& ranks)
        {
          WriteMesh(part.Mesh, folder / "mesh.stl", ranks);
          if (ranks.Rank() == 0)
          {
            CheckSolids(ReadStl(folder / "mesh.stl"), part.Materials);
          }
        });
      files.push_back(ReadBytes(folder / "mesh.stl"));
    }
    EXPECT_EQ(files[0], files[1]);
  }
}

/// A triangle between two materials is in the surfaces of both, in opposite orientations.
TEST(WriteStl, NeighboursHaveTheSameTriangles)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const Folder folder;
    WithMesh(1, make,
      [&](const FileCase& part, Ranks& ranks)
      { WriteMesh(part.Mesh, folder / "mesh.stl", ranks); });
    std::map<std::array<Vector3, 3>, std::vector<bool>> sides; // orientation of each occurrence
    for (const Solid& solid : ReadStl(folder / "mesh.stl"))
    {
      for (std::size_t c = 0; c < solid.Corners.size(); c += 3)
      {
        std::array<Vector3, 3> corners{ solid.Corners[c], solid.Corners[c + 1],
          solid.Corners[c + 2] };
        std::rotate(
          corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        const bool isTurned = corners[2] < corners[1];
        std::sort(corners.begin(), corners.end());
        sides[corners].push_back(isTurned);
      }
    }
    Index shared = 0;
    for (const auto& [corners, turned] : sides)
    {
      ASSERT_LE(turned.size(), 2u);
      shared += turned.size() == 2;
      EXPECT_TRUE(turned.size() == 1 || turned[0] != turned[1]);
    }
    EXPECT_GT(shared, 100);
  }
}

/// A mesh that was read from a file has no facets: they are found.
TEST(WriteStl, SameWithoutFacets)
{
  const Folder folder;
  WithMesh(1, MakeHexMesh,
    [&](const FileCase& part, Ranks& ranks)
    {
      WriteMesh(part.Mesh, folder / "mesh.stl", ranks);
      MeshData read = part.Mesh;
      read.Facets = nullptr;
      WriteMesh(read, folder / "read.stl", ranks);
    });
  EXPECT_EQ(ReadBytes(folder / "mesh.stl"), ReadBytes(folder / "read.stl"));
}

TEST(WriteStl, Errors)
{
  EXPECT_EQ(FindOutputProblem("a{}.vtu"), "");
  EXPECT_EQ(FindOutputProblem("{}.stl"), "");
  for (const char* path : { "{}{}.stl", "{}/a.stl", "{}/{}.stl" })
  {
    EXPECT_EQ(FindOutputProblem(path),
      std::string("The output ") + path +
        " has {} for the name of a material in its folder or twice. Use it once, in the name of "
        "the file, as in bones_{}.stl.");
  }
  const Folder folder;
  Ranks alone;
  TwoCubes cubes;
  cubes.Data.Fields.push_back({ "PeriodLengths", std::vector<double>{ 3, 0, 0 }, 3 });
  const auto messageFor = [&](const std::string& path) -> std::string
  {
    try
    {
      WriteMesh(cubes.Data, path, alone);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(messageFor(folder / "a.stl").find("sides of the mesh are joined"), std::string::npos);
  cubes.Data.Fields.pop_back();
  std::filesystem::create_directory(folder / "c.stl");
  EXPECT_EQ(messageFor(folder / "{}.stl"),
    "Cannot write the output " + (folder / "{}.stl") + ": " + (folder / "c.stl") +
      ": Is a directory.");
}
