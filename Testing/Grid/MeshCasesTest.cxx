/// Manufactured shapes: quality, distance to the true interface, volume, topology.
#include "MeshCases.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

class MeshCases : public ::testing::TestWithParam<std::string>
{
};

TEST_P(MeshCases, ReachesItsFigures)
{
  const MeshCase c = MakeMeshCase(this->GetParam());
  Runtime runtime;
  const MeshFigures figures = MeasureCase(c, MeshOptions(), runtime);
  std::printf("%s", FormatFigures(c.Name, figures).c_str());
  EXPECT_EQ(FindTopologyProblem(figures.Result), "");
  EXPECT_EQ(FindFragmentProblem(figures.Result), "");
  EXPECT_TRUE(IsPositiveEverywhere(figures.Result));
  EXPECT_GE(figures.Report.MinimumScaledJacobian, c.MinimumJacobian);
  EXPECT_GE(figures.Report.MeanScaledJacobian, c.MeanJacobian);
  EXPECT_LE(figures.Distance.Largest, c.LargestDistance);
  EXPECT_LE(figures.Distance.RootMeanSquare, c.RmsDistance);
  EXPECT_LE(figures.VolumeError, c.VolumeError);
}

INSTANTIATE_TEST_SUITE_P(All, MeshCases, ::testing::ValuesIn(ListMeshCases()),
  [](const ::testing::TestParamInfo<std::string>& info)
  {
    std::string name = info.param;
    for (char& c : name)
    {
      c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    }
    return name;
  });

/// Interface points on sides of the domain are as near to the true interface as others.
TEST(SidesOfTheDomain, NodesAreNear)
{
  struct Bounds
  {
    const char* Name;
    double Hexes, Lattice, Cells; // upper bounds of the rms distance on sides, in cells
  };
  for (const Bounds& b :
    { Bounds{ "half sphere", .016, .012, .065 }, Bounds{ "cut cylinder", .010, .046, .055 } })
  {
    const MeshCase c = MakeMeshCase(b.Name);
    const auto measure = [&](const char* kind, MeshMaker make, TetMethod method, double bound)
    {
      Runtime runtime;
      MeshOptions options;
      options.Method = method;
      const Distances d = MeasureCase(c, options, runtime, make).OnSides;
      std::printf("%s, %s: on sides rms %.4f, largest %.4f cells\n", b.Name, kind, d.RootMeanSquare,
        d.Largest);
      EXPECT_LE(d.RootMeanSquare, bound);
    };
    measure("hexes", MakeHexMesh, TetMethod::Cells, b.Hexes);
    measure("Lattice", MakeTetMesh, TetMethod::Lattice, b.Lattice);
    measure("Cells", MakeTetMesh, TetMethod::Cells, b.Cells);
  }
}
