#include "Surfaces/SharedCells.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Adds the side of a body across a row of unit height and depth.
void AddSide(double x, bool facesUp, int body, RowRays& rays)
{
  const Vector3 corners[4] = { { { x, 0, 0 } }, { { x, 1, 0 } }, { { x, 1, 1 } }, { { x, 0, 1 } } };
  for (int half : { 0, 1 })
  {
    CutPolygon triangle;
    triangle.Size = 3;
    triangle.Corners[0] = corners[0];
    triangle.Corners[facesUp ? 1 : 2] = corners[1 + half];
    triangle.Corners[facesUp ? 2 : 1] = corners[2 + half];
    rays.Add(triangle, body);
  }
}

} // namespace

TEST(SharedCells, PartsOfTwoSlabs)
{
  RowRays rays;
  rays.Begin({ 0.0, 1.0 }, { 0.0, 1.0 });
  AddSide(0.25, false, 0, rays);
  AddSide(1.5, true, 0, rays);
  AddSide(0.5, false, 1, rays);
  AddSide(1.75, true, 1, rays);
  std::vector<SharedCell> cells{ { 0, 1 }, { 1, 1 } };
  rays.Measure({ 0.0, 1.0, 2.0 }, cells);
  const std::array<double, 4> first{ { 0.25, 0.25, 0.0, 0.5 } }, second{ { 0.25, 0.0, 0.25, 0.5 } };
  for (int p = 0; p < 4; ++p)
  {
    EXPECT_NEAR(cells[0].Parts[p], first[p], 1e-12) << p;
    EXPECT_NEAR(cells[1].Parts[p], second[p], 1e-12) << p;
  }
  EXPECT_NEAR(FractionBesideEarlier(0.75, 0.5, cells[0].Parts), 0.0, 1e-12);
  EXPECT_NEAR(FractionBesideEarlier(0.5, 0.75, cells[1].Parts), 0.25, 1e-12);
  EXPECT_NEAR(FractionBesideEarlier(0.5, 0.3, { { 0.2, 0.5, 0.3, 0.0 } }), 0.3, 1e-12);
}
