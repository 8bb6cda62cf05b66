/// Linear values in donors.
#include "State/Transfer/Slopes.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Density, and a value per mass.
const StateColumns Columns({ { StateKind::PerVolume }, { StateKind::PerMass } }, 0);

/// A donor in each cell, with parts in its left and right half.
struct FullCells
{
  explicit FullCells(const CartesianGrid& grid) : Grid(grid), Donors(grid)
  {
    ForCells(grid.Global(),
      [this](const Index3& p)
      {
        Donor& donor = this->Donors[this->Donors.Get(this->Grid.Linear(p), 1, 1)];
        donor.Volume = donor.Overlap = this->Grid.CellVolume(p);
        const double quarter = 0.25 * this->Grid.Width(0, p[0]);
        DonorShape shape;
        shape.Second[0] = donor.Overlap * quarter * quarter;
        shape.Lower = { { -quarter, 0.0, 0.0 } };
        shape.Upper = { { quarter, 0.0, 0.0 } };
        this->Shapes.push_back(shape);
      });
  }
  template <class Value>
  void SetValues(int column, const Value& value)
  {
    for (int s = 0; s < this->Donors.Count(); ++s)
    {
      this->Values.Of(s)[column] = value(this->Donors[s].Centroid);
    }
  }
  Slopes FindSlopes()
  {
    const Partition partition(this->Grid, this->Run.Group());
    const DonorLinks links(this->Grid, partition, this->Donors);
    return Slopes(Columns, this->Grid, this->Donors, this->Values, this->Shapes, links, this->Run);
  }

  const CartesianGrid& Grid;
  Runtime Run;
  DonorTable Donors;
  DonorShapes Shapes;
  DonorValues Values{ static_cast<int>(Grid.Global().NumberOfCells()), Columns };
};

/// Returns a number of a line: 0 to 2 for slopes along x, y, z, 3 for the shift.
double LineOf(const Slopes& slopes, int donor, int column, int number)
{
  return slopes.LineOf(donor)[number * Columns.Width() + column];
}

} // namespace

/// Donors at the sides may have the extreme values of a corner, so only inner ones are compared.
TEST(Slopes, OfLinearValuesAreExact)
{
  const CartesianGrid grid = MakeUnevenGrid(4);
  FullCells cells(grid);
  cells.SetValues(0, [](const Vector3&) { return 2.0; });
  cells.SetValues(1, [](const Vector3& x) { return 5.0 + 3.0 * x[0] - 2.0 * x[1] + x[2]; });
  const Slopes slopes = cells.FindSlopes();
  const double gradient[] = { 3.0, -2.0, 1.0, 0.0 };
  int inner = 0;
  for (int s = 0; s < cells.Donors.Count(); ++s)
  {
    const Index3 p = grid.Position(cells.Donors[s].Cell);
    if (std::any_of(p.begin(), p.end(), [](Index i) { return i == 0 || i == 3; }))
    {
      continue;
    }
    ++inner;
    for (int n = 0; n < 4; ++n)
    {
      EXPECT_NEAR(LineOf(slopes, s, 1, n), gradient[n], 1e-12);
      EXPECT_EQ(LineOf(slopes, s, 0, n), 0.0);
    }
  }
  EXPECT_EQ(inner, 8);
}

/// At the largest value, no part may exceed it; elsewhere parts stay in the range around.
TEST(Slopes, KeepTheRangeOfNeighbours)
{
  const CartesianGrid grid = MakeUnitGrid(9, 1, 1);
  FullCells cells(grid);
  cells.SetValues(0, [](const Vector3&) { return 1.0; });
  const double values[9] = { 0, 0, 0, 1, 8, 9, 2, 2, 2 };
  cells.SetValues(1, [&](const Vector3& x) { return values[static_cast<int>(x[0])]; });
  const Slopes slopes = cells.FindSlopes();
  for (int s = 1; s < 8; ++s)
  {
    const double slope = LineOf(slopes, s, 1, 0);
    for (double end : { -0.25, 0.25 })
    {
      EXPECT_GE(values[s] + end * slope, std::min(values[s - 1], values[s + 1]) - 1e-12);
      EXPECT_LE(values[s] + end * slope, std::max({ values[s - 1], values[s], values[s + 1] }));
    }
  }
  EXPECT_EQ(LineOf(slopes, 1, 1, 0), 0.0);
  EXPECT_EQ(LineOf(slopes, 5, 1, 0), 0.0);
  // (9 - 1) / 2 fits between the neighbours of the cell with 8 only up to 9.
  EXPECT_NEAR(LineOf(slopes, 4, 1, 0), 4.0, 1e-12);
  EXPECT_NEAR(LineOf(slopes, 3, 1, 0), 4.0, 1e-12);
}

/// With slopes of both density and value, the sum of the parts keeps mass and content.
TEST(Slopes, KeepContents)
{
  const CartesianGrid grid = MakeUnevenGrid(5);
  FullCells cells(grid);
  cells.SetValues(0, [](const Vector3& x) { return 10.0 + x[0]; });
  cells.SetValues(1, [](const Vector3& x) { return 1.0 + 0.5 * x[0] + 0.1 * x[0] * x[0]; });
  const Slopes slopes = cells.FindSlopes();
  int count = 0;
  for (int s = 0; s < cells.Donors.Count(); ++s)
  {
    const double volume = cells.Donors[s].Overlap;
    const double* own = cells.Values.Of(s);
    double mass = 0.0, content = 0.0;
    for (double x : { cells.Shapes[s].Lower[0], cells.Shapes[s].Upper[0] })
    {
      const auto valueAt = [&](int column)
      { return own[column] + x * LineOf(slopes, s, column, 0) + LineOf(slopes, s, column, 3); };
      mass += 0.5 * volume * valueAt(0);
      content += 0.5 * volume * valueAt(0) * valueAt(1);
    }
    EXPECT_NEAR(mass, volume * own[0], 1e-12 * mass);
    EXPECT_NEAR(content, volume * own[0] * own[1], 1e-12 * content);
    count += LineOf(slopes, s, 0, 0) > 0.0 && LineOf(slopes, s, 1, 3) < 0.0;
  }
  EXPECT_GE(count, 5 * 5 * 3); // the products matter
}

TEST(Slopes, PointsAndFirstOrderAreConstant)
{
  const CartesianGrid grid = MakeUnitGrid(3, 1, 1);
  FullCells cells(grid);
  cells.SetValues(0, [](const Vector3&) { return 1.0; });
  cells.SetValues(1, [](const Vector3& x) { return x[0]; });
  cells.Shapes[1].Lower = cells.Shapes[1].Upper = {};
  const Slopes slopes = cells.FindSlopes();
  EXPECT_EQ(LineOf(slopes, 1, 1, 0), 0.0);
  EXPECT_EQ(LineOf(Slopes(Columns), 0, 1, 0), 0.0);
}
