/// Arrays that share the memory of equal values.
#include "Input/PackedValues.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::RandomDraw;

TEST(PackedValues, ReturnsWhatWasAppended)
{
  RandomDraw random(3);
  std::vector<double> values;
  PackedValues packed;
  while (values.size() < 10000)
  {
    std::vector<double> part(random.Whole(1, 200), random.Pick({ 0.0, 1.0, 0.25 }));
    if (random.Chance(0.3))
    {
      part.back() = random.Between(0.0, 1.0);
    }
    packed.Append(part.data(), static_cast<Index>(part.size()));
    values.insert(values.end(), part.begin(), part.end());
  }
  packed.Finish();
  ASSERT_EQ(packed.Tuples, static_cast<Index>(values.size()));
  EXPECT_EQ(packed.Memory, nullptr);
  std::vector<double> copies(values.size());
  packed.Copy(0, packed.Tuples, copies.data());
  EXPECT_EQ(copies, values);
  packed.Copy(77, 40, copies.data());
  EXPECT_TRUE(std::equal(copies.begin(), copies.begin() + 40, values.begin() + 77));
  EXPECT_EQ(packed.Get(9999, 0), values[9999]);
}
