/// Manufactured shapes: quality, distance to the truth, volume, topology.
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
