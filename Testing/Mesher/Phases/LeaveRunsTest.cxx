/// Meshes have all hexes if an option or the input needs them.
#include "Phases/LeaveRuns.h"
#include "Base/ThreadRuntime.h"
#include "LabelInput.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr LabelGrid Grid{ { { 24, 20, 20 } }, 0.0, 1.0 };

/// Returns two materials on both sides of a plane.
std::vector<int> MakeLabels()
{
  std::vector<int> labels;
  ForCells({ {}, Grid.Cells }, [&](const Index3& cell) { labels.push_back(cell[0] < 12 ? 1 : 2); });
  return labels;
}

/// Returns the number of hexes that the mesh leaves out.
Index CountLeftOut(const MesherOptions& options, const MesherInput& input)
{
  Runtime serial;
  CellRuns leftOut;
  const MesherResult mesh = RunMesher(input, options, serial, &leftOut);
  EXPECT_FALSE(mesh.TheMesh.Material.empty());
  return leftOut.Count();
}

Index CountLeftOut(const MesherOptions& options)
{
  Ranks alone;
  return CountLeftOut(options, MakeLabelInput(Grid, MakeLabels(), alone));
}

} // namespace

TEST(LeaveRuns, OnlyIfNothingNeedsAllHexes)
{
  EXPECT_GT(CountLeftOut(MesherOptions()), 0);
  MesherOptions options;
  options.Elements = ElementKind::Tets;
  EXPECT_EQ(CountLeftOut(options), 0);
  options = MesherOptions();
  options.StairStep = true;
  EXPECT_EQ(CountLeftOut(options), 0);
  options = MesherOptions();
  options.ElementOrder = InterpolationOrder::Quadratic;
  EXPECT_EQ(CountLeftOut(options), 0);
  options = MesherOptions();
  options.SplitInterfaces = "1/2";
  EXPECT_EQ(CountLeftOut(options), 0);
  options = MesherOptions();
  options.Layers = 2;
  EXPECT_EQ(CountLeftOut(options), 0);
  options = MesherOptions();
  options.Periodic = 2;
  EXPECT_EQ(CountLeftOut(options), 0);
  options = MesherOptions();
  options.CellWidth = "2";
  EXPECT_EQ(CountLeftOut(options), 0);
}

TEST(LeaveRuns, NotWithState)
{
  Ranks alone;
  MesherInput input = MakeLabelInput(Grid, MakeLabels(), alone);
  input.Arrays.State.Arrays = { "labels" };
  EXPECT_EQ(CountLeftOut(MesherOptions(), input), 0);
}

TEST(LeaveRuns, NotOnSeveralRanks)
{
  RunOnRanks(2,
    [](Ranks& ranks)
    {
      ThreadRuntime runtime(1, &ranks);
      CellRuns leftOut;
      RunMesher(MakeLabelInput(Grid, MakeLabels(), ranks), MesherOptions(), runtime, &leftOut);
      EXPECT_EQ(leftOut.Count(), 0);
    });
}
