/// Divisions of edges into layers.
#include "Modify/LayerHeights.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

void ExpectEnds(const LayerSpacing& spacing, double height, const std::vector<double>& right)
{
  const std::vector<double> ends = FindLayerEnds(spacing, height);
  ASSERT_EQ(ends.size(), right.size());
  for (std::size_t i = 0; i < right.size(); ++i)
  {
    EXPECT_NEAR(ends[i], right[i], 1e-12) << height;
  }
}

} // namespace

TEST(LayerHeights, EndsOfLayers)
{
  const LayerSpacing spacing{ 3, 2.0, 0.0 };
  ExpectEnds(spacing, 0.0, { 0.0, 1.0 / 7.0, 3.0 / 7.0, 1.0 });
  ExpectEnds(spacing, 7.0, { 0.0, 1.0 / 7.0, 3.0 / 7.0, 1.0 });
  ExpectEnds(spacing, 10.0, { 0.0, 0.1, 0.3, 1.0 });
  ExpectEnds({ 1, 1.0, 0.0 }, 4.0, { 0.0, 1.0 });
}

TEST(LayerHeights, LayersGrowLessWhereRoomLacks)
{
  const LayerSpacing spacing{ 4, 1.5, 0.0 };
  for (double height : { 4.5, 6.0, 8.0 })
  {
    const std::vector<double> ends = FindLayerEnds(spacing, height);
    ASSERT_EQ(ends.size(), 5u);
    EXPECT_NEAR(ends[1] * height, 1.0, 1e-6);
    EXPECT_EQ(ends[4], 1.0);
    const double growth = (ends[2] - ends[1]) / ends[1];
    EXPECT_LT(growth, 1.5);
    EXPECT_NEAR((ends[4] - ends[3]) / (ends[3] - ends[2]), growth, 1e-6);
  }
}
