/// Parts of cells that bodies share, and the fraction of the later body.
#include "Surfaces/SharedCells.h"

#include "SurfaceCases.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const std::vector<double> Nodes{ 0.0, 1.0, 3.0, 4.0 };

void AddBody(const ClosedSurface& surface, int body, RowRays& rays)
{
  for (const Triangle& triangle : PlaceTriangles(surface))
  {
    CutPolygon polygon;
    polygon.Size = 3;
    std::copy(triangle.begin(), triangle.end(), polygon.Corners.begin());
    rays.Add(polygon, body);
  }
}

void ExpectParts(const SharedCell& cell, const std::array<double, 4>& parts)
{
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(cell.Parts[i], parts[i], 1e-12) << "cell " << cell.Cell << " part " << i;
  }
}

} // namespace

TEST(SharedCells, PartsOfBoxesAcrossTheRow)
{
  RowRays rays;
  for (int run = 0; run < 2; ++run) // the second one uses cleared rays
  {
    rays.Begin({ 2.0, 3.0 }, { 5.0, 7.0 });
    AddBody(BoxSurface({ { -9, 0, 0 } }, { { 2.0, 9, 9 } }), 0, rays);
    AddBody(BoxSurface({ { 0.25, 0, 0 } }, { { 2.5, 9, 9 } }, 3), 1, rays);
    AddBody(BoxSurface({ { 0.5, 0, 0 } }, { { 3.5, 9, 9 } }), 2, rays);
    AddBody(BoxSurface({ { -9, 8, 0 } }, { { 9, 9, 9 } }), 0, rays); // beside the row
    std::vector<SharedCell> cells{ { 0, 2 }, { 1, 1 }, { 1, 2 } };
    rays.Measure(Nodes, cells);
    ExpectParts(cells[0], { { 0.0, 0.5, 0.0, 0.5 } });
    ExpectParts(cells[1], { { 0.25, 0.0, 0.25, 0.5 } });
    ExpectParts(cells[2], { { 0.0, 0.0, 0.25, 0.75 } });
  }
}

/// Rays meet each corner and edge of the surface on one side.
TEST(SharedCells, NoRayPassesBetweenTriangles)
{
  RowRays rays;
  for (int parts : { 1, 2, 3, 5, 11, 22 }) // rays lie on corners of some of them
  {
    rays.Begin({ 0.0, 1.0 }, { 0.0, 1.0 });
    AddBody(BoxSurface({ { -9, 0, 0 } }, { { 9, 1, 1 } }, parts), 0, rays);
    AddBody(BoxSurface({ { -9, -1, -1 } }, { { 9, 2, 2 } }, parts), 1, rays);
    std::vector<SharedCell> cells{ { 1, 1 } };
    rays.Measure(Nodes, cells);
    ExpectParts(cells[0], { { 0.0, 0.0, 0.0, 1.0 } });
  }
}

TEST(SharedCells, FractionsOfLaterBodies)
{
  // Where rays see no overlap, all stays.
  EXPECT_EQ(FractionBesideEarlier(0.4, 0.3, { { 0.3, 0.4, 0.3, 0.0 } }), 0.3);
  EXPECT_EQ(FractionBesideEarlier(0.4, 0.6, { { 1e-16, 0.4, 0.6, 1e-16 } }), 0.6);
  // One inside of the other: the difference of the exact fractions, which rays do not change.
  EXPECT_EQ(FractionBesideEarlier(0.25, 0.75, { { 0.3, 0.0, 0.5, 0.2 } }), 0.5);
  EXPECT_EQ(FractionBesideEarlier(0.75, 0.75, { { 0.3, 0.0, 0.0, 0.7 } }), 0.0);
  EXPECT_EQ(FractionBesideEarlier(0.75, 0.25, { { 0.3, 0.5, 0.0, 0.2 } }), 0.0);
  // They fill the cell.
  EXPECT_NEAR(FractionBesideEarlier(0.75, 0.5, { { 0.0, 0.5, 0.3, 0.2 } }), 0.25, 1e-15);
  // Parts that agree with the fractions stay.
  EXPECT_NEAR(FractionBesideEarlier(0.5, 0.4, { { 0.3, 0.3, 0.2, 0.2 } }), 0.2, 1e-15);
  EXPECT_NEAR(FractionBesideEarlier(0.7, 0.6, { { 0.1, 0.3, 0.2, 0.4 } }), 0.2, 1e-15);
  EXPECT_NEAR(FractionBesideEarlier(0.5, 0.5, { { 0.25, 0.25, 0.25, 0.25 } }), 0.25, 1e-15);
  // No ray meets them.
  EXPECT_EQ(FractionBesideEarlier(1e-4, 3e-4, { { 1.0, 0.0, 0.0, 0.0 } }), 3e-4 - 1e-4);
}
