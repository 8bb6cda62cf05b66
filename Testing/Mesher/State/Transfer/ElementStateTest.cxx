/// State of elements from their parts.
#include "State/Transfer/ElementState.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;

namespace
{

/// Density and two components per mass; columns are stored four by four.
const StateColumns Columns({ { StateKind::PerVolume }, { StateKind::PerMass, 2 } }, 0);
const double Flat[16] = {};

} // namespace

TEST(ElementStates, MeansOverVolumeAndMass)
{
  const double first[4] = { 2.0, 3.0, -1.0 }, second[4] = { 1.0, 7.0, 4.0 };
  ElementStates states(Columns);
  states.Start();
  states.Add({ first, Flat, {}, 1.0, 1.0 });
  states.Add({ second, Flat, {}, 3.0, 3.0 });
  states.Finish();
  EXPECT_DOUBLE_EQ(states.Mass(0), 1.0 * 2.0 + 3.0 * 1.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[0], 5.0 / 4.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[1], (2.0 * 3.0 + 3.0 * 7.0) / 5.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[2], (2.0 * -1.0 + 3.0 * 4.0) / 5.0);
}

/// The density of an element is the mass that it receives over its own volume.
TEST(ElementStates, ReceivedVolumeMayDifferFromItsOwn)
{
  const double own[4] = { 2.0, 3.0, 5.0 };
  ElementStates states(Columns);
  states.Start();
  states.Add({ own, Flat, {}, 1.0, 1.5 });
  states.Finish();
  EXPECT_DOUBLE_EQ(states.Mass(0), 3.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[0], 3.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[1], 3.0);
}

TEST(ElementStates, PartsHaveValuesOnLines)
{
  const double own[4] = { 2.0, 10.0, 0.0 };
  // Slopes along x, y, z and shifts, each per column.
  const double lines[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 1.0, 0.0, -2.0, 0.0, 0.0, 0.5,
    0.0, 0.0 };
  ElementStates states(Columns);
  states.Start();
  states.Add({ own, lines, { { 1.0, 0.0, 3.0 } }, 1.0, 1.0 });  // density 6, values 10.5 and -6
  states.Add({ own, lines, { { -1.0, 2.0, 0.0 } }, 2.0, 2.0 }); // density 1, values 18.5 and 0
  states.Finish();
  EXPECT_DOUBLE_EQ(states.Mass(0), 8.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[0], 8.0 / 3.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[1], (6.0 * 10.5 + 2.0 * 18.5) / 8.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[2], 6.0 * -6.0 / 8.0);
}

TEST(ElementStates, WithoutMassValuesAreMeansOverVolume)
{
  const double first[4] = { 0.0, 3.0, 1.0 }, second[4] = { 0.0, 7.0, 1.0 };
  ElementStates states(Columns);
  states.Start();
  states.Add({ first, Flat, {}, 1.0, 1.0 });
  states.Add({ second, Flat, {}, 3.0, 3.0 });
  states.Finish();
  EXPECT_EQ(states.Mass(0), 0.0);
  EXPECT_EQ(states.Values(0)[0], 0.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[1], 6.0);
  EXPECT_DOUBLE_EQ(states.Values(0)[2], 1.0);
}

namespace
{

/// Returns the values and the mass of elements with one to four parts, whose columns have numbers
/// of their own.
std::vector<std::vector<double>> FindStates(const StateColumns& columns, int elements)
{
  const int width = columns.Width(), parts = 4;
  std::vector<double> own(parts * width), lines(parts * 4 * width);
  for (int p = 0; p < parts; ++p)
  {
    for (int c = 0; c < width; ++c)
    {
      own[p * width + c] = c == 0 ? 2.0 + p : std::sin(1.0 + c + 10.0 * p);
      for (int k = 0; k < 4; ++k)
      {
        lines[(4 * p + k) * width + c] = 0.1 * std::cos(c + 5.0 * k + 30.0 * p);
      }
    }
  }
  ElementStates states(columns);
  for (int e = 0; e < elements; ++e)
  {
    states.Start();
    for (int p = 0; p <= e % parts; ++p)
    {
      const double volume = 0.3 + 0.1 * p + 0.01 * e;
      states.Add({ own.data() + p * width, lines.data() + 4 * p * width,
        { { 0.1 * e, -0.2 * p, 0.3 } }, volume, 1.01 * volume });
    }
  }
  states.Finish();
  std::vector<std::vector<double>> found;
  for (int e = 0; e < elements; ++e)
  {
    found.emplace_back(states.Values(e), states.Values(e) + columns.Count());
    found.back().push_back(states.Mass(e));
  }
  return found;
}

} // namespace

/// A value does not depend on the number of columns, although few columns are summed by other code.
TEST(ElementStates, ColumnsDoNotDependOnOthers)
{
  const auto columnsOf = [](int components) {
    return StateColumns({ { StateKind::PerVolume }, { StateKind::PerMass, components } }, 0);
  };
  const std::vector<std::vector<double>> all = FindStates(columnsOf(19), 9);
  for (int components : { 1, 3, 7, 10, 15 })
  {
    const std::vector<std::vector<double>> some = FindStates(columnsOf(components), 9);
    for (int e = 0; e < 9; ++e)
    {
      for (int c = 0; c <= components; ++c)
      {
        EXPECT_EQ(some[e][c], all[e][c]) << components << " " << e << " " << c;
      }
      EXPECT_EQ(some[e].back(), all[e].back());
    }
  }
}
