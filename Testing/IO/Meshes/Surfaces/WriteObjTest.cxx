/// Surfaces of materials in files of OBJ: closed groups on common vertices, with the volumes of the
/// meshes, the same bytes from any number of ranks.
#include "Meshes/Surfaces/WriteObj.h"
#include "FileCases.h"
#include "Meshes/WriteMesh.h"

#include <cmath>
#include <map>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Triangle = std::array<Index, 3>;

struct Group
{
  std::string Name;
  std::vector<Triangle> Triangles; ///< vertices from 0
};

struct ObjFile
{
  std::vector<Vector3> Vertices;
  std::vector<Group> Groups;
};

ObjFile ReadObj(const std::string& path)
{
  ObjFile found;
  std::istringstream text(ReadBytes(path));
  for (std::string line; std::getline(text, line);)
  {
    std::istringstream words(line.substr(2));
    if (line[0] == 'v')
    {
      Vector3& vertex = found.Vertices.emplace_back();
      words >> vertex[0] >> vertex[1] >> vertex[2];
    }
    else if (line[0] == 'g')
    {
      found.Groups.push_back({ line.substr(2), {} });
    }
    else
    {
      EXPECT_EQ(line.substr(0, 2), "f ");
      Triangle triangle{};
      words >> triangle[0] >> triangle[1] >> triangle[2];
      for (Index& vertex : triangle)
      {
        --vertex;
        EXPECT_LT(vertex, static_cast<Index>(found.Vertices.size()));
      }
      found.Groups.back().Triangles.push_back(triangle);
    }
    EXPECT_FALSE(words.fail()) << line;
  }
  return found;
}

double VolumeOf(const ObjFile& file, const Group& group)
{
  double volume = 0.0;
  for (const Triangle& triangle : group.Triangles)
  {
    volume += Dot(file.Vertices[triangle[0]],
                Cross(file.Vertices[triangle[1]], file.Vertices[triangle[2]])) /
      6.0;
  }
  return volume;
}

/// Returns how many edges of triangles have no opposite edge, or occur more than once.
Index CountOpenEdges(const Group& group)
{
  std::map<std::array<Index, 2>, int> edges;
  for (const Triangle& triangle : group.Triangles)
  {
    for (int c = 0; c < 3; ++c)
    {
      ++edges[{ triangle[c], triangle[(c + 1) % 3] }];
    }
  }
  return std::count_if(edges.begin(), edges.end(),
    [&edges](const auto& edge) {
      return edge.second != 1 || edges.count({ edge.first[1], edge.first[0] }) != 1;
    });
}

/// Expects that vertices are different and used, and that a triangle of two groups has opposite
/// orientations.
void CheckCommon(const ObjFile& file)
{
  EXPECT_EQ(
    std::set<Vector3>(file.Vertices.begin(), file.Vertices.end()).size(), file.Vertices.size());
  std::set<Index> used;
  std::set<Triangle> triangles; // with the lowest vertex first
  for (const Group& group : file.Groups)
  {
    for (Triangle triangle : group.Triangles)
    {
      used.insert(triangle.begin(), triangle.end());
      std::rotate(
        triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
      EXPECT_TRUE(triangles.insert(triangle).second);
    }
  }
  EXPECT_EQ(used.size(), file.Vertices.size());
  const auto shared = std::count_if(triangles.begin(), triangles.end(),
    [&triangles](const Triangle& t) {
      return triangles.count({ t[0], t[2], t[1] }) == 1;
    });
  EXPECT_GT(shared, 0);
}

} // namespace

TEST(WriteObj, TwoCubes)
{
  const Folder folder;
  Ranks alone;
  WriteMesh(TwoCubes().Data, folder / "cubes.obj", alone);
  const ObjFile file = ReadObj(folder / "cubes.obj");
  ASSERT_EQ(file.Groups.size(), 2u);
  EXPECT_EQ(file.Groups[0].Name, "a__b_"); // without blanks
  EXPECT_EQ(file.Groups[1].Name, "c");
  EXPECT_EQ(file.Vertices.size(), 12u + 11u); // corners, centres of faces
  for (const Group& group : file.Groups)
  {
    EXPECT_EQ(group.Triangles.size(), 24u);
    EXPECT_EQ(CountOpenEdges(group), 0);
    EXPECT_DOUBLE_EQ(VolumeOf(file, group), 1.0);
  }
  CheckCommon(file);
}

TEST(WriteObj, OneFilePerMaterial)
{
  const Folder folder;
  Ranks alone;
  WriteMesh(TwoCubes().Data, folder / "of_{}.obj", alone);
  EXPECT_EQ(folder.CountFiles(), 2u);
  const ObjFile file = ReadObj(folder / "of_c.obj");
  ASSERT_EQ(file.Groups.size(), 1u);
  EXPECT_EQ(file.Vertices.size(), 8u + 6u);
  EXPECT_DOUBLE_EQ(VolumeOf(file, file.Groups[0]), 1.0);
}

TEST(WriteObj, ClosedWithTheVolumesOfTheMesh)
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
          WriteMesh(part.Mesh, folder / "mesh.obj", ranks);
          if (ranks.Rank() != 0)
          {
            return;
          }
          const ObjFile file = ReadObj(folder / "mesh.obj");
          const std::vector<double> volumes = NumbersOfField(part.Materials, "MeshVolume");
          ASSERT_EQ(file.Groups.size(), volumes.size());
          for (std::size_t g = 0; g < volumes.size(); ++g)
          {
            EXPECT_EQ(CountOpenEdges(file.Groups[g]), 0);
            EXPECT_NEAR(VolumeOf(file, file.Groups[g]) / volumes[g], 1.0, 1e-12);
          }
          CheckCommon(file);
        });
      files.push_back(ReadBytes(folder / "mesh.obj"));
    }
    EXPECT_EQ(files[0], files[1]);
  }
}
