/// Parts of elements in cells.
#include "State/Transfer/DonorParts.h"
#include "CellMesh.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// The hexes of a grid, moved by a quarter of a cell along x, as far as a rank owns them.
Mesh MakeShiftedMesh(const CartesianGrid& grid, Ranks& ranks)
{
  Mesh mesh = MakeCellMesh(
    CartesianGrid(grid, grid.Owned(), 0, 0), ranks, [](const Index3& p) { return 1 + (p[1] > 0); });
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    mesh.Points[3 * p] += 0.25;
  }
  return mesh;
}

} // namespace

/// Each hex has 3/4 of its volume in its own cell and 1/4 in the next one, which may be on another
/// rank. The hexes at the end of the grid are not cut.
TEST(DonorParts, OfShiftedHexes)
{
  const CartesianGrid whole = MakeUnitGrid(8, 2, 1);
  for (int count : { 1, 2 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count, 0);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        RankRuntime runtime(ranks);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()], { GhostLayers, 0 });
        const Partition partition(grid, ranks);
        const Mesh mesh = MakeShiftedMesh(grid, ranks);
        const RegularTets regular(mesh, grid, runtime);
        const auto cellOf = [&](Index e) { return CellOfElement(grid, mesh, mesh.ElementIds[e]); };
        DonorTable donors(grid);
        DonorShapes shapes;
        const std::vector<DonorParts> pieces = FindDonorParts(
          mesh, [&](Index e) { return cellOf(e)[0] < 7; }, grid, regular, partition, runtime,
          donors, shapes);
        std::size_t elements = 0;
        for (const DonorParts& some : pieces)
        {
          for (std::size_t i = 0; i < some.Elements.size(); ++i, ++elements)
          {
            const Index e = some.ElementAt(i);
            const Index3 cell = cellOf(e);
            ASSERT_EQ(some.Offsets[i + 1] - some.Offsets[i], 2);
            for (int n = some.Offsets[i]; n < some.Offsets[i + 1]; ++n)
            {
              const DonorPart& part = some.Parts[n];
              const Donor& donor = donors[part.Donor];
              const Index3 at = grid.Position(donor.Cell);
              const bool isOwn = at == cell;
              EXPECT_EQ(at[0], cell[0] + !isOwn);
              EXPECT_NEAR(part.Volume, isOwn ? 0.75 : 0.25, 1e-14);
              EXPECT_NEAR(
                part.Centroid[0], static_cast<double>(at[0]) + (isOwn ? 0.625 : 0.125), 1e-14);
              EXPECT_NEAR(part.Centroid[1], static_cast<double>(cell[1]) + 0.5, 1e-14);
              EXPECT_EQ(donor.Material, mesh.Material[e]);
              EXPECT_EQ(donor.HasParts, !donor.IsOwned);
            }
          }
        }
        EXPECT_EQ(elements, mesh.ElementIds.size() - (ranks.Rank() == count - 1 ? 2 : 0));
        CentreShapes(donors, shapes);
        int owned = 0;
        for (int s = 0; s < donors.Count(); ++s)
        {
          if (!donors[s].IsOwned)
          {
            continue;
          }
          ++owned;
          const Index i = grid.Position(donors[s].Cell)[0];
          // Cell 0 has one part, cell 7 the end of another, and the others have both.
          const double right = i < 7 ? 0.75 : 0.0, left = i > 0 ? 0.25 : 0.0, all = left + right;
          const double mean = (0.625 * right + 0.125 * left) / all;
          EXPECT_NEAR(donors[s].Overlap, all, 1e-14);
          EXPECT_NEAR(donors[s].Centroid[0], static_cast<double>(i) + mean, 1e-14);
          const double second = 0.625 * 0.625 * right + 0.125 * 0.125 * left - all * mean * mean;
          EXPECT_NEAR(shapes[s].Second[0], second, 1e-14);
          EXPECT_NEAR(shapes[s].Lower[0], (i > 0 ? 0.125 : 0.625) - mean, 1e-14);
          EXPECT_NEAR(shapes[s].Upper[0], (i < 7 ? 0.625 : 0.125) - mean, 1e-14);
          EXPECT_NEAR(shapes[s].Upper[2], 0.0, 1e-14);
        }
        EXPECT_EQ(owned, static_cast<int>(grid.Owned().NumberOfCells()));
      });
  }
}
