/// The mesher's facets equal the facets found by a search and give the same sets, on any ranks.
#include "Report/MeshFacets.h"
#include "Geometry/EdgeFacets.h"
#include "Geometry/GatherTables.h"
#include "RankMeshes.h"
#include "Report/MeshFields.h"
#include "SharpCases.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Row = std::tuple<Index, int, int, int, int>;

std::vector<Row> ToRows(const std::vector<MeshFacet>& facets)
{
  std::vector<Row> rows;
  for (const MeshFacet& facet : facets)
  {
    rows.emplace_back(facet.Element, facet.Side, facet.Behind, facet.Surface, facet.DomainSide);
  }
  return rows;
}

/// Totals over all ranks.
struct Counts
{
  std::int64_t Facets = 0, OnSmoothSides = 0, OnDomain = 0, Inside = 0;
};

Counts CountFacets(const std::vector<MeshFacet>& facets, Ranks& ranks)
{
  std::vector<std::int64_t> counts(4, 0);
  for (const MeshFacet& facet : facets)
  {
    ++counts[0];
    counts[1] += facet.Surface > 0;
    counts[2] += facet.DomainSide >= 0;
    counts[3] += facet.Behind != NothingBehind;
  }
  ranks.Sum(counts);
  return { counts[0], counts[1], counts[2], counts[3] };
}

/// Expects the same facets from the mesher and from a search.
std::vector<MeshFacet> Compare(const CartesianGrid& whole, const ImageFrame& frame,
  const Mesh& mesh, const GeometryTables& tables, Ranks& ranks)
{
  MeshData data = ViewMesh(mesh, OutputState(), ListSides(tables));
  for (FieldArray& field : ListDomain(whole, frame))
  {
    data.Fields.push_back(std::move(field));
  }
  std::vector<MeshFacet> made = FindMeshFacets(data, ranks);
  data.Facets = nullptr;
  EXPECT_EQ(ToRows(made), ToRows(FindMeshFacets(data, ranks)))
    << ranks.Rank() << " of " << ranks.Count();
  return made;
}

/// Compares with the tables of the rank and with those of the whole mesh.
std::vector<MeshFacet> Compare(
  const CartesianGrid& whole, const ImageFrame& frame, const Mesh& mesh, Ranks& ranks)
{
  GeometryTables tables = mesh.Tables;
  GatherSurfaceTables(ranks, tables);
  Compare(whole, frame, mesh, tables, ranks);
  tables = mesh.Tables;
  tables.EdgeFacets = ListEdgeFacetsOfElements(mesh);
  return Compare(whole, frame, mesh, tables, ranks);
}

/// Returns the counts on one rank; expects the same on several.
Counts CompareOnRanks(const CartesianGrid& whole, const FractionField& field,
  const MeshOptions& options, MeshMaker make)
{
  Counts alone;
  const bool isTetGen = make == MakeTetMesh && options.Method == TetMethod::TetGen;
  for (int count : { 1, 3 })
  {
    const std::vector<IndexBox> boxes = CutBaseBox(whole, options.Levels.Refinements, count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const GridLayers layers = isTetGen ? GridLayers() : LayersFor(options.Levels);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()], layers);
        RankRuntime runtime(ranks);
        MeshReport report;
        const Mesh mesh = make(grid, CopyToLocal(whole, field, grid), options, runtime, report);
        const Counts counts = CountFacets(Compare(whole, ImageFrame(), mesh, ranks), ranks);
        if (count == 1)
        {
          alone = counts;
        }
        EXPECT_EQ(counts.OnDomain > 0, alone.OnDomain > 0);
        if (!isTetGen || counts.OnDomain == 0)
        {
          EXPECT_EQ(counts.Facets, alone.Facets);
          EXPECT_EQ(counts.OnSmoothSides, alone.OnSmoothSides);
          EXPECT_EQ(counts.Inside, alone.Inside);
        }
      });
  }
  EXPECT_GT(alone.Facets, 0);
  return alone;
}

struct Kind
{
  const char* Name;
  MeshMaker Make;
  TetMethod Tets;
};

const Kind Kinds[] = { { "hexes", MakeHexMesh, TetMethod::Lattice },
  { "Lattice", MakeTetMesh, TetMethod::Lattice }, { "Cells", MakeTetMesh, TetMethod::Cells },
#ifdef VFM_HAS_TETGEN
  { "TetGen", MakeTetMesh, TetMethod::TetGen }
#endif
};

} // namespace

TEST(MeshFacets, OfTheMesherAreTheOnesThatASearchFinds)
{
  for (const Kind& kind : Kinds)
  {
    for (bool meshVoid : { false, true })
    {
      SCOPED_TRACE(std::string(kind.Name) + (meshVoid ? ", with void" : ""));
      const MeshCase c = MakePolycrystalCase(3, 6);
      MeshOptions options;
      options.Method = kind.Tets;
      options.MeshVoid = meshVoid;
      const Counts all = CompareOnRanks(c.Grid, c.Fractions, options, kind.Make);
      EXPECT_GT(all.OnDomain, 200);
      EXPECT_GT(all.Inside, 40);
    }
  }
}

TEST(MeshFacets, OfSmoothSides)
{
  for (const Kind& kind : Kinds)
  {
    SCOPED_TRACE(kind.Name);
    const SharpCase c = MakeSharpCase("cube A in matrix", 12);
    MeshOptions options;
    options.Method = kind.Tets;
    options.SharpEdges = SharpEdgeMode::On;
    EXPECT_GT(CompareOnRanks(c.Grid, c.Fractions, options, kind.Make).OnSmoothSides, 100);
  }
}

TEST(MeshFacets, OfRefinedGrids)
{
  const CartesianGrid grid = MakeUnevenGrid(12);
  const FractionField field = MakeBlockLabels(grid, 2, 3);
  for (const Kind& kind : Kinds)
  {
    for (bool fine : { true, false })
    {
      SCOPED_TRACE(std::string(kind.Name) + (fine ? "" : ", interfaces across levels"));
      MeshOptions options;
      options.Method = kind.Tets;
      options.Levels.Refinements = 2;
      options.Levels.FineInterfaces = fine;
      options.Levels.Families = MakeRandomFamilies(grid, 2, 0.05, 5);
      const Counts all = CompareOnRanks(grid, field, options, kind.Make);
      EXPECT_GT(all.OnDomain, 50);
    }
  }
}

TEST(MeshFacets, OfMirroredImages)
{
  for (const Kind& kind : Kinds)
  {
    SCOPED_TRACE(kind.Name);
    const MeshCase c = MakePolycrystalCase(3, 6);
    MeshOptions options;
    options.Method = kind.Tets;
    Runtime serial;
    MeshReport report;
    Mesh mesh = kind.Make(c.Grid, c.Fractions, options, serial, report);
    const ImageFrame frame =
      MakeImageFrame({ { 0, 1, 0, 1, 0, 0, 0, 0, 1 } }, { { 1, 2, 3 } }, "image");
    ASSERT_TRUE(frame.IsMirrored());
    TurnMesh(frame, mesh);
    EXPECT_GT(Compare(c.Grid, frame, mesh, serial.Group()).size(), 200u);
  }
}
