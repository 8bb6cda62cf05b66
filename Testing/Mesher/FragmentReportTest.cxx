/// Tables and summaries of many fragments are the same from any number of ranks, although no rank
/// has a list of all fragments.
#include "LabelInput.h"
#include "RankFields.h"
#include "Report/Fragments/FragmentTable.h"
#include "Report/MeshSummary.h"
#include "State/ViewMesh.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const LabelGrid Grid{ { { 10, 8, 16 } }, 0.1, 0.25 };

struct Outcome
{
  FieldArrays Table; ///< of rank 0
  MeshSummary Summary;
};

/// Meshes random labels. Each rank lists the fragments that it counts.
Outcome Report(int count, int periodic)
{
  MesherOptions options;
  options.Periodic = periodic;
  options.WholeTables = TableMode::Off;
  options.StairStep = true;
  const std::vector<int> labels = RandomLabels(Grid.Cells, 3);
  Outcome outcome;
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      const MesherResult result = RunMesher(MakeLabelInput(Grid, labels, ranks), options, runtime);
      EXPECT_EQ(FindField(result.Fields, "FragmentTargetVolume") != nullptr, count == 1);
      EXPECT_EQ(FindField(result.Fields, "RankFragments") != nullptr, count > 1);
      const MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
      const FieldArrays table =
        GatherTable(MakeFragmentTable(mesh, {}, ranks), TableMode::On, ranks);
      const MeshSummary summary = Summarise(mesh, ranks);
      if (ranks.Rank() == 0)
      {
        outcome = { table, summary };
      }
    });
  return outcome;
}

void ExpectEqual(const PartSizes& made, const PartSizes& expected)
{
  EXPECT_EQ(made.Material, expected.Material);
  EXPECT_EQ(made.Elements, expected.Elements);
  EXPECT_EQ(made.Points, expected.Points);
  EXPECT_EQ(made.MinimumQuality, expected.MinimumQuality);
  EXPECT_EQ(made.MeanQuality, expected.MeanQuality);
  EXPECT_EQ(made.Volume, expected.Volume);
}

void ExpectEqual(const Outcome& made, const Outcome& expected)
{
  ASSERT_EQ(made.Table.size(), expected.Table.size());
  for (std::size_t c = 0; c < made.Table.size(); ++c)
  {
    EXPECT_EQ(made.Table[c].Name, expected.Table[c].Name);
    EXPECT_TRUE(made.Table[c].Values == expected.Table[c].Values) << made.Table[c].Name;
  }
  const MeshSummary &one = made.Summary, &other = expected.Summary;
  ExpectEqual(one.Total, other.Total);
  EXPECT_EQ(one.NumberOfFragments, other.NumberOfFragments);
  ASSERT_EQ(one.LargestFragments.size(), other.LargestFragments.size());
  for (std::size_t f = 0; f < one.LargestFragments.size(); ++f)
  {
    EXPECT_EQ(one.LargestFragments[f].Id, other.LargestFragments[f].Id);
    ExpectEqual(one.LargestFragments[f], other.LargestFragments[f]);
  }
}

/// Checks the largest fragments of a summary by the table.
void CheckSummary(const Outcome& outcome)
{
  const auto& volumes =
    std::get<std::vector<double>>(FindField(outcome.Table, "MeshVolume")->Values);
  const auto& elements = std::get<std::vector<Index>>(FindField(outcome.Table, "Elements")->Values);
  const std::vector<FragmentSizes>& largest = outcome.Summary.LargestFragments;
  ASSERT_EQ(largest.size(), MaximumFragments);
  EXPECT_EQ(outcome.Summary.NumberOfFragments, static_cast<Index>(volumes.size()));
  EXPECT_GT(volumes.size(), MaximumFragments);
  for (const FragmentSizes& fragment : largest)
  {
    EXPECT_NEAR(fragment.Volume, volumes[fragment.Id - 1], 1e-12);
    EXPECT_EQ(fragment.Elements, elements[fragment.Id - 1]);
    EXPECT_GE(fragment.Points, 8);
  }
  EXPECT_TRUE(std::is_sorted(largest.begin(), largest.end()));
  const auto larger = std::count_if(volumes.begin(), volumes.end(),
    [&](double volume) { return volume > largest.back().Volume * (1.0 + 1e-9); });
  EXPECT_LT(larger, static_cast<std::ptrdiff_t>(MaximumFragments));
}

} // namespace

TEST(FragmentReport, IsTheSameOnRanks)
{
  for (int periodic : { 0, 5 })
  {
    const Outcome expected = Report(1, periodic);
    EXPECT_NE(FindField(expected.Table, "FractionVolume"), nullptr);
    CheckSummary(expected);
    for (int count : { 3, 8 })
    {
      ExpectEqual(Report(count, periodic), expected);
    }
  }
}
