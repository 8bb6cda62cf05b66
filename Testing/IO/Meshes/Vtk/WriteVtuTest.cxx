/// Files of meshes that leave out hexes are the files of all hexes.
#include "Meshes/Vtk/WriteVtu.h"
#include "RunsCases.h"

#include <sys/stat.h>
#include <thread>

using namespace vfm;
using namespace vfm::testing;

TEST(WriteVtu, HexesThatAreLeftOutAreWritten)
{
  const Folder folder;
  EXPECT_TRUE(TakesRuns("mesh.vtu"));
  EXPECT_FALSE(TakesRuns("mesh.pvtu"));
  const std::string all = ReadBytes(WriteAll(folder / "all.vtu"));
  EXPECT_GT(all.size(), 100000u);
  EXPECT_EQ(ReadBytes(WriteWithRuns(folder / "part.vtu")), all);
  EXPECT_THROW(WriteWithRuns(folder / "no/part.vtu"), InputError);
}

/// Sizes that precede the values are not known when a pipe gets the first bytes.
TEST(WriteVtu, PipesGetTheBytesOfFiles)
{
  const Folder folder;
  const std::string path = folder / "pipe.vtu";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = ReadBytes(path); });
  WriteAll(path);
  reader.join();
  EXPECT_EQ(read, ReadBytes(WriteAll(folder / "all.vtu")));
}
