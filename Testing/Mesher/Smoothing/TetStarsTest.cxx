/// Stars of tets as the energy reads them.
#include "Smoothing/TetStars.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

/// Tets of a number of points, and the corners at each point.
struct Tets
{
  std::vector<int> Elements;
  std::vector<std::uint32_t> Begin{ 0 }, Corners;

  void ListCorners(int points)
  {
    for (int p = 0; p < points; ++p)
    {
      for (std::size_t at = 0; at < this->Elements.size(); ++at)
      {
        if (this->Elements[at] == p)
        {
          this->Corners.push_back(static_cast<std::uint32_t>(at));
        }
      }
      this->Begin.push_back(static_cast<std::uint32_t>(this->Corners.size()));
    }
  }
};

/// Returns whether two orders of four points are even permutations of each other.
bool HaveOneOrientation(std::array<int, 4> a, const std::array<int, 4>& b)
{
  bool isEven = true;
  for (int n = 0; n < 4; ++n)
  {
    const auto at = std::find(a.begin() + n, a.end(), b[n]);
    if (at == a.end())
    {
      return false;
    }
    isEven = isEven == (at == a.begin() + n);
    std::iter_swap(a.begin() + n, at);
  }
  return isEven;
}

} // namespace

TEST(TetStars, HoldTheTetsAtEachPoint)
{
  constexpr int points = 12;
  RandomDraw random(4);
  Tets tets;
  while (tets.Elements.size() < 4 * 50)
  {
    std::set<int> corners;
    while (corners.size() < 4)
    {
      corners.insert(random.Whole(0, points - 2)); // the last point has no tet
    }
    tets.Elements.insert(tets.Elements.end(), corners.begin(), corners.end());
  }
  tets.ListCorners(points);
  TetStars stars;
  stars.Build(tets.Elements, tets.Begin, tets.Corners);
  EXPECT_FALSE(stars.Has(points - 1));
  for (int p = 0; p < points - 1; ++p)
  {
    ASSERT_TRUE(stars.Has(p));
    const TetStars::Star star = stars.At(p);
    const std::set<int> neighbours(star.FirstNeighbour, star.LastNeighbour);
    EXPECT_EQ(
      static_cast<std::ptrdiff_t>(neighbours.size()), star.LastNeighbour - star.FirstNeighbour);
    EXPECT_EQ(neighbours.count(p), 0u);
    std::set<int> used;
    const std::uint32_t count = tets.Begin[p + 1] - tets.Begin[p];
    for (std::uint32_t n = 0; n < (count + 7) / 8 * 8; ++n)
    {
      const std::uint32_t at = tets.Corners[tets.Begin[p] + std::min(n, count - 1)];
      std::array<int, 4> own, tet{ { p } };
      std::copy_n(tets.Elements.data() + at / 4 * 4, 4, own.begin());
      for (int k = 0; k < 3; ++k)
      {
        tet[k + 1] = star.FirstNeighbour[star.Tets[n / 8][k][n % 8]];
        used.insert(tet[k + 1]);
      }
      EXPECT_TRUE(HaveOneOrientation(tet, own));
    }
    EXPECT_EQ(used, neighbours);
  }
}

/// A fan of n tets around one edge has n + 1 neighbours at its first point.
TEST(TetStars, LargeStarsAreLeftOut)
{
  for (int count : { 63, 64 })
  {
    Tets tets;
    for (int n = 0; n < count; ++n)
    {
      tets.Elements.insert(tets.Elements.end(), { 0, 1, 2 + n, 2 + (n + 1) % count });
    }
    tets.ListCorners(2 + count);
    TetStars stars;
    stars.Build(tets.Elements, tets.Begin, tets.Corners);
    EXPECT_EQ(stars.Has(0), count < 64);
    EXPECT_TRUE(stars.Has(2));
    const TetStars::Star star = stars.At(2); // the others are not affected
    EXPECT_EQ(std::set<int>(star.FirstNeighbour, star.LastNeighbour),
      (std::set<int>{ 0, 1, 3, 1 + count }));
  }
}
