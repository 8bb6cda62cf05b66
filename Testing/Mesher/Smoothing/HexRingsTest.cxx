/// Rings of points around the points of hexes.
#include "Smoothing/HexRings.h"
#include "Base/Vector3.h"
#include "Smoothing/ActiveMesh.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;

namespace
{

/// Hexes of 4 x 3 x 3 cells; the inner points move and have the first numbers.
ActiveMesh MakeCells()
{
  const IndexBox nodes{ {}, { { 5, 4, 4 } } }, cells{ {}, { { 4, 3, 3 } } };
  const IndexBox inner{ { { 1, 1, 1 } }, { { 4, 3, 3 } } };
  ActiveMesh mesh;
  std::vector<int> numbers(nodes.NumberOfCells(), -1);
  for (bool isInner : { true, false })
  {
    ForCells(nodes,
      [&](const Index3& p)
      {
        if (inner.Contains(p) == isInner)
        {
          numbers[IndexInBox(nodes, p)] = static_cast<int>(mesh.X.size());
          mesh.X.push_back({ { 1.0 * p[0], 1.0 * p[1], 1.0 * p[2] } });
          mesh.IsActive.push_back(isInner);
        }
      });
  }
  ForCells(cells,
    [&](const Index3& cell)
    {
      for (int c = 0; c < 8; ++c)
      {
        mesh.Elements.push_back(numbers[IndexInBox(nodes, CornerOfCell(cell, c))]);
      }
      mesh.Demands.push_back(cell[0] == 0 ? BarrierDemand : 1.0f);
    });
  mesh.Widths = { { { 1.0, 1.0, 1.0 } } };
  mesh.ListCorners();
  return mesh;
}

} // namespace

TEST(HexRings, HoldThePointsAndFramesOfHexes)
{
  const ActiveMesh mesh = MakeCells();
  Runtime runtime;
  const HexRings rings(mesh, runtime);
  for (int p = 0; p < 3 * 2 * 2; ++p)
  {
    const Vector3& x = mesh.X[p];
    const HexRings::Ring ring = rings.PointsAt(p);
    ASSERT_EQ(ring.Count, 26);
    EXPECT_EQ(ring.Near, 6 + 12); // ends of edges, and of diagonals of faces
    std::set<int> points;
    for (int n = 0; n < ring.Count; ++n)
    {
      points.insert(ring[n]);
      const Vector3 way = mesh.X[ring[n]] - x;
      EXPECT_LE(std::max({ std::fabs(way[0]), std::fabs(way[1]), std::fabs(way[2]) }), 1.0);
      EXPECT_EQ(Dot(way, way) == 3.0, n >= ring.Near);
    }
    EXPECT_EQ(points.size(), 26u);
    EXPECT_EQ(rings.HasDemands(p), x[0] == 1.0);
    for (CornerPosition n = 0; n < mesh.CornerOffset[p + 1] - mesh.CornerOffset[p]; ++n)
    {
      const HexRings::Hex& hex = rings.HexesAt(p)[n];
      const int corner = static_cast<int>(mesh.CornerList[mesh.CornerOffset[p] + n] % 8);
      std::array<Vector3, 6> ways;
      for (int e = 0; e < 6; ++e)
      {
        ways[e] = mesh.X[ring[hex.Ends[e]]] - x;
      }
      EXPECT_EQ(Dot(Cross(ways[0], ways[1]), ways[2]), 1.0);
      EXPECT_EQ(ways[3], ways[0] + ways[1]);
      EXPECT_EQ(ways[4], ways[1] + ways[2]);
      EXPECT_EQ(ways[5], ways[2] + ways[0]);
      EXPECT_EQ(ways[hex.IsExchanged ? 1 : 0][0], corner & 1 ? -1.0 : 1.0);
      EXPECT_EQ(ways[2][2], corner & 4 ? -1.0 : 1.0);
    }
  }
}

/// Points with equal stars of hexes share one list.
TEST(HexRings, EqualListsAreStoredOnce)
{
  const ActiveMesh mesh = MakeCells();
  Runtime runtime;
  const HexRings rings(mesh, runtime);
  EXPECT_EQ(rings.HexesAt(0), rings.HexesAt(11));
  EXPECT_TRUE(HexRings().IsEmpty());
  EXPECT_FALSE(rings.IsEmpty());
}
