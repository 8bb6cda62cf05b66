/// Arrays that share the memory of equal values.
#include "PackedValues.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;

TEST(PackedValues, ReturnsWhatWasAppended)
{
  std::vector<double> values;
  PackedValues packed;
  while (values.size() < 10000)
  {
    const std::size_t n = values.size();
    std::vector<double> part(1 + n * 7 % 200, n % 3 == 0 ? 1.0 : n % 5 == 0 ? 0.25 : 0.0);
    if (n % 4 == 0)
    {
      part.back() = 1e-4 * static_cast<double>(n);
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
