/// The report of a mesh is the same from any number of ranks, even if one has no element.
#include "Report/Gather/GatherMesh.h"
#include "RankMeshes.h"
#include "Report/FragmentTargets.h"
#include "Report/Fragments/FragmentTable.h"
#include "Report/Sets/MeshSets.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace vfm;
using namespace vfm::testing;

namespace
{

template <class T>
std::vector<T> ListOf(const T* values, Index count)
{
  return { values, values + count };
}

/// The whole mesh and its summaries.
struct Report
{
  std::vector<double> Points;
  std::vector<Index> Elements, PointIds, ElementIds;
  std::vector<int> Material;
  std::vector<std::tuple<Index, int, int, int, int>> Facets;
  std::vector<std::string> Arrays;
  FieldArrays Fragments;
  std::vector<std::pair<int, std::string>> Sets;
  std::vector<double> Targets; ///< volumes of the fractions of fragments
};

Report Describe(const MeshData& whole)
{
  Report report;
  report.Points = ListOf(whole.Points, 3 * whole.NumberOfPoints);
  report.Elements = ListOf(whole.Elements, whole.Corners * whole.NumberOfElements);
  report.PointIds = ListOf(whole.PointIds, whole.NumberOfPoints);
  report.ElementIds = ListOf(whole.ElementIds, whole.NumberOfElements);
  report.Material = ListOf(whole.Material, whole.NumberOfElements);
  for (const MeshFacet& facet : *whole.Facets)
  {
    report.Facets.emplace_back(
      facet.Element, facet.Side, facet.Behind, facet.Surface, facet.DomainSide);
  }
  report.Targets = NumbersOfField(whole.Fields, "FragmentTargetVolume");
  for (const std::vector<MeshArray>& arrays : { whole.PointArrays, whole.ElementArrays })
  {
    for (const MeshArray& array : arrays)
    {
      report.Arrays.push_back(array.Name);
    }
  }
  return report;
}

/// Returns the report of rank 0. boxes: one per rank.
Report MakeReport(
  const CartesianGrid& whole, const FractionField& field, const std::vector<IndexBox>& boxes)
{
  Report report;
  RunOnRanks(static_cast<int>(boxes.size()),
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()], LayersFor(LevelPlan()));
      RankRuntime runtime(ranks);
      MeshReport measured;
      const Mesh mesh =
        MakeHexMesh(grid, CopyToLocal(whole, field, grid), MeshOptions(), runtime, measured);
      FieldArrays fields = ListDomain(whole, ImageFrame());
      AppendFields(
        ListFragmentTargets(measured.Fragments, TableMode::Off, measured.NumberOfFragments, ranks),
        fields);
      fields.push_back({ "NumberOfFragments", std::vector<Index>{ measured.NumberOfFragments } });
      const MeshData data = ViewMesh(mesh, OutputState(), fields);
      const StoredMesh gathered = GatherMesh(data, ranks);
      const FieldArrays fragments =
        GatherTable(MakeFragmentTable(data, {}, ranks), TableMode::On, ranks);
      const MeshSets sets = FindMeshSets(OrderMesh(data, ranks).Data, ranks);
      if (ranks.Rank() == 0)
      {
        report = Describe(gathered.Data);
        report.Fragments = fragments;
        for (const SideSet& set : sets.SideSets)
        {
          report.Sets.emplace_back(set.Id, set.Name);
        }
      }
    });
  return report;
}

void ExpectEqual(const Report& made, const Report& alone)
{
  EXPECT_EQ(made.Points, alone.Points);
  EXPECT_EQ(made.Elements, alone.Elements);
  EXPECT_EQ(made.PointIds, alone.PointIds);
  EXPECT_EQ(made.ElementIds, alone.ElementIds);
  EXPECT_EQ(made.Material, alone.Material);
  EXPECT_EQ(made.Facets, alone.Facets);
  EXPECT_EQ(made.Arrays, alone.Arrays);
  EXPECT_EQ(made.Sets, alone.Sets);
  EXPECT_EQ(made.Targets, alone.Targets);
  ASSERT_EQ(made.Fragments.size(), alone.Fragments.size());
  for (std::size_t column = 0; column < made.Fragments.size(); ++column)
  {
    EXPECT_EQ(made.Fragments[column].Name, alone.Fragments[column].Name);
    EXPECT_TRUE(made.Fragments[column].Values == alone.Fragments[column].Values)
      << made.Fragments[column].Name;
  }
}

} // namespace

TEST(GatherMesh, IsTheMeshOfOneRank)
{
  const MeshCase c = MakeSphereCase(8);
  const IndexBox box = c.Grid.Global();
  const Report alone = MakeReport(c.Grid, c.Fractions, { box });
  EXPECT_GT(alone.Facets.size(), 100u);
  EXPECT_FALSE(alone.Sets.empty());
  EXPECT_EQ(alone.Targets.size(), 1u);
  ExpectEqual(MakeReport(c.Grid, c.Fractions, CutBox(box, 2)), alone);
  ExpectEqual(MakeReport(c.Grid, c.Fractions, CutBox(box, 5, 0)), alone); // rank 0 has no element
}

TEST(GatherMesh, RejectsMeshesTooLongForOneFile)
{
  for (Index MeshData::*count : { &MeshData::NumberOfElements, &MeshData::NumberOfPoints })
  {
    RunOnRanks(2,
      [count](Ranks& ranks)
      {
        MeshData mesh; // its arrays are not read
        mesh.*count = Index(1) << 30;
        try
        {
          GatherMesh(mesh, ranks);
          ADD_FAILURE();
        }
        catch (const InputError& error)
        {
          EXPECT_NE(std::string(error.what()).find("choose files per rank"), std::string::npos)
            << error.what();
        }
      });
  }
}
