#include "Fractions/FractionField.h"
#include "Base/Runtime.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

using namespace vfm;

namespace
{

CartesianGrid UnitGrid(int n)
{
  std::vector<double> x;
  for (int i = 0; i <= n; ++i)
  {
    x.push_back(i);
  }
  return CartesianGrid(std::array<std::vector<double>, 3>{ { x, x, x } });
}

/// Reader with fractions of a few cells; 0 elsewhere.
struct MapReader : FractionField::Reader
{
  std::map<std::pair<int, Index3>, double> Values;
  double Rounded = 0.0, Allowed = FractionTolerance;
  void Read(int material, const Index3& first, Index count, double* values) const override
  {
    for (Index c = 0; c < count; ++c)
    {
      const auto it = this->Values.find({ material, { { first[0] + c, first[1], first[2] } } });
      values[c] = it == this->Values.end() ? 0.0 : it->second;
    }
  }
  double Rounding(int) const override { return this->Rounded; }
  double Tolerance() const override { return this->Allowed; }
  std::string Name(int material) const override { return "m" + std::to_string(material); }
};

std::string ErrorOf(const MapReader& reader)
{
  try
  {
    FractionField::FromReader(UnitGrid(3), 2, reader);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(FractionField, StoresPureCellsAsLabelsAndMixedCellsAsLists)
{
  MapReader reader;
  reader.Values[{ 1, { { 0, 0, 0 } } }] = 1.0;
  reader.Values[{ 1, { { 1, 0, 0 } } }] = 0.25;
  reader.Values[{ 2, { { 1, 0, 0 } } }] = 0.5;
  const CartesianGrid grid = UnitGrid(3);
  const FractionField field = FractionField::FromReader(grid, 2, reader);
  const Index a = grid.Linear({ { 0, 0, 0 } }), b = grid.Linear({ { 1, 0, 0 } }),
              c = grid.Linear({ { 2, 2, 2 } });
  EXPECT_FALSE(field.IsMixed(a));
  EXPECT_EQ(field.Label(a), 1);
  EXPECT_TRUE(field.IsMixed(b));
  EXPECT_EQ(field.Fraction(b, 0), 0.25);
  EXPECT_EQ(field.Fraction(b, 1), 0.25);
  EXPECT_EQ(field.Fraction(b, 2), 0.5);
  EXPECT_EQ(field.Label(c), 0);
  EXPECT_EQ(field.NumberOfNormalisedCells(), 0);
}

TEST(FractionField, NormalisesSmallExcessAndRefusesLarge)
{
  MapReader reader;
  reader.Values[{ 1, { { 1, 1, 1 } } }] = 0.5;
  reader.Values[{ 2, { { 1, 1, 1 } } }] = 0.5005;
  const CartesianGrid grid = UnitGrid(3);
  const FractionField field = FractionField::FromReader(grid, 2, reader);
  EXPECT_EQ(field.NumberOfNormalisedCells(), 1);
  const Index cell = grid.Linear({ { 1, 1, 1 } });
  EXPECT_DOUBLE_EQ(field.Fraction(cell, 1) + field.Fraction(cell, 2), 1.0);
  reader.Values[{ 2, { { 1, 1, 1 } } }] = 0.6;
  EXPECT_NE(ErrorOf(reader).find("cell (1, 1, 1) sum to 1.1"), std::string::npos)
    << ErrorOf(reader);
}

TEST(FractionField, CountsOnlyWhatRoundingDoesNotExplain)
{
  const double step = 1.0 / 255;
  MapReader reader;
  reader.Rounded = 0.50001 * step;
  reader.Values[{ 1, { { 1, 1, 1 } } }] = reader.Values[{ 2, { { 1, 1, 1 } } }] = 128 * step;
  const CartesianGrid grid = UnitGrid(3);
  const FractionField field = FractionField::FromReader(grid, 3, reader);
  EXPECT_EQ(field.NumberOfNormalisedCells(), 0);
  EXPECT_DOUBLE_EQ(field.Fraction(grid.Linear({ { 1, 1, 1 } }), 2), 0.5);
  reader.Values[{ 1, { { 1, 1, 1 } } }] += 0.4 * step;
  EXPECT_EQ(FractionField::FromReader(grid, 3, reader).NumberOfNormalisedCells(), 1);
  EXPECT_NE(ErrorOf(reader), ""); // two materials may round by less than three
}

TEST(FractionField, ClipsWithinTheTolerance)
{
  MapReader reader;
  reader.Values[{ 1, { { 0, 0, 0 } } }] = 1.01;
  reader.Values[{ 2, { { 0, 0, 0 } } }] = -0.01;
  reader.Values[{ 1, { { 1, 0, 0 } } }] = 0.6;
  reader.Values[{ 2, { { 1, 0, 0 } } }] = 0.41;
  reader.Values[{ 1, { { 2, 0, 0 } } }] = 1.0 + 1e-7; // rounding error
  EXPECT_NE(ErrorOf(reader).find("lie in [0, 1]"), std::string::npos);
  reader.Allowed = 0.0100001;
  const CartesianGrid grid = UnitGrid(3);
  const FractionField field = FractionField::FromReader(grid, 2, reader);
  EXPECT_EQ(field.NumberOfClippedCells(), 1);
  EXPECT_EQ(field.NumberOfNormalisedCells(), 1);
  EXPECT_EQ(field.Label(grid.Linear({ { 0, 0, 0 } })), 1);
  EXPECT_DOUBLE_EQ(field.Fraction(grid.Linear({ { 1, 0, 0 } }), 2), 0.41 / 1.01);
  reader.Values[{ 2, { { 1, 0, 0 } } }] = 0.42;
  EXPECT_NE(ErrorOf(reader).find("sum to 1.02"), std::string::npos);
  reader.Values[{ 2, { { 1, 0, 0 } } }] = -0.02;
  EXPECT_NE(ErrorOf(reader).find("holds -0.02"), std::string::npos);
}

TEST(FractionField, RefusesValuesThatAreNoFractions)
{
  for (double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -0.01, 1.01 })
  {
    MapReader reader;
    reader.Values[{ 2, { { 2, 0, 1 } } }] = bad;
    const std::string message = ErrorOf(reader);
    EXPECT_NE(message.find("'m2'"), std::string::npos) << bad;
    EXPECT_NE(message.find("cell (2, 0, 1)"), std::string::npos) << bad;
  }
}
