/// Sides of bodies from patches and sheets.
#include "Surfaces/SurfaceSides.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

BodySurface MakeTet(std::vector<std::string> names)
{
  const std::vector<Vector3> points{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, 0, 1 } } };
  return MakeBody("tet", points,
    { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 0, 3, 2 } } }, { 0, 1, 1, 0 },
    std::move(names));
}

TEST(SurfaceSides, NamedPatchesAreSides)
{
  const BodySurface body = MakeTet({ "inlet", "wall" });
  const SurfaceSides sides = FindSides(body, FindSheets(body.Boundary, 40.0));
  EXPECT_EQ(sides.SideOf, body.Patches);
  EXPECT_EQ(sides.Names, body.PatchNames);
}

TEST(SurfaceSides, OtherwiseTheAngleDecides)
{
  for (const std::vector<std::string>& names :
    { std::vector<std::string>{ "solid", "" }, { "", "" }, { "", "", "unused" } })
  {
    const BodySurface body = MakeTet(names);
    const SurfaceSides sides = FindSides(body, FindSheets(body.Boundary, 40.0));
    EXPECT_EQ(sides.SideOf, (std::vector<int>{ 0, 1, 2, 3 }));
    EXPECT_EQ(sides.Names, std::vector<std::string>(4));
    EXPECT_EQ(FindSides(body, FindSheets(body.Boundary, 130.0)).Count(), 1);
  }
}

} // namespace
