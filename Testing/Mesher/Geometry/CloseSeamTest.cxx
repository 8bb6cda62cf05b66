/// Points on opposite sides of a periodic mesh.
#include "Geometry/CloseSeam.h"
#include "CellMesh.h"
#include "Elements/PeriodicIds.h"
#include "RandomDraw.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

/// Every rank moves the points on seams and beyond in its own way. Then all copies of a point are
/// translates, of the position that its owner has.
TEST(CloseSeam, CopiesAreTranslates)
{
  const std::vector<double> x{ 0.0, 1.0, 1.5, 3.0, 4.0 };
  RunOnRanks(2,
    [&x](Ranks& ranks)
    {
      const Index first = 2 * ranks.Rank();
      const CartesianGrid grid = CartesianGrid::Covering({ { x, { 0.0, 1.0, 2.5, 3.0 }, x } },
        { { { first, 0, 0 } }, { { first + 2, 3, 4 } } }, { { true, false, true } }, Seam::Free, 3);
      const Partition partition(grid, ranks);
      Mesh mesh = MakeCellMesh(grid, ranks, [](const Index3&) { return 1; });
      for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
      {
        const bool isCopied = HasCopies(grid, NodeOfPoint(grid, mesh, mesh.PointIds[p]));
        RandomDraw random(static_cast<unsigned>(mesh.PointIds[p]) + (isCopied ? ranks.Rank() : 0));
        for (int a = 0; a < 3; ++a)
        {
          mesh.Points[3 * p + a] += std::ldexp(random.Whole(-100, 100), -12); // sums stay exact
        }
      }
      const std::vector<double> before(mesh.Points.begin(), mesh.Points.end());
      CloseSeam(partition, mesh);
      std::map<Index3, Vector3> copies; // of canonical nodes
      for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
      {
        const Index3 node = NodeOfPoint(grid, mesh, mesh.PointIds[p]);
        const Index3 owned = grid.CanonicalNode(node);
        Vector3 at = mesh.PointAt(static_cast<Index>(p));
        for (int a : { 0, 2 })
        {
          at[a] -= static_cast<double>(node[a] - owned[a]); // a period has 4 cells and the length 4
        }
        EXPECT_EQ(copies.emplace(owned, at).first->second, at);
        if (partition.OwnsNode(node))
        {
          for (int a = 0; a < 3; ++a)
          {
            EXPECT_EQ(mesh.PointAt(static_cast<Index>(p))[a], before[3 * p + a]);
          }
        }
      }
      EXPECT_LT(copies.size(), mesh.PointIds.size());
    });
}
