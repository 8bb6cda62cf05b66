/// State of elements from their parts.
#include "State/Transfer/ElementState.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Density and two components per mass; columns are stored four by four.
const StateColumns Columns({ { StateKind::PerVolume }, { StateKind::PerMass, 2 } }, 0);
const double Flat[16] = {};

} // namespace

TEST(ElementState, MeansOverVolumeAndMass)
{
  const double first[4] = { 2.0, 3.0, -1.0 }, second[4] = { 1.0, 7.0, 4.0 };
  ElementState state(Columns);
  state.Start();
  state.Add({ first, Flat, {}, 1.0, 1.0 });
  state.Add({ second, Flat, {}, 3.0, 3.0 });
  state.Finish();
  EXPECT_DOUBLE_EQ(state.Mass(), 1.0 * 2.0 + 3.0 * 1.0);
  EXPECT_DOUBLE_EQ(state.Values()[0], 5.0 / 4.0);
  EXPECT_DOUBLE_EQ(state.Values()[1], (2.0 * 3.0 + 3.0 * 7.0) / 5.0);
  EXPECT_DOUBLE_EQ(state.Values()[2], (2.0 * -1.0 + 3.0 * 4.0) / 5.0);
}

/// The density of an element is the mass that it receives over its own volume.
TEST(ElementState, ReceivedVolumeMayDifferFromItsOwn)
{
  const double own[4] = { 2.0, 3.0, 5.0 };
  ElementState state(Columns);
  state.Start();
  state.Add({ own, Flat, {}, 1.0, 1.5 });
  state.Finish();
  EXPECT_DOUBLE_EQ(state.Mass(), 3.0);
  EXPECT_DOUBLE_EQ(state.Values()[0], 3.0);
  EXPECT_DOUBLE_EQ(state.Values()[1], 3.0);
}

TEST(ElementState, PartsHaveValuesOnLines)
{
  const double own[4] = { 2.0, 10.0, 0.0 };
  // Slopes along x, y, z and shifts, each per column.
  const double lines[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 1.0, 0.0, -2.0, 0.0, 0.0, 0.5,
    0.0, 0.0 };
  ElementState state(Columns);
  state.Start();
  state.Add({ own, lines, { { 1.0, 0.0, 3.0 } }, 1.0, 1.0 });  // density 6, values 10.5 and -6
  state.Add({ own, lines, { { -1.0, 2.0, 0.0 } }, 2.0, 2.0 }); // density 1, values 18.5 and 0
  state.Finish();
  EXPECT_DOUBLE_EQ(state.Mass(), 8.0);
  EXPECT_DOUBLE_EQ(state.Values()[0], 8.0 / 3.0);
  EXPECT_DOUBLE_EQ(state.Values()[1], (6.0 * 10.5 + 2.0 * 18.5) / 8.0);
  EXPECT_DOUBLE_EQ(state.Values()[2], 6.0 * -6.0 / 8.0);
}

TEST(ElementState, WithoutMassValuesAreMeansOverVolume)
{
  const double first[4] = { 0.0, 3.0, 1.0 }, second[4] = { 0.0, 7.0, 1.0 };
  ElementState state(Columns);
  state.Start();
  state.Add({ first, Flat, {}, 1.0, 1.0 });
  state.Add({ second, Flat, {}, 3.0, 3.0 });
  state.Finish();
  EXPECT_EQ(state.Mass(), 0.0);
  EXPECT_EQ(state.Values()[0], 0.0);
  EXPECT_DOUBLE_EQ(state.Values()[1], 6.0);
  EXPECT_DOUBLE_EQ(state.Values()[2], 1.0);
}
