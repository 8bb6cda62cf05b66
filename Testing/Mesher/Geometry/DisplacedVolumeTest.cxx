/// The share of each material that is in other blocks of cells than in the fractions.
#include "Geometry/DisplacedVolume.h"

#include "MeshChecks.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// The block of an element does not depend on the elements before it.
TEST(DisplacedVolume, DoesNotDependOnTheOrderOfElements)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  const FractionField slab = MakeSlab(grid, 4);
  MeshOptions options;
  options.StairStep = true;
  Mesh mesh = MakeCells(grid, slab, options);
  for (std::size_t n = 0; n < mesh.Points.size(); n += 3)
  {
    mesh.Points[n] = 4.0 + 0.01 * (mesh.Points[n] - 6.0); // at the plane between two blocks
  }
  Runtime runtime;
  const double displaced = FindDisplacedVolumes(grid, slab, mesh, runtime)[1];
  EXPECT_NEAR(displaced, 0.995, 1e-12); // half of the elements are in the block of the slab
  const auto count = static_cast<Index>(mesh.Material.size());
  for (Index e = 0; e < count / 2; ++e)
  {
    Index* const corners = mesh.Elements.data();
    std::swap_ranges(corners + 8 * e, corners + 8 * (e + 1), corners + 8 * (count - 1 - e));
  }
  EXPECT_EQ(FindDisplacedVolumes(grid, slab, mesh, runtime)[1], displaced);
}

} // namespace
