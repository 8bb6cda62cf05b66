/// Files of meshes that leave out hexes are the files of all hexes.
#include "Meshes/Vtk/WriteVtu.h"
#include "FileCases.h"
#include "LabelInput.h"
#include "Meshes/WriteMesh.h"
#include "Octree/RefinedGrid.h"

#include <sys/stat.h>
#include <thread>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr LabelGrid Grid{ { { 40, 24, 28 } }, 1.0, 0.5 };

/// Returns a step of material 2 below material 1, and void in a corner.
MesherInput MakeInput(Ranks& ranks)
{
  std::vector<int> labels;
  ForCells({ {}, Grid.Cells },
    [&](const Index3& cell)
    {
      const bool isVoid = cell[0] > 30 && cell[1] > 15 && cell[2] > 10;
      labels.push_back(isVoid ? 0 : cell[2] < (cell[0] < 20 ? 9 : 14) ? 2 : 1);
    });
  return MakeLabelInput(Grid, labels, ranks);
}

std::string WriteAll(const std::string& path)
{
  Runtime serial;
  const MesherResult all = RunMesher(MakeInput(serial.Group()), MesherOptions(), serial);
  MeshData mesh = ViewMesh(all.TheMesh, all.State, all.Fields);
  mesh.Time = 0.25;
  WriteMesh(mesh, path, serial.Group());
  return ReadBytes(path);
}

std::string WriteWithRuns(const std::string& path)
{
  Runtime serial;
  CellRuns leftOut;
  const MesherResult part = RunMesher(MakeInput(serial.Group()), MesherOptions(), serial, &leftOut);
  EXPECT_GT(leftOut.Count(), 5000);
  MeshData mesh = ViewMesh(part.TheMesh, part.State, part.Fields);
  mesh.Time = 0.25;
  WriteMesh(MeshWithRuns(mesh, part.TheMesh.Levels->Finest(), leftOut), path);
  return ReadBytes(path);
}

} // namespace

TEST(WriteVtu, HexesThatAreLeftOutAreWritten)
{
  const Folder folder;
  EXPECT_TRUE(TakesRuns("mesh.vtu"));
  EXPECT_FALSE(TakesRuns("mesh.pvtu"));
  const std::string all = WriteAll(folder / "all.vtu");
  EXPECT_GT(all.size(), 100000u);
  EXPECT_EQ(WriteWithRuns(folder / "part.vtu"), all);
  EXPECT_THROW(WriteWithRuns(folder / "no/part.vtu"), InputError);
}

/// Sizes that follow their values are not known when a pipe gets the first bytes.
TEST(WriteVtu, PipesGetTheBytesOfFiles)
{
  const Folder folder;
  const std::string path = folder / "pipe.vtu";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = ReadBytes(path); });
  Ranks alone;
  Runtime serial;
  const MesherResult all = RunMesher(MakeInput(alone), MesherOptions(), serial);
  MeshData mesh = ViewMesh(all.TheMesh, all.State, all.Fields);
  mesh.Time = 0.25;
  WriteMesh(mesh, path, alone);
  reader.join();
  EXPECT_EQ(read, WriteAll(folder / "all.vtu"));
}
