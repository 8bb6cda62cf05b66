/// The share of each material that is in other blocks of cells than in the fractions.
#include "Geometry/DisplacedVolume.h"

#include "MeshChecks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns a slab of four layers of cells of one material.
FractionField MakeSlab(const CartesianGrid& grid, Index first, int material = 1)
{
  return MakeLabels(
    grid, 2, [=](const Index3& p) { return p[0] >= first && p[0] < first + 4 ? material : 0; });
}

TEST(DisplacedVolume, OfSlabs)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  MeshOptions options;
  options.StairStep = true;
  const Mesh mesh = MakeCells(grid, MakeSlab(grid, 4), options);
  Runtime runtime;
  const auto displaced = [&](const FractionField& fractions)
  { return FindDisplacedVolumes(grid, fractions, mesh, runtime); };
  EXPECT_EQ(displaced(MakeSlab(grid, 4))[1], 0.0);
  EXPECT_DOUBLE_EQ(displaced(MakeSlab(grid, 6))[1], 0.5); // half of it is a block further
  EXPECT_DOUBLE_EQ(displaced(MakeSlab(grid, 8))[1], 1.0);
  EXPECT_DOUBLE_EQ(displaced(MakeSlab(grid, 4, 2))[2], 1.0); // it has no elements
  EXPECT_EQ(displaced(MakeSlab(grid, 4, 2))[1], 0.0);        // it is in no cell
}

} // namespace
