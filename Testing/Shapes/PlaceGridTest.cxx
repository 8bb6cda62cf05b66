#include "Shapes/PlaceGrid.h"

#include "Ranks/Errors.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

const PlaceBounds Part{ { { 1.0, -1.0, 0.0 } }, { { 11.0, 3.0, 0.5 } } }; // 10 x 4 x 0.5

/// Checks that the cells lie centred around the part, with the margin.
void CheckAround(const GridPlace& place)
{
  for (int a = 0; a < 3; ++a)
  {
    const double end = place.Origin[a] + static_cast<double>(place.Cells[a]) * place.Widths[a];
    EXPECT_NEAR(place.Origin[a] + end, Part.Lower[a] + Part.Upper[a], 1e-12) << a;
    EXPECT_LE(place.Origin[a], Part.Lower[a] - 2.0 * place.Widths[a] + 1e-8) << a;
    EXPECT_GE(end, Part.Upper[a] + 2.0 * place.Widths[a] - 1e-8) << a;
  }
}

} // namespace

TEST(PlaceGrid, CubicCellsAlongTheLongestSide)
{
  const GridPlace place = PlaceCells(Part, 24);
  EXPECT_EQ(place.Cells, (Index3{ { 24, 12, 5 } }));
  EXPECT_EQ(place.Widths, (Vector3{ { 0.5, 0.5, 0.5 } }));
  EXPECT_EQ(place.Origin, (Vector3{ { 0.0, -2.0, -1.0 } }));
  CheckAround(place);
}

TEST(PlaceGrid, CubicCellsOfGivenNumbers)
{
  const GridPlace place = PlaceCells(Part, Index3{ { 64, 12, 32 } });
  EXPECT_EQ(place.Cells, (Index3{ { 64, 12, 32 } }));
  EXPECT_EQ(place.Widths, (Vector3{ { 0.5, 0.5, 0.5 } })); // y is the tightest
  CheckAround(place);
}

TEST(PlaceGrid, CellsOfGivenWidths)
{
  const GridPlace place = PlaceCellsOfWidth(Part, { { 0.5, 0.3, 0.6 } });
  EXPECT_EQ(place.Cells, (Index3{ { 24, 18, 5 } }));
  EXPECT_EQ(place.Widths, (Vector3{ { 0.5, 0.3, 0.6 } }));
  CheckAround(place);
}

TEST(PlaceGrid, NodesAreThoseOfTheCells)
{
  const auto nodes = ListNodes(PlaceCells(Part, 24));
  EXPECT_EQ(nodes[0].size(), 25u);
  EXPECT_EQ(nodes[2], (std::vector<double>{ -1.0, -0.5, 0.0, 0.5, 1.0, 1.5 }));
}

TEST(PlaceGrid, BoundsAreThoseOfAllTriangles)
{
  BodySurface one, other;
  one.Boundary.Points = { { { 9.0, 9.0, 9.0 } }, { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } },
    { { 0.0, 1.0, 0.0 } } };
  one.Boundary.Triangles = { { { 1, 2, 3 } } }; // point 0 belongs to no triangle
  other.Boundary.Points = { { { -1.0, 0.0, 0.0 } }, { { 0.0, 0.0, 2.0 } }, { { 0.0, 0.0, 1.0 } } };
  other.Boundary.Triangles = { { { 0, 1, 2 } } };
  const PlaceBounds bounds = FindBounds({ { one, other } });
  EXPECT_EQ(bounds.Lower, (Vector3{ { -1.0, 0.0, 0.0 } }));
  EXPECT_EQ(bounds.Upper, (Vector3{ { 1.0, 1.0, 2.0 } }));
}

TEST(PlaceGrid, WrongInputIsAnError)
{
  EXPECT_THROW(PlaceCells(Part, 4), InputError);
  EXPECT_THROW(PlaceCells(Part, Index3{ { 5, 5, 0 } }), InputError);
  EXPECT_THROW(PlaceCells({ Part.Lower, Part.Lower }, 32), InputError);
  EXPECT_THROW(
    PlaceCellsOfWidth({ Part.Lower, { { 1.0, NAN, 1.0 } } }, { { 1, 1, 1 } }), InputError);
  EXPECT_THROW(PlaceCellsOfWidth(Part, { { 1.0, 1.0, 1e-12 } }), InputError);
  EXPECT_THROW(FindBounds({}), InputError);
}

TEST(PlaceGrid, TooManyCellsAreAnError)
{
  EXPECT_THROW(PlaceCellsOfWidth(Part, { { 1e-7, 1.0, 1.0 } }), InputError);
  EXPECT_THROW(PlaceCellsOfWidth(Part, { { 1e-5, 1e-5, 1e-5 } }), InputError);
  EXPECT_THROW(PlaceCells(Part, 100000), InputError);
  EXPECT_THROW(PlaceCells(Part, Index3{ { 20000000, 5, 5 } }), InputError);
}
