/// Whether fractions are those of surfaces.
#include "GivenSurfaces/SurfaceMatch.h"

#include "GivenCases.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

ClosedSurface BoxAt(double shift)
{
  const Vector3 lower{ { 3.2 + shift, 3.3, 3.4 } }, upper{ { 12.3 + shift, 10.4, 11.6 } };
  return BoxSurface(lower, upper);
}

/// Returns whether the surfaces of bodies match the fractions of others.
std::vector<bool> MatchesOf(const std::vector<ClosedSurface>& bodies,
  const std::vector<ClosedSurface>& ofFractions, int ranks = 1)
{
  const CartesianGrid whole(GivenCase::Coordinates(20));
  const std::vector<IndexBox> boxes = CutBox(whole.Global(), ranks);
  const InputSurfaces given = MakeBodies(bodies), other = MakeBodies(ofFractions);
  std::vector<bool> found;
  RunOnRanks(ranks,
    [&](Ranks& group)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[group.Rank()]);
      RankRuntime runtime(group);
      const BodySurfaces surfaces(given, GivenCase::Names(bodies.size()), grid, 40.0);
      const std::vector<bool> matches =
        FindMatches(surfaces, grid, FractionsOfBodies(grid, other), runtime);
      if (group.Rank() == 0)
      {
        found = matches;
      }
    });
  return found;
}

using Flags = std::vector<bool>;

TEST(SurfaceMatch, MovedGridsAreFound)
{
  EXPECT_EQ(MatchesOf({ BoxAt(0.0) }, { BoxAt(0.0) }), Flags{ true });
  EXPECT_EQ(MatchesOf({ BoxAt(0.0) }, { BoxAt(0.05) }), Flags{ true });
  EXPECT_EQ(MatchesOf({ BoxAt(0.0) }, { BoxAt(1.0) }), Flags{ false });
  EXPECT_EQ(MatchesOf({ BoxAt(0.0) }, { BoxAt(-3.0) }), Flags{ false });
  EXPECT_EQ(MatchesOf({ BoxAt(100.0) }, { BoxAt(0.0) }), Flags{ false });
  const ClosedSurface sphere = SphereSurface({ { 9, 9, 9 } }, 5.0, 40),
                      moved = SphereSurface({ { 9.5, 9, 9 } }, 5.0, 40);
  EXPECT_EQ(MatchesOf({ sphere }, { moved }), Flags{ false });
}

TEST(SurfaceMatch, EachBodyIsCompared)
{
  const ClosedSurface ball = SphereSurface({ { 8, 7, 7 } }, 2.0, 30);
  EXPECT_EQ(MatchesOf({ ball, BoxAt(0.0) }, { ball, BoxAt(0.0) }), (Flags{ true, true }));
  EXPECT_EQ(MatchesOf({ ball, BoxAt(0.0) }, { ball, BoxAt(0.5) }), (Flags{ true, false }));
  // a body that fills the domain cuts no cell
  const ClosedSurface all = BoxSurface({ { -1, -1, -1 } }, { { 21, 21, 21 } });
  EXPECT_EQ(MatchesOf({ all }, { all }), Flags{ true });
}

TEST(SurfaceMatch, IsEqualOnAllRanks)
{
  for (int ranks : { 2, 3 })
  {
    EXPECT_EQ(MatchesOf({ BoxAt(0.0) }, { BoxAt(0.0) }, ranks), Flags{ true });
    EXPECT_EQ(MatchesOf({ BoxAt(0.0) }, { BoxAt(0.5) }, ranks), Flags{ false });
  }
}

} // namespace
