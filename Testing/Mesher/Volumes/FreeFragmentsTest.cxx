/// Fragments that touch no other one get the volumes of their fractions, however small they are.
#include "Elements/MeasureFragments.h"
#include "Phases/MeshOfCells.h"
#include "RandomDraw.h"
#include "RankMeshes.h"
#include "Sweep.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Period = 8; // cells from drop to drop
constexpr int PerAxis = 3;

/// Returns drops of one cell, blurred over its neighbours: most of a drop is outside the cells that
/// are meshed. The first drops along each axis lie on sides of the domain.
FractionField MakeBlurredDrops(const CartesianGrid& grid, unsigned seed)
{
  RandomDraw draw(seed);
  FractionField field(grid, 1);
  const IndexBox drops{ {}, { { PerAxis, PerAxis, PerAxis } } };
  ForCells(drops,
    [&](const Index3& d)
    {
      const Index3 middle{ { Period * d[0], Period * d[1], Period * d[2] } };
      const double faint = draw.Between(0.02, 0.12);
      ForCells(Grow(BoxOfCell(middle), 1, grid.Global()),
        [&](const Index3& p) {
          field.SetParts(grid.Linear(p), { { 1, p == middle ? draw.Between(0.55, 0.95) : faint } });
        });
    });
  return field;
}

/// Returns the largest relative error of the volume of a fragment.
double WorstFragment(const Mesh& mesh, const MeshReport& report)
{
  std::vector<double> volumes(report.NumberOfFragments + 1, 0.0);
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    volumes[mesh.Fragment[e]] += VolumeOfElement(mesh, e);
  }
  double worst = 0.0;
  for (std::size_t f = 1; f < volumes.size(); ++f)
  {
    const double target = report.Fragments.Volumes[f - 1];
    worst = std::max(worst, std::fabs(volumes[f] - target) / target);
  }
  return worst;
}

} // namespace

TEST(FreeFragments, BlurredDropsGetTheirVolumes)
{
  const CartesianGrid grid = MakeUnitGrid(PerAxis * Period);
  Runtime runtime;
  MeshReport report;
  for (unsigned seed : ListSeeds(4))
  {
    const FractionField field = MakeBlurredDrops(grid, seed);
    const Mesh mesh = MakeHexMesh(grid, field, MeshOptions(), runtime, report);
    const double worst = WorstFragment(mesh, report);
    std::printf("seed %u: %lld drops, off by at most %.1e, smallest scaled Jacobian %.3f\n", seed,
      static_cast<long long>(report.NumberOfFragments), worst, report.MinimumScaledJacobian);
    EXPECT_EQ(report.NumberOfFragments, PerAxis * PerAxis * PerAxis);
    EXPECT_LT(worst, 1e-6);
    EXPECT_GT(report.MinimumScaledJacobian, 0.5);
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
  }
}

TEST(FreeFragments, BlurredDropsGetTheirVolumesAsTets)
{
  const CartesianGrid grid = MakeUnitGrid(PerAxis * Period);
  Runtime runtime;
  MeshReport report;
  for (TetMethod method : { TetMethod::Lattice, TetMethod::Cells })
  {
    MeshOptions options;
    options.Method = method;
    const Mesh mesh = MakeTetMesh(grid, MakeBlurredDrops(grid, 1), options, runtime, report);
    const double worst = WorstFragment(mesh, report);
    std::printf("%s: %lld drops, off by at most %.1e, dihedral angles from %.1f degrees\n",
      NameOf(method).c_str(), static_cast<long long>(report.NumberOfFragments), worst,
      report.MinimumDihedralAngle);
    EXPECT_LT(worst, 1e-6);
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
  }
}

TEST(FreeFragments, AreTheSameOnRanks)
{
  const CartesianGrid grid = MakeUnitGrid(PerAxis * Period);
  const FractionField field = MakeBlurredDrops(grid, 1);
  // Some cuts go through drops.
  CompareWithSerial(grid, field,
    { CutBox(grid.Global(), 2), CutBox(grid.Global(), 3, 0), CutBox(grid.Global(), 8) },
    MeshOptions());
}
