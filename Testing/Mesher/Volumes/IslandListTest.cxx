/// Islands of one rank.
#include "Volumes/IslandList.h"
#include "Grains.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

TEST(IslandList, SolvesIslandsOfAllSizes)
{
  const Grains parts[] = { MakeLattice(1, true), MakeLattice(3, true), MakeLattice(6, false) };
  IslandList list;
  std::vector<double> areas, lack;
  for (const Grains& part : parts)
  {
    const int before = static_cast<int>(lack.size()), numbers = 10 * before;
    list.BeginIsland();
    for (int f = 1; f <= part.Count; ++f)
    {
      list.AddFragment(before + f - 1, numbers + f);
      lack.push_back(part.Lack[f]);
    }
    for (const PairSum& area : part.Areas)
    {
      list.AddPair(static_cast<int>(areas.size()),
        { { area.First > 0 ? numbers + area.First : 0, numbers + area.Second } });
      areas.push_back(area.Value.Value());
    }
  }
  const auto areaOf = [&](int pair) { return areas[pair]; };
  list.Finish(areaOf, 100); // the last island is not factored
  std::vector<double> mu(lack.size(), 7.0);
  list.Solve(areaOf, lack, mu);
  auto at = mu.begin();
  for (const Grains& part : parts)
  {
    std::vector<double> own(1, 0.0);
    own.insert(own.end(), at, at + part.Count);
    at += part.Count;
    if (part.Count > 100)
    {
      EXPECT_LT(LargestResidual(part, own), 1e-5);
    }
    else
    {
      EXPECT_EQ(own, SolveForLack(part.Areas, part.Lack));
    }
  }
}
