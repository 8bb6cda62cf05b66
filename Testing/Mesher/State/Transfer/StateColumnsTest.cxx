/// Columns of conserved quantities.
#include "State/Transfer/StateColumns.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

/// Density, heat capacity per mass, temperature weighted with it, velocity per mass.
const std::vector<StateQuantity> Quantities{ { StateKind::PerVolume }, { StateKind::PerMass },
  { StateKind::PerMass, 1, 1 }, { StateKind::PerMass, 3 } };

} // namespace

TEST(StateColumns, ContentsAreProductsAlongTheChain)
{
  const StateColumns columns(Quantities, 0);
  ASSERT_EQ(columns.Count(), 6);
  EXPECT_EQ(columns.Width(), 8);
  EXPECT_EQ(columns.Base(columns.Density()), -1);
  EXPECT_EQ(columns.Base(2), 1);
  EXPECT_TRUE(columns.IsConstant(1));
  const double values[8] = { 8.0, 2.0, 300.0, 1.0, -2.0, 3.0 };
  double contents[8];
  columns.FindContents(0.5, values, contents);
  const double right[6] = { 4.0, 8.0, 2400.0, 4.0, -8.0, 12.0 };
  for (int c = 0; c < 6; ++c)
  {
    EXPECT_DOUBLE_EQ(contents[c], right[c]) << c;
  }
}

TEST(StateColumns, MixedVolumesKeepContentsAndBounds)
{
  const StateColumns columns(Quantities, 0);
  double volume = 0.5, values[8] = { 8.0, 2.0, 300.0, 1.0, -2.0, 3.0 };
  const double others[8] = { 2.0, 5.0, 400.0, 0.0, 4.0, 3.0 };
  double before[8], added[8], after[8];
  columns.FindContents(volume, values, before);
  columns.FindContents(1.5, others, added);
  columns.Mix(volume, values, 1.5, others);
  EXPECT_EQ(volume, 2.0);
  columns.FindContents(volume, values, after);
  for (int c = 0; c < 6; ++c)
  {
    EXPECT_NEAR(after[c], before[c] + added[c], 1e-12 * std::fabs(after[c])) << c;
  }
  EXPECT_GT(values[2], 300.0);
  EXPECT_LT(values[2], 400.0);
  EXPECT_DOUBLE_EQ(values[5], 3.0);
}
