/// Files of split interfaces: the same bytes from any number of ranks, and parts of Exodus files.
#include "FileCases.h"
#include "Meshes/Exodus/ExodusModel.h"
#include "Meshes/WriteMesh.h"
#include "Modify/SplitInterfaces.h"

#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

MeshChange SplitAll(ConnectionKind connection)
{
  return [connection](Mesh& mesh, FieldArrays& fields, Ranks& ranks)
  {
    OutputState state;
    RankRuntime runtime(ranks);
    SplitInterfaces(
      MaterialPairs("SplitInterfaces", "all", {}), connection, runtime, fields, mesh, state);
  };
}

constexpr MeshMaker Makers[] = { MakeHexMesh, MakeTetMesh };

TEST(WriteSplit, SameBytesOnRanks)
{
  const Folder folder;
  for (MeshMaker make : Makers)
  {
    for (ConnectionKind connection : { ConnectionKind::None, ConnectionKind::Cohesive,
           ConnectionKind::Contact, ConnectionKind::Tied })
    {
      for (const char* suffix : { ".inp", ".k", ".msh", ".vtu" })
      {
        for (int count : { 1, 3 })
        {
          WithMesh(
            count, make,
            [&](const FileCase& part, Ranks& ranks)
            { WriteMesh(part.Mesh, folder / (std::to_string(count) + suffix), ranks); },
            {}, SplitAll(connection));
        }
        const std::string one = ReadBytes(folder / (std::string("1") + suffix));
        EXPECT_GT(one.size(), 1000u);
        EXPECT_TRUE(one == ReadBytes(folder / (std::string("3") + suffix))) << suffix;
      }
    }
  }
}

/// Returns the ids of the cohesive elements and of their nodes, by name of the block.
using BlockIds = std::map<std::string, std::map<Index, std::vector<Index>>>;

TEST(WriteSplit, ExodusPartsHaveAllCohesiveElements)
{
  for (MeshMaker make : Makers)
  {
    std::map<int, BlockIds> all;
    for (int count : { 1, 3 })
    {
      std::mutex mutex;
      WithMesh(
        count, make,
        [&](const FileCase& part, Ranks& ranks)
        {
          const ExodusModel model = MakeExodusModel(part.Mesh, ranks);
          const std::lock_guard<std::mutex> lock(mutex);
          const int corners = CohesiveCorners(model.Mesh.Data);
          for (const ExodusBlock& block : model.Blocks)
          {
            if (!block.Cohesive)
            {
              continue;
            }
            for (std::size_t e = 0; e < block.Cohesive->Ids.size(); ++e)
            {
              std::vector<Index>& ids = all[count][block.Name][block.Cohesive->Ids[e]];
              EXPECT_TRUE(ids.empty());
              for (int c = 0; c < corners; ++c)
              {
                const Index point = block.Cohesive->Points[corners * e + c];
                ids.push_back(model.Mesh.Data.PointIds[point]);
              }
            }
            EXPECT_GE(block.Total, block.Count());
            EXPECT_TRUE(ranks.Count() > 1 || block.Total == block.Count());
          }
        },
        {}, SplitAll(ConnectionKind::Cohesive));
    }
    EXPECT_EQ(all[1].size(), 3u);
    EXPECT_TRUE(all[1] == all[3]);
  }
}

/// A mesh from a file has no facets: they are found across the split interfaces.
TEST(WriteSplit, FacetsAreFoundAgain)
{
  for (MeshMaker make : Makers)
  {
    WithMesh(
      3, make,
      [](const FileCase& part, Ranks& ranks)
      {
        const std::vector<CohesiveBlock> expected = FindCohesiveBlocks(part.Mesh, ranks);
        MeshData mesh = part.Mesh;
        mesh.Facets = nullptr;
        const std::vector<CohesiveBlock> found = FindCohesiveBlocks(mesh, ranks);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t b = 0; b < found.size(); ++b)
        {
          EXPECT_EQ(found[b].Name, expected[b].Name);
          EXPECT_TRUE(found[b].Points == expected[b].Points);
          EXPECT_TRUE(found[b].Ids == expected[b].Ids);
        }
      },
      {}, SplitAll(ConnectionKind::Cohesive));
  }
}

} // namespace
