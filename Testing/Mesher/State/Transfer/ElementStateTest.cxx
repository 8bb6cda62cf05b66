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
