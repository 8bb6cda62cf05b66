/// Mesh files are the same from any number of ranks; no file remains after a failed write.
#include "Meshes/WriteMesh.h"
#include "Geometry/GatherTables.h"
#include "RunsCases.h"

using namespace vfm;
using namespace vfm::testing;

namespace
{

namespace fs = std::filesystem;

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
          [&](const FileCase& part, Ranks& ranks)
          { WriteMesh(part.Mesh, path, ranks, { .IsSingle = true }); });
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
    [&](const FileCase& part, Ranks& ranks)
    {
      WriteMesh(part.Mesh, folder / "mesh.e", ranks);
      WriteMesh(part.Mesh, folder / "mesh.pvtu", ranks);
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
         { "mesh.xyz", "unknown format" }, { "no/mesh.vtu", "No such file or directory" },
         { "no/mesh.inp", "No such file or directory" }, { "full.vtu", "No space left on device" },
         { "full.exo", "full.exo.2.1: No space left on device" } })
  {
    WithMesh(2, MakeHexMesh,
      [&, name = name, reason = reason](const FileCase& part, Ranks& ranks)
      {
        try
        {
          WriteMesh(part.Mesh, folder / name, ranks);
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

namespace
{

/// Makes the interface of the first and third material a side that the surface of a body names.
/// @pre Collective.
void NameInterface(Mesh& mesh, FieldArrays& fields, Ranks& ranks)
{
  GeometryTables& tables = mesh.Tables;
  GatherSurfaceTables(ranks, tables);
  const std::array<int, 2> pair{ { 1, 3 } };
  const auto at = std::find(tables.SurfaceMaterials.begin(), tables.SurfaceMaterials.end(), pair);
  const auto number = at - tables.SurfaceMaterials.begin();
  tables.SurfaceParts.at(number) = 1;
  tables.PatchNames.assign(tables.SurfaceParts.size(), "");
  tables.PatchNames.at(number) = "inlet";
  for (MeshFacet& facet : mesh.Facets)
  {
    const int own = mesh.Material[facet.Element], behind = facet.Behind;
    if (std::min(own, behind) == 1 && std::max(own, behind) == 3)
    {
      facet.Surface = static_cast<int>(number) + 1;
    }
  }
  AppendFields(ListSides(tables), fields);
}

/// Returns all files of a folder in lower case.
std::string ReadLower(const std::string& folder)
{
  std::string all;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
  {
    all += entry.is_regular_file() ? ReadBytes(entry.path().string()) : "";
  }
  std::transform(all.begin(), all.end(), all.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return all;
}

} // namespace

TEST(WriteMesh, SidesHaveTheNamesOfPatches)
{
  for (const char* name :
    { "mesh.e", "mesh.inp", "mesh.bdf", "mesh.k", "mesh.rad", "mesh.msh", "mesh.xdmf", "mesh.vtu" })
  {
    const Folder folder;
    WithMesh(
      1, MakeHexMesh,
      [&](const FileCase& part, Ranks& ranks)
      { WriteMesh(part.Mesh, folder / name, ranks, { .IsSingle = true }); },
      {}, NameInterface);
    const char* expected = std::string(name) == "mesh.vtu" ? "patchnames" : "inlet_one_to_three";
    EXPECT_NE(ReadLower(folder / ".").find(expected), std::string::npos) << name;
  }
}
