/// Fragments of periodic meshes: position, bounds and neighbours of bodies that sides cut.
#include "LabelInput.h"
#include "RankFields.h"
#include "Report/Fragments/FragmentTable.h"
#include "State/ViewMesh.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Count = 12; // cells along each axis
constexpr double Width = 0.25, Origin = 0.1, Period = Count * Width;

struct Method
{
  const char* Name;
  ElementKind Elements;
  Sides Kind;
};

class PeriodicFragments : public ::testing::TestWithParam<Method>
{
protected:
  /// Returns the fragments of a mesh made by this many ranks, in the order of the ranks.
  std::vector<FragmentSummary> Find(const std::vector<int>& labels, int count) const
  {
    MesherOptions options;
    options.Elements = this->GetParam().Elements;
    options.PeriodicSides = this->GetParam().Kind;
    options.Periodic = 7;
    std::vector<std::vector<FragmentSummary>> found(count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        RankRuntime runtime(ranks);
        const LabelGrid grid{ { { Count, Count, Count } }, Origin, Width };
        const MesherResult result =
          RunMesher(MakeLabelInput(grid, labels, ranks), options, runtime);
        found[ranks.Rank()] =
          FindFragments(ViewMesh(result.TheMesh, result.State, result.Fields), {}, ranks);
      });
    std::vector<FragmentSummary> all;
    for (const std::vector<FragmentSummary>& part : found)
    {
      all.insert(all.end(), part.begin(), part.end());
    }
    for (std::size_t f = 0; f < all.size(); ++f)
    {
      EXPECT_EQ(all[f].Id, static_cast<int>(f + 1));
    }
    return all;
  }

  static bool AreEqual(const std::vector<FragmentSummary>& a, const std::vector<FragmentSummary>& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
      [](const FragmentSummary& first, const FragmentSummary& second)
      {
        return first.Volume == second.Volume && first.Centroid == second.Centroid &&
          first.Bounds == second.Bounds && first.Neighbours == second.Neighbours;
      });
  }
};

/// Returns labels of cells with a label for each offset from a first cell, across the sides.
template <class Function>
std::vector<int> MakeLabels(const Index3& first, const Function& labelAt)
{
  std::vector<int> labels(Count * Count * Count, 0);
  for (Index cell = 0; cell < Count * Count * Count; ++cell)
  {
    const Index3 at{ { cell % Count, cell / Count % Count, cell / Count / Count } };
    Index3 offset;
    for (int a = 0; a < 3; ++a)
    {
      offset[a] = (at[a] - first[a] + Count) % Count;
    }
    labels[cell] = labelAt(offset);
  }
  return labels;
}

/// A body of 4 x 5 x 6 cells, and a second one behind it along x.
int TwoBricks(const Index3& at)
{
  const bool isInside = at[0] < 6 && at[1] < 5 && at[2] < 6;
  return !isInside ? 0 : at[0] < 4 ? 1 : 2;
}

} // namespace

TEST_P(PeriodicFragments, AreInOnePieceWhereverSidesCutThem)
{
  const std::vector<FragmentSummary> inside = this->Find(MakeLabels({ { 3, 3, 3 } }, TwoBricks), 1);
  ASSERT_EQ(inside.size(), 2u);
  for (const Index3& first : { Index3{ { 10, 9, 8 } }, Index3{ { 7, 3, 10 } } })
  {
    const std::vector<int> labels = MakeLabels(first, TwoBricks);
    const std::vector<FragmentSummary> cut = this->Find(labels, 1);
    ASSERT_EQ(cut.size(), 2u);
    EXPECT_TRUE(AreEqual(cut, this->Find(labels, 3)));
    for (const FragmentSummary& fragment : cut)
    {
      const FragmentSummary& whole = inside[fragment.Material - 1];
      EXPECT_EQ(fragment.Neighbours.size(), 1u);
      for (int a = 0; a < 3; ++a)
      {
        const double moved = fragment.Centroid[a] - whole.Centroid[a];
        const double expected = Width * static_cast<double>(first[a] - 3);
        EXPECT_NEAR(std::remainder(moved - expected, Period), 0.0, 0.2 * Width);
        EXPECT_NEAR(fragment.Bounds[2 * a + 1] - fragment.Bounds[2 * a],
          whole.Bounds[2 * a + 1] - whole.Bounds[2 * a], Width);
        EXPECT_LT(fragment.Bounds[2 * a], fragment.Centroid[a]);
        EXPECT_GT(fragment.Bounds[2 * a + 1], fragment.Centroid[a]);
      }
    }
  }
}

TEST_P(PeriodicFragments, StayIfTheyAreConnectedWithTheirCopies)
{
  const std::vector<FragmentSummary> bars = this->Find(
    MakeLabels({ { 10, 9, 8 } }, [](const Index3& at) { return at[0] < 4 && at[1] < 4 ? 1 : 0; }),
    2);
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_NEAR(bars[0].Bounds[5] - bars[0].Bounds[4], Period, 1e-12 + 2.0 * Width);
  EXPECT_GT(bars[0].Bounds[1] - bars[0].Bounds[0], Period - 2.0 * Width);
}

/// Bodies that touch only across a side.
TEST_P(PeriodicFragments, HaveNeighboursAcrossSides)
{
  const std::vector<FragmentSummary> bricks =
    this->Find(MakeLabels({ { Count - 4, 3, 3 } }, TwoBricks), 3);
  ASSERT_EQ(bricks.size(), 2u);
  EXPECT_EQ(bricks[0].Neighbours, std::vector<int>{ 2 });
  EXPECT_EQ(bricks[1].Neighbours, std::vector<int>{ 1 });
}

INSTANTIATE_TEST_SUITE_P(Methods, PeriodicFragments,
  ::testing::Values(Method{ "FlatHexes", ElementKind::Hexes, Sides::Flat },
    Method{ "FreeHexes", ElementKind::Hexes, Sides::Free },
    Method{ "JoinedHexes", ElementKind::Hexes, Sides::Joined },
    Method{ "FlatTets", ElementKind::Tets, Sides::Flat },
    Method{ "JoinedTets", ElementKind::Tets, Sides::Joined }),
  [](const auto& info) { return std::string(info.param.Name); });
