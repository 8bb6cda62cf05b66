/// When the surfaces of the input are used.
#include "Phases/PlaceSurfaces.h"

#include "../GivenSurfaces/GivenCases.h"
#include "../SurfaceRuns.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(PlaceSurfaces, OnlyIfTheyAreThereAndUsed)
{
  const SurfaceCase c{ { { 12, 12, 12 } },
    MakeBodies({ BoxSurface({ { 3, 3, 3 } }, { { 9, 9, 9 } }) }) };
  Runtime runtime;
  MesherInput input = MakeSurfaceInput(c, runtime.Group());
  const CartesianGrid grid(GivenCase::Coordinates(12));
  MesherOptions on, off;
  off.UseSurfaces = false;
  ASSERT_TRUE(PlaceSurfaces({ input, on, runtime }, grid));
  EXPECT_EQ(PlaceSurfaces({ input, on, runtime }, grid)->Bodies().size(), 1u);
  EXPECT_FALSE(PlaceSurfaces({ input, off, runtime }, grid));
  input.Arrays.Fractions = { "other" };
  EXPECT_FALSE(PlaceSurfaces({ input, on, runtime }, grid));
  input.Surfaces = nullptr;
  EXPECT_FALSE(PlaceSurfaces({ input, on, runtime }, grid));
}
