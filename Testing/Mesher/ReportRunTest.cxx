/// Tables of a run on ranks: of the whole mesh, or of what a rank touches.
#include "Phases/ReportRun.h"

#include "ModifyMesh.h"
#include "Parts/PartCases.h"
#include "Report/Gather/GatherMesh.h"
#include "Report/MeshFacets.h"
#include "State/ViewMesh.h"
#include "SurfaceRuns.h"

#include <gtest/gtest.h>

#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

SurfaceCase MakeBracket()
{
  return { { { 24, 24, 20 } },
    { { Turned(BracketBody("bracket", 14.3, 4.2, 9.1), { { 9.7, 5.2, 2.3 } }) } } };
}

/// Element, side and smooth side of facets.
std::vector<std::array<Index, 3>> SidesOf(const std::vector<MeshFacet>& facets)
{
  std::vector<std::array<Index, 3>> sides;
  for (const MeshFacet& facet : facets)
  {
    sides.push_back({ { facet.Element, facet.Side, facet.Surface } });
  }
  return sides;
}

/// Expects the same facets from the mesher and from a search in its arrays and fields.
void ExpectSameFacets(MeshData data, Ranks& ranks)
{
  const std::vector<MeshFacet> made = *data.Facets;
  data.Facets = nullptr;
  EXPECT_EQ(SidesOf(FindMeshFacets(data, ranks)), SidesOf(made)) << ranks.Rank();
}

struct TableRun
{
  std::size_t LeastRows = 0, Warnings = 0;
  bool HasNames = false, AreWhole = false;
  MergedMesh Layered; ///< the mesh after layers were cut into it, without tables
};

TableRun RunOnThree(TableMode mode)
{
  TableRun run;
  std::mutex mutex;
  RunOnRanks(3,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      MesherInput input = MakeSurfaceInput(MakeBracket(), ranks);
      input.Warn = [&run](const std::string& text)
      { run.Warnings += text.find("WholeTables") != std::string::npos ? 1 : 0; };
      MesherOptions options;
      options.WholeTables = mode;
      const MesherResult result = RunMesher(input, options, runtime);
      const MeshData data = ViewMesh(result.TheMesh, result.State, result.Fields);
      ExpectSameFacets(data, ranks);
      const StoredMesh whole = GatherMesh(data, ranks);
      if (ranks.Rank() == 0)
      {
        Ranks alone;
        ExpectSameFacets(whole.Data, alone);
      }
      MesherOptions layers;
      layers.Layers = 2;
      layers.FirstLayer = 0.3;
      layers.FirstLayerUnit = ThicknessUnit::Length;
      ModifiedMesh modified = ModifyMesh({ data, {}, {}, {}, {} }, layers, runtime);
      const GeometryTables& tables = result.TheMesh.Tables;
      const std::lock_guard<std::mutex> lock(mutex);
      EXPECT_EQ(tables.HasAllSurfaces, tables.HasAllCurves);
      run.AreWhole = tables.HasAllSurfaces;
      run.HasNames = FindField(result.Fields, "PatchNames") != nullptr;
      const std::size_t rows = tables.SurfaceVolumes.size();
      run.LeastRows = run.LeastRows == 0 ? rows : std::min(run.LeastRows, rows);
      EXPECT_EQ(tables.SurfaceIds.size(), run.AreWhole ? 0u : rows);
      modified.TheMesh.Tables = {};
      run.Layered.Add(modified.TheMesh);
    });
  return run;
}

} // namespace

TEST(ReportRun, TablesAreWholeOrThoseOfTheRank)
{
  const TableRun expected = RunOnThree(TableMode::Automatic);
  EXPECT_TRUE(expected.AreWhole);
  EXPECT_TRUE(expected.HasNames);
  EXPECT_EQ(expected.Warnings, 0u);
  EXPECT_GT(expected.Layered.Facets.size(), 100u);
  for (TableMode mode : { TableMode::On, TableMode::Off })
  {
    const TableRun made = RunOnThree(mode);
    const bool isWhole = mode == TableMode::On;
    EXPECT_EQ(made.AreWhole, isWhole);
    EXPECT_EQ(made.HasNames, isWhole);
    EXPECT_EQ(made.Warnings, isWhole ? 0u : 1u);
    EXPECT_LE(made.LeastRows, expected.LeastRows);
    EXPECT_EQ(CountDifferences(made.Layered.Points, expected.Layered.Points), 0u);
    EXPECT_EQ(CountDifferences(made.Layered.Elements, expected.Layered.Elements), 0u);
    EXPECT_EQ(CountDifferences(made.Layered.Facets, expected.Layered.Facets), 0u);
  }
}
