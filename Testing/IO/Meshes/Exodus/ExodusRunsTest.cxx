/// Exodus files of meshes that leave out hexes are the files of all hexes.
#include "Meshes/Exodus/ExodusRuns.h"
#include "Meshes/WriteMesh.h"
#include "RunsCases.h"

using namespace vfm;
using namespace vfm::testing;

TEST(ExodusRuns, HexesThatAreLeftOutAreWritten)
{
  const Folder folder;
  EXPECT_TRUE(TakesRuns("mesh.exo"));
  const std::string all = ReadWithoutDate(WriteAll(folder / "all.exo"));
  EXPECT_GT(all.size(), 500000u);
  EXPECT_EQ(ReadWithoutDate(WriteWithRuns(folder / "part.exo")), all);
}

TEST(ExodusRuns, NothingIsLeftOutOfOtherMeshes)
{
  EXPECT_FALSE(PartsOfCoordinates(nullptr, 0));
  EXPECT_FALSE(PartsOfNodes(nullptr, 1));
  EXPECT_FALSE(PartsOfPointIds(nullptr, MeshData()));
  EXPECT_FALSE(PartsOfElementIds(nullptr, MeshData(), { 1 }));
}
