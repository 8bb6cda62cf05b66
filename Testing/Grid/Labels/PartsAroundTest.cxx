/// Parts of a set of cells and of the rest in the 27 cells around a cell.
#include "Labels/PartsAround.h"

#include "Base/IndexBox.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr CellsAround Whole = (1u << 27) - 1;

/// Returns the cells of the 27 for which is(step) holds.
template <class Is>
CellsAround Where(const Is& is)
{
  CellsAround set = 0;
  for (int n = 0; n < 27; ++n)
  {
    set |= is(StepAround(n)) ? 1u << n : 0u;
  }
  return set;
}

Index Steps(const Index3& a, const Index3& b)
{
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

bool IsAround(const Index3& a, const Index3& b)
{
  return std::abs(a[0] - b[0]) < 2 && std::abs(a[1] - b[1]) < 2 && std::abs(a[2] - b[2]) < 2;
}

/// Counts the parts of a set that contain a start, by repeated passes over all pairs.
template <class Joins>
int Count(CellsAround set, CellsAround starts, const Joins& joins)
{
  std::array<int, 27> part;
  for (int n = 0; n < 27; ++n)
  {
    part[n] = n;
  }
  for (int pass = 0; pass < 27; ++pass)
  {
    for (int a = 0; a < 27; ++a)
    {
      for (int b = 0; b < 27; ++b)
      {
        if (set >> a & set >> b & 1u && joins(StepAround(a), StepAround(b)))
        {
          part[a] = std::min(part[a], part[b]);
        }
      }
    }
  }
  CellsAround found = 0;
  for (int n = 0; n < 27; ++n)
  {
    found |= starts >> n & 1u ? 1u << part[n] : 0u;
  }
  return __builtin_popcount(found);
}

TEST(PartsAround, KnownShapes)
{
  struct Known
  {
    CellsAround Set;
    int PartsOfSet, PartsOfRest;
  };
  const std::vector<Known> known{
    { 0, 0, 1 },                                                             // a drop
    { Whole, 1, 0 },                                                         // inside
    { Where([](const Index3& s) { return s[2] == 0; }), 1, 2 },              // a film
    { Where([](const Index3& s) { return s[0] == 0 && s[1] == 0; }), 2, 1 }, // a thread
    { Where([](const Index3& s) { return s[0] <= 0; }), 1, 1 },              // an interface
    { Where([](const Index3& s) { return s[0] == 0 && s[1] == 0 && s[2] <= 0; }), 1, 1 }, // an end
    { Where([](const Index3& s) { return s[0] + s[1] == 0; }), 2, 1 }, // a thread, more at edges
    { Where([](const Index3& s) { return s[0] == 0 && s[1] != 0; }), 2, 1 }, // films beside it
  };
  for (std::size_t n = 0; n < known.size(); ++n)
  {
    EXPECT_EQ(CountPartsOfSet(known[n].Set), known[n].PartsOfSet) << n;
    EXPECT_EQ(CountPartsOfRest(known[n].Set), known[n].PartsOfRest) << n;
  }
}

TEST(PartsAround, RandomSets)
{
  RandomDraw draw(1);
  const auto middle = [](const Index3& s) { return s == Index3{}; };
  const CellsAround aroundFaces = Where([](const Index3& s) { return Steps(s, {}) == 1; });
  const CellsAround aroundEdges =
    Where([](const Index3& s) { return Steps(s, {}) == 1 || Steps(s, {}) == 2; });
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double share = draw.Between(0.1, 0.9);
    const CellsAround set = Where([&](const Index3&) { return draw.Chance(share); });
    const CellsAround near = set & aroundEdges, rest = ~set & Whole & ~Where(middle);
    EXPECT_EQ(CountPartsOfSet(set),
      Count(near, near & aroundFaces,
        [](const Index3& a, const Index3& b) { return Steps(a, b) == 1; }));
    EXPECT_EQ(CountPartsOfRest(set), Count(rest, rest, IsAround));
  }
}

} // namespace
