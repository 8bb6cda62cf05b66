/// Volumes of the fractions of fragments as field data, whole or as each rank has them.
#include "Report/FragmentTargets.h"
#include "Report/MeshData.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Count = 10; // fragments; fragment f has the volume f / 4

/// Returns the fragments of a rank: every third one, from the last rank to the first.
MeshReport::FragmentTargets TargetsOf(int rank, int ranks)
{
  MeshReport::FragmentTargets targets;
  for (int f = ranks - rank; f <= Count; f += ranks)
  {
    targets.Ids.push_back(f);
    targets.Volumes.push_back(0.25 * f);
  }
  return targets;
}

std::vector<double> AllVolumes()
{
  std::vector<double> volumes;
  for (int f = 1; f <= Count; ++f)
  {
    volumes.push_back(0.25 * f);
  }
  return volumes;
}

} // namespace

TEST(FragmentTargets, AreWholeOnlyIfRequested)
{
  for (int count : { 1, 3 })
  {
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const MeshReport::FragmentTargets own = TargetsOf(ranks.Rank(), count);
        for (TableMode mode : { TableMode::Off, TableMode::Automatic, TableMode::On })
        {
          const std::vector<FieldArray> fields = ListFragmentTargets(own, mode, Count, ranks);
          const bool isWhole = count == 1 || mode != TableMode::Off;
          EXPECT_EQ(fields.size(), isWhole ? 1u : 2u);
          EXPECT_EQ(NumbersOfField(fields, "FragmentTargetVolume"),
            isWhole ? AllVolumes() : std::vector<double>());
          EXPECT_TRUE(HasFragmentTargets(fields));
          EXPECT_EQ(ListRankFragments(fields), isWhole ? std::vector<int>() : own.Ids);
          EXPECT_EQ(FindFragmentTargets(fields, own.Ids), own.Volumes);
        }
      });
  }
}

TEST(FragmentTargets, OfAllPartsAreJoined)
{
  std::vector<std::vector<FieldArray>> parts(3);
  std::vector<const std::vector<FieldArray>*> views;
  for (int rank = 0; rank < 3; ++rank)
  {
    const MeshReport::FragmentTargets own = TargetsOf(rank, 3);
    parts[rank] = { { "First", std::vector<int>{ 1 } }, { "RankFragments", own.Ids },
      { "RankTargetVolume", own.Volumes }, { "NumberOfFragments", std::vector<Index>{ Count } } };
    views.push_back(&parts[rank]);
  }
  const std::vector<FieldArray> joined = JoinFields(views);
  ASSERT_EQ(joined.size(), 3u);
  EXPECT_EQ(joined[1].Name, "FragmentTargetVolume");
  EXPECT_EQ(NumbersOfField(joined, "FragmentTargetVolume"), AllVolumes());
  EXPECT_EQ(joined[2].Name, "NumberOfFragments");

  const std::vector<FieldArray> some = JoinFields({ views[0], views[2] });
  EXPECT_EQ(some.size(), 2u); // a list with gaps is no list of the whole mesh
  EXPECT_TRUE(IsFieldOfRank("RankFragments") && IsFieldOfRank("RankTargetVolume"));
  EXPECT_FALSE(IsFieldOfRank("FragmentTargetVolume"));
}

TEST(FragmentTargets, AreUnknownWhereNoFieldListsThem)
{
  EXPECT_FALSE(HasFragmentTargets({}));
  EXPECT_TRUE(ListRankFragments({}).empty());
  EXPECT_EQ(FindFragmentTargets({}, { 1, 2 }), (std::vector<double>{ -1.0, -1.0 }));
  const std::vector<FieldArray> some{ { "RankFragments", std::vector<int>{ 2, 3 } },
    { "RankTargetVolume", std::vector<double>{ 0.5 } } }; // too short
  EXPECT_EQ(FindFragmentTargets(some, { 1, 2, 3 }), (std::vector<double>{ -1.0, 0.5, -1.0 }));
  const std::vector<FieldArray> all{ { "FragmentTargetVolume", std::vector<double>{ 0.5 } } };
  EXPECT_EQ(FindFragmentTargets(all, { 1, 2 }), (std::vector<double>{ 0.5, -1.0 }));
}
