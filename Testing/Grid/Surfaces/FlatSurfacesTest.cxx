/// Surfaces as a few arrays: they are restored, and sent to all ranks.
#include "Surfaces/FlatSurfaces.h"

#include "SurfaceCases.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

InputSurfaces TwoBoxes()
{
  const ClosedSurface one = BoxSurface({ { 0.1, 0, 0 } }, { { 1, 1, 1 } }),
                      other = BoxSurface({ { 2, 0, 0.3 } }, { { 3, 1, 1.7 } });
  std::vector<int> patches(one.Triangles.size(), 1);
  patches[0] = 0;
  return { { MakeBody("one", one.Points, one.Triangles, patches, { "first", "rest" }),
    MakeBody("other", other.Points, other.Triangles) } };
}

void ExpectSame(const InputSurfaces& found, const InputSurfaces& expected)
{
  ASSERT_EQ(found.Bodies.size(), expected.Bodies.size());
  for (std::size_t b = 0; b < found.Bodies.size(); ++b)
  {
    const BodySurface &one = found.Bodies[b], &other = expected.Bodies[b];
    EXPECT_EQ(one.Name, other.Name);
    EXPECT_EQ(one.Boundary.Points, other.Boundary.Points);
    EXPECT_EQ(one.Boundary.Triangles, other.Boundary.Triangles);
    EXPECT_EQ(one.Patches, other.Patches);
    EXPECT_EQ(one.PatchNames, other.PatchNames);
  }
}

} // namespace

TEST(FlatSurfaces, AreRestored)
{
  const InputSurfaces surfaces = TwoBoxes();
  const FlatSurfaces flat = FlattenSurfaces(surfaces);
  EXPECT_EQ(flat.Names, (std::vector<std::string>{ "one", "other" }));
  EXPECT_EQ(flat.PatchNames, (std::vector<std::string>{ "first", "rest", "" }));
  EXPECT_EQ(flat.Bodies.front(), 0);
  EXPECT_EQ(flat.Bodies.back(), 1);
  EXPECT_EQ(flat.Patches.back(), 2);
  ExpectSame(RestoreSurfaces(flat), surfaces);
}

TEST(FlatSurfaces, AllRanksGetThoseOfTheFirstThatHasAny)
{
  const InputSurfaces surfaces = TwoBoxes();
  for (int owner : { 0, 2 })
  {
    RunOnRanks(3,
      [&](ThreadRanks& ranks)
      {
        FlatSurfaces mine = ranks.Rank() < owner ? FlatSurfaces() : FlattenSurfaces(surfaces);
        if (ranks.Rank() > owner)
        {
          mine.Names[0] = "of a later rank";
        }
        ExpectSame(RestoreSurfaces(ShareSurfaces(mine, ranks)), surfaces);
      });
  }
  RunOnRanks(2, [&](ThreadRanks& ranks) { EXPECT_TRUE(ShareSurfaces({}, ranks).Names.empty()); });
}

TEST(FlatSurfaces, ArraysThatDoNotFitAreAnError)
{
  const FlatSurfaces flat = FlattenSurfaces(TwoBoxes());
  FlatSurfaces wrong = flat;
  wrong.Bodies.pop_back();
  EXPECT_THROW(RestoreSurfaces(wrong), InputError);
  wrong = flat;
  wrong.Patches[0] = 3;
  EXPECT_THROW(RestoreSurfaces(wrong), InputError);
  wrong = flat;
  wrong.Names.pop_back();
  EXPECT_THROW(RestoreSurfaces(wrong), InputError);
  wrong = flat;
  wrong.Triangles[3][1] = static_cast<Index>(wrong.Points.size());
  EXPECT_THROW(RestoreSurfaces(wrong), InputError);
}
