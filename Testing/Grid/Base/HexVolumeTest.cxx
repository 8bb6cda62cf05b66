/// Volumes of hexes.
#include "Base/HexVolume.h"

#include <gtest/gtest.h>

using namespace vfm;

TEST(HexVolume, OfAffineBodiesAndFrusta)
{
  const Vector3 u{ { 2.0, 0.1, 0.3 } }, v{ { -0.4, 1.5, 0.2 } }, w{ { 0.3, -0.6, 0.7 } };
  const std::array<Vector3, 4> low{ { {}, u, u + v, v } };
  const std::array<Vector3, 4> high{ { w, u + w, u + v + w, v + w } };
  EXPECT_NEAR(VolumeBetween(low, high), Dot(Cross(u, v), w), 1e-14);
  EXPECT_NEAR(VolumeBetween(high, low), -Dot(Cross(u, v), w), 1e-14);
  const std::array<Vector3, 4> base{ { { { -1, -1, 0 } }, { { 1, -1, 0 } }, { { 1, 1, 0 } },
    { { -1, 1, 0 } } } };
  std::array<Vector3, 4> top;
  for (int c = 0; c < 4; ++c)
  {
    top[c] = 0.5 * base[c] + Vector3{ { 0, 0, 3 } };
  }
  EXPECT_NEAR(VolumeBetween(base, top), 4.0 + 2.0 + 1.0, 1e-14);
}
