/// The part of a solid in the cells of a row, from the pieces of its surface.
#include "Surfaces/RowSums.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

const std::vector<double> Nodes{ 0.0, 1.0, 3.0, 4.0, 5.0 };

/// Returns a square over the whole row whose x are given at its corners, which faces +x.
CutPolygon Square(const std::array<double, 4>& x)
{
  CutPolygon polygon;
  polygon.Size = 4;
  for (int i = 0; i < 4; ++i)
  {
    polygon.Corners[i] = { { x[i], i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0 } };
  }
  return polygon;
}

CutPolygon Reversed(CutPolygon polygon)
{
  std::reverse(polygon.Corners.begin(), polygon.Corners.begin() + polygon.Size);
  return polygon;
}

std::vector<double> Fractions(const std::vector<CutPolygon>& pieces, Index first = 0)
{
  RowSums sums(Nodes, first);
  std::vector<double> fractions(4 - first);
  for (int run = 0; run < 2; ++run) // the second one uses cleared sums
  {
    for (const CutPolygon& piece : pieces)
    {
      sums.Add(piece);
    }
    sums.Finish(4 - first, fractions.data());
  }
  return fractions;
}

} // namespace

TEST(RowSums, CellsThatAnIntervalMeets)
{
  const auto expect = [](double low, double high, Index first, Index last)
  {
    const CellSpan cells = FindCells(Nodes, { low, high });
    EXPECT_EQ(cells.First, first);
    EXPECT_EQ(cells.Last, last);
  };
  expect(0.5, 0.6, 0, 0);
  expect(0.5, 3.5, 0, 2);
  expect(1.0, 3.0, 1, 1);
  expect(1.0, 1.0, 1, 0);
  expect(5.0, 5.0, 4, 3);
  expect(-1.0, 7.0, -1, 4);
  expect(-1.0, 0.0, -1, -1);
  expect(6.0, 7.0, 4, 4);
}

TEST(RowSums, SlabsOfMaterial)
{
  const CutPolygon end = Square({ { 3.5, 3.5, 3.5, 3.5 } });
  EXPECT_EQ(Fractions({}), (std::vector<double>{ 0, 0, 0, 0 }));
  EXPECT_EQ(Fractions({ end }), (std::vector<double>{ 1, 1, 0.5, 0 }));
  EXPECT_EQ(Fractions({ end }, 1), (std::vector<double>{ 1, 0.5, 0 }));
  EXPECT_EQ(Fractions({ end, Reversed(Square({ { 2, 2, 2, 2 } })) }),
    (std::vector<double>{ 0, 0.5, 0.5, 0 }));
  EXPECT_EQ(Fractions({ Reversed(Square({ { 2, 2, 2, 2 } })), Square({ { 9, 9, 9, 9 } }) }),
    (std::vector<double>{ 0, 0.5, 1, 1 }));
  EXPECT_EQ(Fractions({ Square({ { -1, -1, -1, -1 } }) }), (std::vector<double>{ 0, 0, 0, 0 }));
}

TEST(RowSums, FacesBetweenCellsCutNone)
{
  const CutPolygon end = Square({ { 3, 3, 3, 3 } }), begin = Reversed(Square({ { 1, 1, 1, 1 } }));
  EXPECT_EQ(Fractions({ begin, end }), (std::vector<double>{ 0, 1, 0, 0 }));
  EXPECT_EQ(Fractions({ begin, Square({ { 5, 5, 5, 5 } }) }), (std::vector<double>{ 0, 1, 1, 1 }));
}

TEST(RowSums, SlopesAcrossCells)
{
  // The plane x = 5 y: the mean over each cell, integrated by hand.
  const std::vector<double> found = Fractions({ Square({ { 0, 5, 5, 0 } }) });
  const double expected[4] = { 0.9, 0.6, 0.3, 0.1 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-15) << i;
  }
}

TEST(RowSums, OverlapsCountOnce)
{
  const CutPolygon first = Square({ { 4, 4, 4, 4 } }), second = Square({ { 2, 2, 2, 2 } });
  EXPECT_EQ(Fractions({ first, second }), (std::vector<double>{ 1, 1, 1, 0 }));
}

/// Triangles much larger than cells leave gaps by rounding.
TEST(RowSums, GapsDoNotReachUncutCells)
{
  CutPolygon end = Square({ { 3.5, 3.5, 3.5, 3.5 } });
  end.Corners[1][1] = end.Corners[2][1] = 1.0 - 1e-6;
  const std::vector<double> found = Fractions({ end });
  EXPECT_EQ(found[0], 1.0);
  EXPECT_EQ(found[1], 1.0);
  EXPECT_NEAR(found[2], 0.5, 1e-6);
  EXPECT_EQ(found[3], 0.0);
}
