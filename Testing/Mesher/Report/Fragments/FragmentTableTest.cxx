/// The table of fragments is the same from any number of ranks, in parts or on rank 0.
#include "Report/Fragments/FragmentTable.h"
#include "FragmentDrops.h"
#include "Report/FragmentTargets.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// How the volumes of the fractions are listed.
enum class Listed
{
  Nowhere,
  OnAll,
  InParts
};

constexpr double TargetPerFragment = 0.125;

void AddTargets(Listed how, Index count, int rank, int ranks, MeshData& mesh)
{
  MeshReport::FragmentTargets targets;
  for (int f = 1; f <= count; ++f)
  {
    // The rank that lists a fragment need not have elements of it.
    if (how == Listed::OnAll || (how == Listed::InParts && f % ranks == rank))
    {
      targets.Ids.push_back(f);
      targets.Volumes.push_back(TargetPerFragment * f);
    }
  }
  if (how == Listed::InParts)
  {
    mesh.Fields.push_back({ "RankFragments", targets.Ids });
    mesh.Fields.push_back({ "RankTargetVolume", targets.Volumes });
  }
  else if (how == Listed::OnAll && mesh.NumberOfElements > 0)
  {
    mesh.Fields.push_back({ "FragmentTargetVolume", targets.Volumes });
  }
}

template <class T>
const std::vector<T>& ColumnOf(const FieldArrays& table, const char* name)
{
  return std::get<std::vector<T>>(FindField(table, name)->Values);
}

struct Tables
{
  std::vector<FieldArrays> Parts; ///< of each rank
  FieldArrays Whole;              ///< of rank 0
  std::vector<ThreadRanks::Traffic> Sent;
};

/// Makes the table of drops; the last of several ranks has no elements.
Tables MakeTables(Index drops, int count, Listed how, const std::vector<std::string>& densities)
{
  Tables tables;
  tables.Parts.resize(count);
  tables.Sent.resize(count);
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      const int rank = ranks.Rank(), owners = std::max(1, count - 1);
      const Drops own = rank < owners ? MakeDrops(drops, rank, owners) : Drops();
      MeshData mesh = rank < owners ? ViewDrops(own) : MeshData();
      AddTargets(how, drops, rank, count, mesh);
      tables.Parts[rank] = MakeFragmentTable(mesh, densities, ranks);
      tables.Sent[rank] = ranks.Sent();
      FieldArrays whole = GatherTable(tables.Parts[rank], TableMode::On, ranks);
      if (rank == 0)
      {
        tables.Whole = std::move(whole);
      }
      else
      {
        EXPECT_TRUE(whole.empty());
      }
      EXPECT_EQ(
        GatherTable(tables.Parts[rank], TableMode::Off, ranks).size(), tables.Parts[rank].size());
    });
  return tables;
}

void ExpectEqual(const FieldArrays& made, const FieldArrays& expected)
{
  ASSERT_EQ(made.size(), expected.size());
  for (std::size_t c = 0; c < made.size(); ++c)
  {
    EXPECT_EQ(made[c].Name, expected[c].Name);
    EXPECT_TRUE(made[c].Values == expected[c].Values) << made[c].Name;
  }
}

} // namespace

TEST(FragmentTable, ListsDrops)
{
  constexpr Index drops = 10;
  const FieldArrays table = MakeTables(drops, 1, Listed::OnAll, { "density" }).Parts[0];
  for (int f = 0; f < drops; ++f)
  {
    EXPECT_EQ(ColumnOf<int>(table, "FragmentId")[f], f + 1);
    EXPECT_EQ(ColumnOf<int>(table, "MaterialId")[f], 1 + f % 2);
    EXPECT_EQ(ColumnOf<std::string>(table, "Material")[f], f % 2 ? "two" : "one");
    EXPECT_EQ(ColumnOf<Index>(table, "Elements")[f], 2);
    EXPECT_EQ(ColumnOf<double>(table, "FractionVolume")[f], TargetPerFragment * (f + 1));
    EXPECT_DOUBLE_EQ(ColumnOf<double>(table, "MeshVolume")[f], 2.0);
    EXPECT_DOUBLE_EQ(ColumnOf<double>(table, "CentroidX")[f], 1.0 + 2.0 * (f % 2));
    EXPECT_DOUBLE_EQ(ColumnOf<double>(table, "CentroidY")[f], 0.5 + 2.0 * (f / 2));
    EXPECT_EQ(ColumnOf<double>(table, "MinX")[f], 2.0 * (f % 2));
    EXPECT_EQ(ColumnOf<double>(table, "MaxX")[f], 2.0 + 2.0 * (f % 2));
    EXPECT_DOUBLE_EQ(ColumnOf<double>(table, "Mass")[f], 3.0 + 2.0 * (f % 7));
    EXPECT_EQ(ColumnOf<std::string>(table, "Neighbours")[f], std::to_string(f % 2 ? f : f + 2));
  }
}

TEST(FragmentTable, IsTheSameOnRanks)
{
  constexpr Index drops = 200;
  for (Listed how : { Listed::Nowhere, Listed::OnAll, Listed::InParts })
  {
    const FieldArrays expected = MakeTables(drops, 1, how, { "density" }).Parts[0];
    EXPECT_EQ(FindField(expected, "FractionVolume") != nullptr, how != Listed::Nowhere);
    for (int count : { 2, 3, 5, 8, 27 })
    {
      const Tables made = MakeTables(drops, count, how, { "density" });
      ExpectEqual(made.Whole, expected);
      int last = 0;
      std::size_t longest = 0;
      for (const FieldArrays& part : made.Parts)
      {
        ASSERT_EQ(part.size(), expected.size());
        const std::vector<int>& ids = ColumnOf<int>(part, "FragmentId");
        longest = std::max(longest, ids.size());
        for (int id : ids)
        {
          EXPECT_EQ(id, ++last); // ids rise with the ranks
        }
      }
      EXPECT_EQ(last, drops);
      EXPECT_LE(longest, drops / static_cast<std::size_t>(count > 2 ? 2 : 1) + 1);
    }
  }
}

/// What a rank sends to all others does not depend on the number of fragments.
TEST(FragmentTable, GathersNothingPerFragment)
{
  const Tables few = MakeTables(100, 8, Listed::InParts, {}),
               many = MakeTables(1000, 8, Listed::InParts, {});
  for (std::size_t rank = 0; rank < few.Sent.size(); ++rank)
  {
    EXPECT_EQ(few.Sent[rank].GatheredBytes, many.Sent[rank].GatheredBytes);
    EXPECT_EQ(few.Sent[rank].ReducedBytes, many.Sent[rank].ReducedBytes);
    EXPECT_EQ(few.Sent[rank].Messages, many.Sent[rank].Messages);
  }
}

TEST(FragmentTable, OmitsFragmentsWithoutElements)
{
  Drops drops = MakeDrops(4, 0, 1);
  for (int& id : drops.Fragment)
  {
    id *= 100;
  }
  Ranks alone;
  const std::vector<FragmentSummary> rows = FindFragments(ViewDrops(drops), {}, alone);
  ASSERT_EQ(rows.size(), 4u);
  for (int f = 0; f < 4; ++f)
  {
    EXPECT_EQ(rows[f].Id, 100 * (f + 1));
    EXPECT_LT(rows[f].TargetVolume, 0.0);
  }
}

TEST(FragmentTable, RejectsWrongMeshesOnAllRanks)
{
  RunOnRanks(3,
    [](ThreadRanks& ranks)
    {
      Drops drops = MakeDrops(30, ranks.Rank(), 3);
      if (ranks.Rank() == 1)
      {
        drops.Fragment[0] = 0;
      }
      EXPECT_THROW(FindFragments(ViewDrops(drops), {}, ranks), InputError);
      MeshData mesh = ViewDrops(drops);
      mesh.Fragment = nullptr;
      EXPECT_THROW(FindFragments(mesh, {}, ranks), InputError);
      EXPECT_THROW(FindFragments(ViewDrops(drops), { { "none" }, "" }, ranks), InputError);
    });
}
