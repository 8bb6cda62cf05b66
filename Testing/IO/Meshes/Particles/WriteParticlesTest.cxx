/// Particles in mesh files: the same bytes from any number of ranks; all files or none; lists of
/// parts. The test ParticleFiles of Python reads the files.
#include "Meshes/Particles/WriteParticles.h"
#include "Meshes/Exodus/ExodusModel.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/Particles/ParticleParts.h"
#include "Meshes/WriteMesh.h"
#include "Modify/SplitInterfaces.h"
#include "WithParticles.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

namespace fs = std::filesystem;

/// Returns all files of a folder and its folders; the date in Exodus files becomes zeros.
std::map<std::string, std::string> ReadAll(const Folder& folder)
{
  std::map<std::string, std::string> files;
  const fs::path root(folder / "");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
  {
    if (!entry.is_regular_file())
    {
      continue;
    }
    std::string bytes = ReadBytes(entry.path().string());
    constexpr std::size_t length = 33;
    const std::size_t record = bytes.rfind("VolumeFractionMesh");
    for (std::size_t i = record + 2 * length;
         entry.path().extension() == ".exo" && i < record + 4 * length; ++i)
    {
      bytes[i] = std::isdigit(static_cast<unsigned char>(bytes[i])) ? '0' : bytes[i];
    }
    files[entry.path().string().substr(root.string().size())] = bytes;
  }
  return files;
}

/// Suffixes of formats that hold particles or write them beside, in one file from all ranks.
const std::vector<std::string> Suffixes{ ".vtu", ".exo", ".inp", ".k", ".rad", ".bdf", ".msh",
  ".xdmf", ".foam", ".stl", ".vtp", ".data" };

/// Writes the particles and a mesh in all formats, each as one file or case from all ranks.
std::map<std::string, std::string> WriteAll(int count, const ParticleForm& form)
{
  const Folder folder;
  WithParticles(
    count, MakeHexMesh,
    [&](const MeshData& mesh, Ranks& ranks)
    {
      for (const std::string& suffix : Suffixes)
      {
        const bool isSingle = suffix == ".exo" || suffix == ".foam";
        // each file beside one of these has a name of its own
        const std::string name = suffix.substr(1) + suffix;
        if (form.HasMass || suffix != ".data")
        {
          WriteMesh(mesh, folder / name, ranks, { .IsSingle = isSingle });
        }
      }
    },
    form);
  return ReadAll(folder);
}

TEST(WriteParticles, SameBytesOnRanks)
{
  for (const ParticleForm& form :
    std::vector<ParticleForm>{ {}, { false, true, 203 }, { true, false, 7 }, { true, true, 0 } })
  {
    const std::map<std::string, std::string> one = WriteAll(1, form);
    EXPECT_EQ(one.count("vtu_particles.vtp") + one.count("msh_particles.vtp") +
        one.count("xdmf_particles.vtp") + one.count("stl_particles.vtp"),
      4u);
    EXPECT_EQ(one.count("0/lagrangian/particles/rho"), form.HasMass && form.Count > 0 ? 1u : 0u);
    for (int count : { 2, 3 })
    {
      const std::map<std::string, std::string> several = WriteAll(count, form);
      EXPECT_EQ(several.size(), one.size());
      for (const auto& [name, bytes] : one)
      {
        EXPECT_TRUE(several.count(name) > 0 && several.at(name) == bytes)
          << name << " " << form.HasMass << " " << form.Count;
      }
    }
  }
}

TEST(WriteParticles, FilesBesideAreFound)
{
  for (const FormatRow& format : GetFormatTable())
  {
    const Folder folder;
    const std::string path = folder / ("mesh" + format.Suffixes[0]);
    WithParticles(
      1, MakeHexMesh, [&](const MeshData& mesh, Ranks& ranks) { WriteMesh(mesh, path, ranks); });
    const std::string beside = folder / "mesh_particles.vtp";
    EXPECT_EQ(FindParticlesBeside(path), fs::exists(beside) ? beside : "") << path;
  }
}

TEST(WriteParticles, MeshesWithoutParticlesKeepTheirFiles)
{
  for (const std::string& suffix : Suffixes)
  {
    if (suffix == ".vtp" || suffix == ".data")
    {
      continue;
    }
    std::vector<std::map<std::string, std::string>> files;
    for (const bool hasEmpty : { false, true })
    {
      const Folder folder;
      WithMesh(1, MakeTetMesh,
        [&](const FileCase& part, Ranks& ranks)
        {
          const ParticleData none;
          MeshData mesh = part.Mesh;
          mesh.Particles = hasEmpty ? &none : nullptr;
          WriteMesh(mesh, folder / ("mesh" + suffix), ranks);
        });
      files.push_back(ReadAll(folder));
    }
    // A mesh made with particles of which there are none has an empty file or cloud of them.
    for (const auto& [name, bytes] : files[0])
    {
      EXPECT_TRUE(files[1][name] == bytes) << name;
    }
    const bool isBeside =
      std::find(Suffixes.begin() + 1, Suffixes.begin() + 6, suffix) == Suffixes.begin() + 6;
    EXPECT_EQ(files[1].size() > files[0].size(), isBeside) << suffix;
  }
}

TEST(WriteParticles, AllFilesOrNone)
{
  for (const char* name :
    { "mesh.vtu", "mesh.pvtu", "mesh.msh", "mesh.xdmf", "mesh.stl", "mesh.foam" })
  {
    const Folder folder;
    const bool isCase = std::string(name) == "mesh.foam";
    const std::string beside = isCase ? "0/lagrangian/particles/d" : "mesh_particles.vtp";
    fs::create_directories(folder / "0/lagrangian/particles");
    fs::create_symlink("/dev/full", folder / beside);
    std::ofstream(folder / name) << "earlier";
    WithParticles(std::string(name) == "mesh.pvtu" ? 1 : 2, MakeHexMesh,
      [&](const MeshData& mesh, Ranks& ranks)
      { EXPECT_THROW(WriteMesh(mesh, folder / name, ranks, { .IsSingle = isCase }), InputError); });
    EXPECT_EQ(ReadBytes(folder / name), "earlier") << name;
    EXPECT_EQ(folder.CountFiles(), isCase ? 2u : 3u) << name;
  }
}

TEST(WriteParticles, EachRankWritesItsParticles)
{
  const Folder folder;
  WithParticles(3, MakeHexMesh,
    [&](const MeshData& mesh, Ranks& ranks)
    {
      WriteMesh(mesh, folder / "mesh.pvtu", ranks);
      WriteMesh(mesh, folder / "mesh.foam", ranks);
    });
  const std::map<std::string, std::string> files = ReadAll(folder);
  EXPECT_GT(files.at("mesh_particles.vtp").size(), 1000u);
  for (const auto& [rank, count] :
    std::vector<std::pair<int, const char*>>{ { 0, "102\n" }, { 1, "101\n" }, { 2, "0\n" } })
  {
    const std::string text =
      files.at("processor" + std::to_string(rank) + "/0/lagrangian/particles/U");
    EXPECT_NE(text.find(std::string("}\n\n") + count + "("), std::string::npos) << rank;
  }
}

TEST(WriteParticles, IdsDifferFromThoseOfCohesiveElements)
{
  const ParticleForm form{ .Change = [](Mesh& mesh, FieldArrays& fields, Ranks& ranks)
    {
      OutputState state;
      RankRuntime runtime(ranks);
      SplitInterfaces(MaterialPairs("SplitInterfaces", "all", {}), ConnectionKind::Cohesive,
        runtime, fields, mesh, state);
    } };
  std::map<int, std::set<Index>> elements, nodes, all;
  std::mutex lock;
  std::vector<std::string> decks;
  for (int count : { 1, 3 })
  {
    const Folder folder;
    WithParticles(
      count, MakeHexMesh,
      [&](const MeshData& mesh, Ranks& ranks)
      {
        WriteMesh(mesh, folder / "mesh.inp", ranks);
        const ExodusModel model = MakeExodusModel(mesh, ranks);
        const MeshData& part = model.Mesh.Data;
        const std::lock_guard<std::mutex> hold(lock);
        std::set<int> blocks;
        for (const ExodusBlock& block : model.Blocks)
        {
          EXPECT_TRUE(blocks.insert(block.Id).second) << block.Id;
        }
        EXPECT_EQ(blocks.size(), 8u); // three materials, their pairs, materials of particles
        const Index total = std::accumulate(model.Blocks.begin(), model.Blocks.end(), Index(0),
          [](Index sum, const ExodusBlock& block) { return sum + block.Total; });
        EXPECT_EQ(model.TotalElements, total);
        elements[count].insert(model.ParticleIds.begin(), model.ParticleIds.end());
        nodes[count].insert(part.PointIds + part.NumberOfPoints - model.ParticleIds.size(),
          part.PointIds + part.NumberOfPoints);
        all[count].insert(part.ElementIds, part.ElementIds + part.NumberOfElements);
        for (const CohesiveBlock& block : model.Cohesive)
        {
          all[count].insert(block.Ids.begin(), block.Ids.end());
        }
      },
      form);
    decks.push_back(ReadBytes(folder / "mesh.inp"));
    EXPECT_EQ(elements[count].size(), 203u);
    EXPECT_EQ(nodes[count].size(), 203u);
    EXPECT_EQ(*elements[count].begin(), *all[count].rbegin() + 1);
    EXPECT_EQ(*elements[count].rbegin(), *all[count].rbegin() + 203);
  }
  EXPECT_EQ(elements[1], elements[3]);
  EXPECT_EQ(nodes[1], nodes[3]);
  EXPECT_TRUE(decks[0] == decks[1]);
  EXPECT_NE(decks[0].find("*ELEMENT, TYPE=COH3D8"), std::string::npos);
  EXPECT_NE(decks[0].find("*ELEMENT, TYPE=MASS"), std::string::npos);
}

TEST(WriteParticles, OneFilePerMaterialHasItsParticlesBeside)
{
  EXPECT_EQ(PathOfParticles("a/bones_{}.stl"), "a/bones_particles.vtp");
  EXPECT_EQ(PathOfParticles("mesh.v2.vtu"), "mesh.v2_particles.vtp");
  const Folder folder;
  WithParticles(1, MakeHexMesh,
    [&](const MeshData& mesh, Ranks& ranks) { WriteMesh(mesh, folder / "bones_{}.stl", ranks); });
  EXPECT_TRUE(fs::exists(folder / "bones_particles.vtp"));
  EXPECT_EQ(folder.CountFiles(), 4u);
}

/// Expects an error of WriteMesh with a text.
void ExpectError(const MeshData& mesh, const std::string& path, const char* text)
{
  Ranks alone;
  try
  {
    WriteMesh(mesh, path, alone);
    ADD_FAILURE() << path;
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(WriteParticles, Errors)
{
  const Folder folder;
  const ParticleCase particles = MakeParticles(4, { 0, 3, 0, 1, 0, 1 }, 0, 1, false);
  TwoCubes cubes;
  for (const char* name : { "a.vtp", "a.data" })
  {
    ExpectError(cubes.Data, folder / name, "made without particles");
  }
  cubes.Data.Particles = &particles.Data;
  ExpectError(cubes.Data, folder / "a.data", "have no mass");
  cubes.Data.Fields[2].Values = std::vector<int>{ 1, 2147483646 };
  ExpectError(cubes.Data, folder / "a.exo", "No id is left");
  ParticleCase twice = MakeParticles(4, { 0, 3, 0, 1, 0, 1 }, 0, 1);
  twice.Ids[2] = twice.Ids[0];
  cubes.Data.Particles = &twice.Data;
  ExpectError(cubes.Data, folder / "a.vtu", "same id");
  EXPECT_EQ(folder.CountFiles(), 0u);
}

TEST(ParticleParts, IdsFollowThoseOfMaterialsAndOfTheVoid)
{
  const ParticleCase particles = MakeParticles(4, { 0, 3, 0, 1, 0, 1 }, 0, 1);
  TwoCubes cubes;
  cubes.Data.Particles = &particles.Data;
  Ranks alone;
  const std::vector<ParticlePart> parts = FindParticleParts(cubes.Data, {}, alone);
  ASSERT_EQ(parts.size(), 2u);
  // Materials 1, 2, 3; the void would be 3, and a material without elements counts, too.
  EXPECT_EQ(parts[0].Material, 1);
  EXPECT_EQ(parts[0].Id, 4);
  EXPECT_EQ(parts[0].Name, "a \"b\"_particles");
  EXPECT_EQ(parts[1].Material, 3);
  EXPECT_EQ(parts[1].Id, 6);
  EXPECT_EQ(parts[1].Name, "Material 3_particles");
  EXPECT_EQ(parts[0].Particles, (std::vector<Index>{ 1, 2 }));
  EXPECT_EQ(parts[1].Particles, (std::vector<Index>{ 0, 3 }));
  const std::vector<CohesiveBlock> cohesive{ { 9, "", { 1, 2 }, {}, {}, {} } };
  EXPECT_EQ(FindParticleParts(cubes.Data, cohesive, alone)[0].Id, 10);
}

TEST(GatherParticles, NumbersAscendByIdOverAllRanks)
{
  std::map<Index, Index> numbers;
  std::mutex lock;
  RunOnRanks(3,
    [&](Ranks& ranks)
    {
      const ParticleCase particles = MakeParticles(31, { 0, 1, 0, 1, 0, 1 }, ranks.Rank(), 3);
      const std::shared_ptr<const ParticleData> ordered = OrderParticles(&particles.Data, ranks);
      const std::vector<Index> found = NumberParticles(*ordered, ranks);
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      const std::lock_guard<std::mutex> hold(lock);
      for (std::size_t p = 0; p < found.size(); ++p)
      {
        numbers[ordered->Ids[p]] = found[p];
      }
    });
  ASSERT_EQ(numbers.size(), 31u);
  Index next = 0;
  for (const auto& [id, number] : numbers)
  {
    EXPECT_EQ(number, next++) << id;
  }
}

} // namespace
