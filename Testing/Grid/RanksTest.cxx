/// The mesh is the same, bit for bit, on any number of ranks and any partition.
#include "RankMeshes.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// The elements to make.
enum class Kind
{
  Hexes,
  Cells,
  Lattice
};

constexpr Kind TetKinds[] = { Kind::Cells, Kind::Lattice };

MeshMaker MakerOf(Kind kind)
{
  return kind == Kind::Hexes ? MakeHexMesh : MakeTetMesh;
}

MeshOptions OptionsOf(Kind kind)
{
  MeshOptions options;
  options.Tets = kind == Kind::Cells ? TetMethod::Cells : TetMethod::Lattice;
  return options;
}

std::map<Index, std::array<double, 5>> PointsOfFacets(const MergedMesh& mesh)
{
  std::map<Index, std::array<double, 5>> points;
  for (const auto& facet : mesh.Facets)
  {
    for (int c = 0; c < (mesh.Corners == 8 ? 4 : 3); ++c)
    {
      points[facet.first[c]] = mesh.Points.at(facet.first[c]);
    }
  }
  return points;
}

struct RankCase
{
  Kind Elements;
  std::string Mesh;
  int Ranks;
  int Axis; // of slabs, -1 boxes
};

void PrintTo(const RankCase& c, std::ostream* out)
{
  *out << c.Mesh << " on " << c.Ranks << " ranks";
}

class RanksTest : public ::testing::TestWithParam<RankCase>
{
};

std::vector<RankCase> MakeRankCases()
{
  std::vector<RankCase> cases;
  for (Kind kind : { Kind::Hexes, Kind::Cells, Kind::Lattice })
  {
    for (const char* mesh : { "sphere 16", "ball of 3 sectors", "noise", "polycrystal" })
    {
      for (int ranks : { 2, 3, 4, 8 })
      {
        cases.push_back({ kind, mesh, ranks, ranks == 3 ? 0 : (ranks == 4 ? 2 : -1) });
      }
    }
  }
  return cases;
}

} // namespace

TEST_P(RanksTest, SameMesh)
{
  const RankCase& c = this->GetParam();
  const bool noise = c.Mesh == "noise", grains = c.Mesh == "polycrystal";
  const CartesianGrid cube = MakeUnitGrid(12, 11, 13);
  const MeshCase shape =
    grains ? MakePolycrystalCase(12, 14) : MakeMeshCase(noise ? "sphere 8" : c.Mesh);
  const CartesianGrid& grid = noise ? cube : shape.Grid;
  const FractionField field = noise ? MakeRandomLabels(cube, 4, 0, 5) : shape.Fractions;
  std::vector<IndexBox> boxes;
  CutBox(grid.Global(), c.Ranks, c.Axis, boxes);
  MeshOptions options = OptionsOf(c.Elements);
  options.MeshVoid = noise && c.Ranks == 2;
  CompareWithSerial(grid, field, boxes, options, MakerOf(c.Elements));
}

INSTANTIATE_TEST_SUITE_P(Cases, RanksTest, ::testing::ValuesIn(MakeRankCases()),
  [](const ::testing::TestParamInfo<RankCase>& info)
  {
    const Kind kind = info.param.Elements;
    std::string name = kind == Kind::Hexes ? "" : "Tets_" + NameOf(OptionsOf(kind).Tets) + "_";
    name += info.param.Mesh + "_" + std::to_string(info.param.Ranks);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

TEST(Ranks, OneRankMayBeEmpty)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 2, -1, boxes);
  boxes.insert(boxes.begin() + 1, IndexBox());
  CompareWithSerial(c.Grid, c.Fractions, boxes, MeshOptions());
  for (Kind kind : TetKinds)
  {
    CompareWithSerial(c.Grid, c.Fractions, boxes, OptionsOf(kind), MakeTetMesh);
  }
}

TEST(Ranks, SlabsThinnerThanTheGhostLayers)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 14, 1, boxes);
  CompareWithSerial(c.Grid, c.Fractions, boxes, MeshOptions());
  for (Kind kind : TetKinds)
  {
    CompareWithSerial(c.Grid, c.Fractions, boxes, OptionsOf(kind), MakeTetMesh);
  }
}

TEST(Ranks, ThirtyThree)
{
  const MeshCase c = MakeMeshCase("sphere 16");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 33, -1, boxes);
  CompareWithSerial(c.Grid, c.Fractions, boxes, MeshOptions());
  for (Kind kind : TetKinds)
  {
    CompareWithSerial(c.Grid, c.Fractions, boxes, OptionsOf(kind), MakeTetMesh);
  }
}

TEST(Ranks, StairStepAndSmoothingOff)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 4, -1, boxes);
  for (Kind kind : { Kind::Hexes, Kind::Cells, Kind::Lattice })
  {
    MeshOptions options = OptionsOf(kind);
    options.StairStep = true;
    CompareWithSerial(c.Grid, c.Fractions, boxes, options, MakerOf(kind));
    options.StairStep = false;
    options.Method = Smoothing::Off;
    CompareWithSerial(c.Grid, c.Fractions, boxes, options, MakerOf(kind));
  }
}

TEST(Ranks, PartsOfTetGenMatch)
{
  if (!HasTetGen())
  {
    GTEST_SKIP() << "built without TetGen";
  }
  for (const char* name : { "sphere 16", "12 grains", "noise" })
  {
    const bool noise = std::string(name) == "noise", grains = std::string(name) == "12 grains";
    const CartesianGrid cube = MakeUnitGrid(7, 8, 6);
    const MeshCase shape =
      grains ? MakePolycrystalCase(12, 14) : MakeMeshCase(noise ? "sphere 8" : name);
    const CartesianGrid& grid = noise ? cube : shape.Grid;
    const FractionField field = noise ? MakeRandomLabels(cube, 3, 0, 5) : shape.Fractions;
    for (int ranks : { 1, 2, 4 })
    {
      SCOPED_TRACE(name + (" on " + std::to_string(ranks)));
      std::vector<IndexBox> boxes;
      CutBox(grid.Global(), ranks, -1, boxes);
      MeshOptions options;
      options.Tets = TetMethod::TetGen;
      const Meshes both = MakeBoth(grid, field, boxes, options, MakeTetMesh);
      const Mesh serial = both.Serial.Join(), merged = both.Merged.Join();
      EXPECT_EQ(FindTopologyProblem(merged), "");
      EXPECT_EQ(FindFragmentProblem(merged), "");
      EXPECT_GT(SmallestCornerDeterminant(merged), 0.0);
      EXPECT_EQ(CountDifferences(both.Merged.Facets, both.Serial.Facets), 0u) << "facets";
      EXPECT_EQ(CountDifferences(PointsOfFacets(both.Merged), PointsOfFacets(both.Serial)), 0u)
        << "points of facets";
      for (int m = 1; m <= field.NumberOfMaterials(); ++m)
      {
        const double volume = MeasureVolume(serial, m);
        EXPECT_NEAR(MeasureVolume(merged, m), volume, 1e-9 * volume) << "material " << m;
        for (const MeshReport& report : both.Reports)
        {
          EXPECT_NEAR(report.MeshVolume[m], volume, 1e-9 * volume) << "material " << m;
        }
      }
      std::printf("%s on %d ranks: %zu tets, dihedral %.1f - %.1f, %lld parts refused\n", name,
        ranks, both.Merged.Elements.size(), both.Reports[0].MinimumDihedralAngle,
        both.Reports[0].MaximumDihedralAngle, static_cast<long long>(both.Reports[0].RefusedParts));
    }
  }
}
