/// Directions from which all faces are visible.
#include "Elements/Hex/VisibleDirection.h"
#include "Base/Vector3.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

double SmallestProduct(const std::vector<Vector3>& normals, const Vector3& direction)
{
  double least = 1.0;
  for (const Vector3& normal : normals)
  {
    least = std::min(least, Dot(normal, direction));
  }
  return least;
}

} // namespace

TEST(VisibleDirection, OfACorner)
{
  const VisibleDirection found =
    FindVisibleDirection({ { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } });
  EXPECT_NEAR(found.Margin, std::sqrt(1.0 / 3.0), 1e-9);
  EXPECT_LE(FindVisibleDirection({ { { 1, 0, 0 } }, { { -1, 0, 0 } } }).Margin, 0.0);
}

TEST(VisibleDirection, NoOtherDirectionIsBetter)
{
  RandomDraw random(2);
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 axis = Unit(random.Vector(-1, 1));
    std::vector<Vector3> normals(random.Whole(1, 8));
    for (Vector3& normal : normals)
    {
      normal = Unit(axis + 0.8 * Unit(random.Vector(-1, 1)));
    }
    const VisibleDirection found = FindVisibleDirection(normals);
    ASSERT_NEAR(Norm(found.Direction), 1.0, 1e-12);
    ASSERT_NEAR(found.Margin, SmallestProduct(normals, found.Direction), 1e-12);
    for (int trial = 0; trial < 200; ++trial)
    {
      const Vector3 other = Unit(found.Direction + random.Scale(1e-3, 1.0) * random.Vector(-1, 1));
      ASSERT_LE(SmallestProduct(normals, other), found.Margin + 2e-3); // after 400 steps
    }
  }
}
