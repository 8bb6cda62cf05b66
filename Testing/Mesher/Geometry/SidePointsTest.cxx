/// Smooth sides of an interface with edges.
#include "Geometry/SidePoints.h"
#include "CellMesh.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// A block of 3^3 cells of material 2, from node 2 to node 5 along each axis.
int MaterialOf(const Index3& cell)
{
  return std::all_of(cell.begin(), cell.end(), [](Index i) { return i >= 2 && i < 5; }) ? 2 : 1;
}

/// Returns on how many sides of the block a point is, and the number of one of them.
int CountSides(const Vector3& x, int& side)
{
  int count = 0;
  for (int a = 0; a < 3; ++a)
  {
    if (x[a] < 2.0 || x[a] > 5.0)
    {
      return 0;
    }
    if (x[a] == 2.0 || x[a] == 5.0)
    {
      ++count;
      side = 2 * a + (x[a] == 5.0);
    }
  }
  return count;
}

std::vector<Facet> ListFacetsOf(const Mesh& mesh)
{
  std::vector<Facet> facets;
  for (std::size_t f = 0; f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    const int* pair = mesh.Surfaces.MaterialPair.data() + 2 * f;
    Facet facet{ {}, { { pair[1], pair[0] } }, { { pair[1], pair[0] } },
      mesh.Surfaces.DomainSide[f], mesh.Surfaces.IsOwned[f] != 0 };
    std::copy_n(mesh.Surfaces.Points.data() + 4 * f, 4, facet.Points.begin());
    facets.push_back(facet);
  }
  return facets;
}

} // namespace

TEST(SidePoints, OfABlock)
{
  const CartesianGrid whole = MakeUnitGrid(7);
  for (int count : { 1, 2 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count, 0);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        const Partition partition(grid, ranks);
        const Mesh mesh = MakeCellMesh(grid, ranks, MaterialOf);
        const std::vector<Facet> facets = ListFacetsOf(mesh);
        int side = -1;
        std::vector<FeatureKind> kinds;
        for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
        {
          const int sides = CountSides(mesh.PointAt(static_cast<Index>(p)), side);
          kinds.push_back(sides == 3 ? FeatureKind::Corner
              : sides == 2           ? FeatureKind::Edge
                                     : FeatureKind::None);
        }
        const SidePoints found = FindSidePoints(facets, kinds, mesh, partition);
        EXPECT_EQ(found.NumberOfSides, 6);
        for (std::size_t f = 0; f < facets.size(); ++f)
        {
          EXPECT_EQ(found.CutOf[f], facets[f].DomainSide < 0 ? 0 : -1);
          if (facets[f].DomainSide < 0)
          {
            const Vector3 normal = NormalOf(mesh, facets[f]);
            const Vector3 x =
              0.5 * (mesh.PointAt(facets[f].Points[0]) + mesh.PointAt(facets[f].Points[2]));
            CountSides(x, side);
            EXPECT_EQ(normal[side / 2], side % 2 ? 1.0 : -1.0); // to the smaller fragment
          }
        }
        // By the lowest points: z is 2, then y, x, and so on.
        const std::map<int, int> numbers{ { 4, 1 }, { 2, 2 }, { 0, 3 }, { 1, 4 }, { 3, 5 },
          { 5, 6 } };
        for (std::size_t p = 0; p < found.SideOf.size(); ++p)
        {
          const bool isInside = CountSides(mesh.PointAt(static_cast<Index>(p)), side) == 1;
          EXPECT_EQ(found.SideOf[p], isInside ? numbers.at(side) : 0);
        }
        const SidePoints none = FindSidePoints(facets, {}, mesh, partition);
        EXPECT_EQ(none.NumberOfSides, 0);
        EXPECT_EQ(*std::max_element(none.SideOf.begin(), none.SideOf.end()), 0);
        EXPECT_EQ(*std::max_element(none.CutOf.begin(), none.CutOf.end()), -1);
      });
  }
}
