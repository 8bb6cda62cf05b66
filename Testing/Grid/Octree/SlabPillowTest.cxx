/// Hexes of one level of refined cells.
#include "Octree/SlabPillow.h"
#include "Base/HexNumbering.h"
#include "Base/HexVolume.h"
#include "MeshChecks.h"
#include "RefinedChecks.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

double VolumeOf(const PillowedLevel& level, const PillowedLevel::Hex& hex)
{
  std::array<Vector3, 8> x;
  for (int c = 0; c < 8; ++c)
  {
    x[VtkCorner[c]] = level.Nodes[hex.Nodes[c]].X;
  }
  return VolumeBetween({ { x[0], x[1], x[2], x[3] } }, { { x[4], x[5], x[6], x[7] } });
}

Index CountRefinedAxes(const Index3& cell)
{
  return std::count_if(cell.begin(), cell.end(), [](Index i) { return i == 2 || i == 3; });
}

} // namespace

/// One family is refined, in the middle of 6^3 cells: cells 2 and 3 along each axis.
TEST(SlabPillow, OneFamily)
{
  const RefinedCase c = MakeFamilyCase(
    "middle", { { 6, 6, 6 } }, [](const Index3& q) { return q[0] == 1 && q[1] == 1 && q[2] == 1; });
  const OctantFamilies sets(*c.Lattice, c.Requested);
  const PillowedLevel level = PillowSlabs(sets, 0, c.Grid->Global());
  // 8 refined cells, 24 that share a face with them and 24 that share an edge.
  ASSERT_EQ(level.Cells.size(), 8u + 24u + 24u);
  std::vector<double> volumes(level.Cells.size(), 0.0);
  std::vector<int> hexes(level.Cells.size(), 0), children(level.Cells.size(), 0);
  std::map<std::array<int, 4>, int> faces;
  for (const PillowedLevel::Hex& hex : level.Hexes)
  {
    const double volume = VolumeOf(level, hex);
    EXPECT_GT(volume, 0.0);
    volumes[hex.Cell] += volume;
    ++hexes[hex.Cell];
    const Index3& cell = level.Cells[hex.Cell];
    if (CountRefinedAxes(cell) == 3)
    {
      const int child = ChildOfHex(cell, hex.Slot);
      children[hex.Cell] |= 1 << child;
      EXPECT_NEAR(volume, 0.125, 1e-14);
      for (int n = 0; n < 8; ++n)
      {
        for (int a = 0; a < 3; ++a)
        {
          EXPECT_EQ(level.Nodes[hex.Nodes[n]].X[a],
            static_cast<double>(cell[a]) + 0.5 * ((child >> a & 1) + (n >> a & 1)));
        }
      }
    }
    for (const std::array<int, 4>& corners : FaceCorners)
    {
      std::array<int, 4> face;
      std::transform(
        corners.begin(), corners.end(), face.begin(), [&hex](int n) { return hex.Nodes[n]; });
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  double total = 0.0;
  for (std::size_t n = 0; n < level.Cells.size(); ++n)
  {
    const Index refined = CountRefinedAxes(level.Cells[n]);
    EXPECT_EQ(children[n], refined == 3 ? 255 : 0);
    // SlabPillow.h has the numbers of transition hexes.
    EXPECT_EQ(hexes[n], refined == 3 ? 8 : refined == 2 ? 7 : 4);
    total += volumes[n];
  }
  EXPECT_NEAR(total, 56.0, 1e-12);
  // The boundary has no hanging nodes: it is whole faces of 4x4x4 cells without the 8 corners.
  Index outside = 0;
  for (const auto& face : faces)
  {
    ASSERT_LE(face.second, 2);
    outside += face.second == 1;
  }
  EXPECT_EQ(outside, 6 * 16);
}

/// The part in a box has the nodes of the whole.
TEST(SlabPillow, BoxesMakePartsOfTheWhole)
{
  const RefinedCase c = MakeRandomCase({ { 8, 8, 8 } }, 1, 0.1, 3);
  const OctantFamilies sets(*c.Lattice, c.Requested);
  const auto list = [](const PillowedLevel& level, const IndexBox& box)
  {
    std::map<std::pair<Index3, int>, std::vector<Vector3>> hexes;
    for (const PillowedLevel::Hex& hex : level.Hexes)
    {
      if (box.Contains(level.Cells[hex.Cell]))
      {
        std::vector<Vector3>& x = hexes[{ level.Cells[hex.Cell], hex.Slot }];
        for (int n : hex.Nodes)
        {
          x.push_back(level.Nodes[n].X);
        }
      }
    }
    return hexes;
  };
  const IndexBox box{ { { 2, 3, 0 } }, { { 6, 8, 4 } } };
  const auto part = list(PillowSlabs(sets, 0, box), box);
  EXPECT_GT(part.size(), 100u);
  EXPECT_EQ(part, list(PillowSlabs(sets, 0, c.Grid->Global()), box));
}
