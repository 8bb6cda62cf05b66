/// For any labels the tetrahedra are positive and conforming, boundaries are closed manifolds, and
/// the reported fragments are correct.
#include "MeshCases.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Case
{
  TetMethod Method;
  int Materials;
  unsigned Seeds;
  Index Smallest; // smallest number of cells per axis
};

void PrintTo(const Case& c, std::ostream* out)
{
  *out << NameOf(c.Method) << ", " << c.Materials << " materials";
}

class TetRandomLabels : public ::testing::TestWithParam<Case>
{
};

std::vector<Case> ListCases()
{
  std::vector<Case> cases;
  for (int materials = 1; materials <= 5; ++materials)
  {
    cases.push_back({ TetMethod::Cells, materials, 10, 3 });
    cases.push_back({ TetMethod::Lattice, materials, 10, 3 });
    if (HasTetGen())
    {
      cases.push_back({ TetMethod::TetGen, materials, 10, 2 });
    }
  }
  return cases;
}

/// Worst values of many meshes.
struct Worst
{
  double SmallestAngle = 180.0, LargestAngle = 0.0, Determinant = 1e300;
  Index RefusedParts = 0, Fragments = 0;
  SurfaceDefects Defects; // sums
};

} // namespace

TEST_P(TetRandomLabels, MeshIsValid)
{
  const Case& c = this->GetParam();
  Worst worst;
  for (unsigned seed : ListSeeds(c.Seeds))
  {
    const bool hasVoid = seed % 2 == 0;
    const Index n = c.Smallest + seed % (c.Method == TetMethod::TetGen ? 5 : 7);
    const CartesianGrid grid = MakeUnitGrid(n, n + seed % 3, n + seed / 2 % 2);
    const FractionField field = MakeRandomLabels(grid, c.Materials, hasVoid ? 0 : 1, seed);
    MeshOptions options;
    options.Method = c.Method;
    options.MeshVoid = seed / 2 % 2 == 1;
    Runtime runtime;
    MeshReport report;
    const Mesh mesh = MakeTetMesh(grid, field, options, runtime, report);
    SCOPED_TRACE("seed " + std::to_string(seed));
    if (mesh.ElementIds.empty())
    {
      continue;
    }
    const double determinant = SmallestCornerDeterminant(mesh);
    ASSERT_GT(determinant, 0.0);
    ASSERT_EQ(FindConformityProblem(mesh), "");
    ASSERT_EQ(FindFragmentProblem(mesh), "");
    for (const auto& material : CountBoundaryDefects(mesh))
    {
      worst.Defects.OddEdges += material.second.OddEdges;
      worst.Defects.NonManifoldPoints += material.second.NonManifoldPoints;
    }
    if (options.MeshVoid || !hasVoid)
    {
      double volume = 0.0;
      for (int m = 0; m <= c.Materials; ++m)
      {
        volume += MeasureVolume(mesh, m);
      }
      const double cells = static_cast<double>(grid.Owned().NumberOfCells());
      ASSERT_NEAR(volume, cells, 1e-9 * cells);
    }
    worst.Determinant = std::min(worst.Determinant, determinant);
    worst.SmallestAngle = std::min(worst.SmallestAngle, report.MinimumDihedralAngle);
    worst.LargestAngle = std::max(worst.LargestAngle, report.MaximumDihedralAngle);
    worst.RefusedParts += report.RefusedParts;
    worst.Fragments += report.NumberOfFragments;
  }
  std::printf(
    "dihedral %.1f - %.1f, smallest determinant %.2e, boundaries with %lld non-manifold edges "
    "and %lld points, %lld of %lld parts rejected\n",
    worst.SmallestAngle, worst.LargestAngle, worst.Determinant,
    static_cast<long long>(worst.Defects.OddEdges),
    static_cast<long long>(worst.Defects.NonManifoldPoints),
    static_cast<long long>(worst.RefusedParts), static_cast<long long>(worst.Fragments));
  EXPECT_EQ(worst.Defects.OddEdges, 0);
  EXPECT_EQ(worst.Defects.NonManifoldPoints, 0);
}

INSTANTIATE_TEST_SUITE_P(Materials, TetRandomLabels, ::testing::ValuesIn(ListCases()),
  [](const ::testing::TestParamInfo<Case>& info)
  { return NameOf(info.param.Method) + "_" + std::to_string(info.param.Materials); });
