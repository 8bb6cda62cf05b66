/// For any labels the mesh is valid and conforming, and each material has
/// a closed manifold boundary.
#include "MeshChecks.h"
#include "Sweep.h"

#include "Labels/LabelCondition.h"
#include "Labels/ResolveLabels.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Case
{
  int Materials;
  int Lowest; // 0: with void
  bool MeshVoid;
};

class RandomLabels : public ::testing::TestWithParam<Case>
{
};

/// Counts the expected elements: one per meshed cell, interface face and meshed domain side.
std::size_t CountByLaw(const CartesianGrid& grid, const LabelArray& labels, bool meshVoid)
{
  std::size_t count = 0;
  Index3 p;
  for (p[2] = 0; p[2] < grid.Owned().Upper[2]; ++p[2])
  {
    for (p[1] = 0; p[1] < grid.Owned().Upper[1]; ++p[1])
    {
      for (p[0] = 0; p[0] < grid.Owned().Upper[0]; ++p[0])
      {
        const int label = labels[grid.Linear(p)];
        if (label == 0 && !meshVoid)
        {
          continue;
        }
        ++count;
        for (int face = 0; face < 6; ++face)
        {
          Index3 q = p;
          q[face / 2] += face & 1 ? 1 : -1;
          count += grid.InDomain(q) && labels[grid.Linear(q)] != label;
        }
      }
    }
  }
  return count;
}

} // namespace

TEST_P(RandomLabels, MeshIsValid)
{
  double worstJacobian = 1.0, worstDeterminant = 1e300;
  for (unsigned seed : ListSeeds(20))
  {
    const Case& c = this->GetParam();
    const Index n = 3 + seed % 7;
    const CartesianGrid grid = MakeUnitGrid(n, n + seed % 3, n + seed % 2);
    const FractionField field = MakeRandomLabels(grid, c.Materials, c.Lowest, seed);
    MeshOptions options;
    options.MeshVoid = c.MeshVoid;
    Runtime runtime;
    MeshReport report;
    const Mesh mesh = MakeHexMesh(grid, field, options, runtime, report);
    LabelArray labels = AssignMaterials(grid, field, options.IsoValue);
    ResolveLabels(grid, field, labels, Partition(grid, runtime.Group()), runtime);
    for (Index node : FindMixedNodes(grid, labels))
    {
      ASSERT_EQ(CountViolations(StarOfNode(grid, labels, node)), 0);
    }
    ASSERT_EQ(mesh.ElementIds.size(), CountByLaw(grid, labels, c.MeshVoid)) << "seed " << seed;
    if (mesh.ElementIds.empty())
    {
      continue;
    }
    ASSERT_EQ(FindTopologyProblem(mesh), "") << "seed " << seed;
    const double determinant = SmallestCornerDeterminant(mesh);
    ASSERT_GT(determinant, 0.0) << "seed " << seed;
    ASSERT_TRUE(IsPositiveEverywhere(mesh)) << "seed " << seed;
    worstDeterminant = std::min(worstDeterminant, determinant);
    worstJacobian = std::min(worstJacobian, report.MinimumScaledJacobian);
  }
  std::printf(
    "smallest scaled Jacobian %.4f, corner determinant %.2e\n", worstJacobian, worstDeterminant);
  EXPECT_GE(worstJacobian, 0.30);
}

INSTANTIATE_TEST_SUITE_P(Materials, RandomLabels,
  ::testing::Values(Case{ 1, 0, false }, Case{ 1, 0, true }, Case{ 2, 0, false },
    Case{ 2, 1, false }, Case{ 5, 0, false }, Case{ 5, 1, false }, Case{ 5, 0, true }));

TEST(RandomLabels, StartIsValidForEveryAcceptedStar)
{
  // Each accepted star of two labels, in a grid of very different widths
  // with a border that continues it.
  for (int region = 1; region < 255; ++region)
  {
    if (RegionNormalsTable[region].ViolatedAxes() != 0)
    {
      continue;
    }
    const std::array<std::vector<double>, 3> coordinates{ { { 0.0, 1.0, 8.0, 9.0, 1000.0 },
      { 0.0, 50.0, 51.0, 58.0, 59.0 }, { 0.0, 1.0, 2.0, 3.0, 4.0 } } };
    const CartesianGrid grid(coordinates);
    const FractionField field = MakeLabels(grid, 2,
      [&](const Index3& p)
      {
        const int c = static_cast<int>((p[0] > 1) | (p[1] > 1) << 1 | (p[2] > 1) << 2);
        return 1 + (region >> c & 1);
      });
    MeshOptions options;
    options.Smoothing = SmoothingMethod::Off;
    Runtime runtime;
    MeshReport report;
    const Mesh mesh = MakeHexMesh(grid, field, options, runtime, report);
    ASSERT_EQ(report.FlippedCells, 0) << region;
    ASSERT_GT(SmallestCornerDeterminant(mesh), 0.0) << region;
    ASSERT_TRUE(IsPositiveEverywhere(mesh)) << region;
    ASSERT_EQ(FindTopologyProblem(mesh), "") << region;
  }
}
