/// Tets of all lattice tets and all patterns of their labels.
#include "Elements/Tet/LatticeStencils.h"
#include "Base/Vector3.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Returns the mean of the nodes of a set, in cells.
Vector3 PointOfSet(const LatticeTet& tet, int set)
{
  Vector3 sum{};
  int count = 0;
  for (int n = 0; n < 4; ++n)
  {
    if (set >> n & 1)
    {
      const HalfPoint& node = tet.Nodes[n];
      sum = sum + Vector3{ { 0.5 * node[0], 0.5 * node[1], 0.5 * node[2] } };
      ++count;
    }
  }
  return (1.0 / count) * sum;
}

double VolumeOf(const std::array<Vector3, 4>& p)
{
  return Dot(Cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6.0;
}

/// Returns the volumes of the regions of a stencil, by their first nodes.
std::array<double, 4> RegionVolumes(const LatticeTet& tet, const LatticeStencil& stencil)
{
  std::array<double, 4> volumes{};
  for (int r = 0; r < stencil.Count; ++r)
  {
    const LatticeStencil::Region& region = stencil.List[r];
    std::uint32_t points = 0;
    for (int t = region.First; t < region.Last; ++t)
    {
      std::array<Vector3, 4> corners;
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = PointOfSet(tet, stencil.Tets[t][c]);
        points |= 1u << stencil.Tets[t][c];
      }
      EXPECT_GT(VolumeOf(corners), 1e-6);
      volumes[region.Node] += VolumeOf(corners);
    }
    EXPECT_EQ(points, region.Points);
  }
  return volumes;
}

} // namespace

TEST(LatticeStencils, TetsFillEachShapeForAllLabels)
{
  const LatticeTables& tables = LatticeTables::Get();
  for (int shape = 0; shape < LatticeTables::Shapes; ++shape)
  {
    const LatticeTet& tet = tables.Shape(shape);
    const double whole = VolumeOf(
      { { PointOfSet(tet, 1), PointOfSet(tet, 2), PointOfSet(tet, 4), PointOfSet(tet, 8) } });
    ASSERT_GT(whole, 0.0);
    for (int code = 1; code < 625; ++code)
    {
      const std::array<int, 4> labels{ { code % 5 - 1, code / 5 % 5 - 1, code / 25 % 5 - 1,
        code / 125 - 1 } };
      const LatticeStencil& stencil = tables.Stencil(shape, labels);
      const std::array<double, 4> volumes = RegionVolumes(tet, stencil);
      double sum = 0.0;
      for (int n = 0; n < 4; ++n)
      {
        const bool isFirst = labels[n] >= 0 &&
          std::find(labels.begin(), labels.begin() + n, labels[n]) == labels.begin() + n;
        ASSERT_EQ(volumes[n] > 0.0, isFirst) << shape << " " << code;
        sum += volumes[n];
      }
      ASSERT_NEAR(sum, whole, 1e-12) << shape << " " << code;
    }
  }
}

TEST(LatticeStencils, PointsStartAtTheMeansOfTheirNodes)
{
  const std::vector<double> x{ 0, 1, 2, 3, 4, 5, 6, 7, 8 };
  const CartesianGrid grid(std::array<std::vector<double>, 3>{ { x, x, x } });
  const Index3 block{ { 4, 4, 4 } };
  const LatticeTables& tables = LatticeTables::Get();
  for (int shape = 0; shape < LatticeTables::Shapes; ++shape)
  {
    const LatticeTet& tet = tables.Shape(shape);
    for (int set = 1; shape % 12 < 4 && set < 16; ++set)
    {
      Index3 at = block;
      for (int a = 0; a < 3; ++a)
      {
        at[a] += tet.Block[set][a];
      }
      const Vector3 right = Vector3{ { 4, 4, 4 } } + PointOfSet(tet, set);
      ASSERT_NEAR(Norm(tables.StartOf(grid, at, tet.Slot[set]) - right), 0.0, 1e-14)
        << shape << " " << set;
    }
  }
}
