/// The share of each material that is in other blocks of cells than in the fractions.
#include "Geometry/DisplacedVolume.h"

#include "Base/HexVolume.h"
#include "Geometry/ElementParts.h"

#include "MeshChecks.h"
#include "RandomDraw.h"

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

/// Moves the points of a mesh along x by a length.
void Shift(Mesh& mesh, double length)
{
  for (std::size_t n = 0; n < mesh.Points.size(); n += 3)
  {
    mesh.Points[n] += length;
  }
}

TEST(DisplacedVolume, OfElementsInSeveralBlocks)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  const FractionField slab = MakeSlab(grid, 4);
  MeshOptions options;
  options.StairStep = true;
  Mesh mesh = MakeCells(grid, slab, options);
  Runtime runtime;
  for (double shift : { 0.25, 0.5, 0.75 })
  {
    Shift(mesh, 0.25);
    EXPECT_NEAR(FindDisplacedVolumes(grid, slab, mesh, runtime)[1], shift / 4.0, 1e-12) << shift;
  }
}

TEST(DisplacedVolume, PartsFillElements)
{
  RandomDraw draw(5);
  std::array<Vector3, 8> x;
  for (int c = 0; c < 8; ++c)
  {
    const int n = c ^ (c >> 1 & 1);
    x[c] =
      Vector3{ { 1.0 * (n & 1), 1.0 * (n >> 1 & 1), 1.0 * (n >> 2) } } + draw.Vector(-0.2, 0.2);
  }
  double sum = 0.0;
  for (const std::array<Vector3, 8>& part : DivideHex(x))
  {
    EXPECT_GT(VolumeOfHex(part), 0.05);
    sum += VolumeOfHex(part);
  }
  EXPECT_NEAR(sum, VolumeOfHex(x), 1e-14);
  const auto volumeOfTet = [](const std::array<Vector3, 8>& t)
  { return std::abs(Dot(t[1] - t[0], Cross(t[2] - t[0], t[3] - t[0]))) / 6.0; };
  Vector3 middle{};
  for (const std::array<Vector3, 8>& part : DivideTet(x))
  {
    EXPECT_NEAR(volumeOfTet(part), volumeOfTet(x) / 8.0, 1e-15);
    middle = middle + (1.0 / 32.0) * (part[0] + part[1] + part[2] + part[3]);
  }
  EXPECT_LT(Norm(middle - 0.25 * (x[0] + x[1] + x[2] + x[3])), 1e-14);
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
