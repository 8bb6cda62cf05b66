/// The mesh is bitwise identical on any number of ranks and for any partition.
#include "GeometryChecks.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Type of element and method.
enum class Kind
{
  Hexes,
  Cells,
  Lattice
};

MeshMaker MakerOf(Kind kind)
{
  return kind == Kind::Hexes ? MakeHexMesh : MakeTetMesh;
}

MeshOptions OptionsOf(Kind kind)
{
  MeshOptions options;
  options.Method = kind == Kind::Cells ? TetMethod::Cells : TetMethod::Lattice;
  return options;
}

/// A field and the partitions of its grid.
struct RankCase
{
  std::string Mesh;
  std::vector<std::vector<IndexBox>> (*Cuts)(const IndexBox&);
  bool MeshVoid = false;
};

std::vector<std::vector<IndexBox>> CutInSlabs(const IndexBox& box)
{
  return { CutBox(box, 3, 0), CutBox(box, 4, 2) };
}

std::vector<std::vector<IndexBox>> CutInBlocks(const IndexBox& box)
{
  return { CutBox(box, 2), CutBox(box, 8) };
}

std::vector<std::vector<IndexBox>> CutInBoth(const IndexBox& box)
{
  return { CutBox(box, 2), CutBox(box, 3, 0), CutBox(box, 4, 2), CutBox(box, 8) };
}

std::vector<std::vector<IndexBox>> CutInMany(const IndexBox& box)
{
  return { CutBox(box, 2), CutBox(box, 3, 0), CutBox(box, 4, 2), CutBox(box, 8), CutBox(box, 33) };
}

/// Returns partitions with empty ranks, cut along all axes or one, and slabs
/// thinner than the ghost layers.
std::vector<std::vector<IndexBox>> CutOddly(const IndexBox& box)
{
  std::vector<std::vector<IndexBox>> cuts{ CutBox(box, 2), CutBox(box, 14, 1) };
  cuts[0].insert(cuts[0].begin() + 1, IndexBox());
  for (int axis = 0; axis < 3; ++axis)
  {
    cuts[0].push_back(box);
    cuts[0].back().Lower[axis] = box.Upper[axis];
  }
  return cuts;
}

using RankParameters = std::tuple<Kind, RankCase>;

void PrintTo(const RankCase& c, std::ostream* out)
{
  *out << c.Mesh;
}

class RanksTest : public ::testing::TestWithParam<RankParameters>
{
};

} // namespace

TEST_P(RanksTest, SameMesh)
{
  const Kind kind = std::get<0>(this->GetParam());
  const RankCase& c = std::get<1>(this->GetParam());
  const bool noise = c.Mesh == "noise", grains = c.Mesh == "12 grains";
  const CartesianGrid cube = MakeUnitGrid(12, 11, 13);
  const MeshCase shape =
    grains ? MakePolycrystalCase(12, 14) : MakeMeshCase(noise ? "sphere 8" : c.Mesh);
  const CartesianGrid& grid = noise ? cube : shape.Grid;
  const FractionField field = noise ? MakeRandomLabels(cube, 4, 0, 5) : shape.Fractions;
  MeshOptions options = OptionsOf(kind);
  options.MeshVoid = c.MeshVoid;
  CompareWithSerial(grid, field, c.Cuts(grid.Global()), options, MakerOf(kind));
}

INSTANTIATE_TEST_SUITE_P(Cases, RanksTest,
  ::testing::Combine(::testing::Values(Kind::Hexes, Kind::Cells, Kind::Lattice),
    ::testing::Values(RankCase{ "sphere 8", CutOddly }, RankCase{ "sphere 16", CutInMany },
      RankCase{ "ball of 3 sectors", CutInBoth }, RankCase{ "12 grains", CutInBoth },
      RankCase{ "half sphere", CutInBoth }, RankCase{ "noise", CutInSlabs },
      RankCase{ "noise", CutInBlocks, true })),
  [](const ::testing::TestParamInfo<RankParameters>& info)
  {
    const Kind kind = std::get<0>(info.param);
    const RankCase& c = std::get<1>(info.param);
    std::string name = (kind == Kind::Hexes ? "Hexes" : NameOf(OptionsOf(kind).Method)) + "_" +
      c.Mesh + (c.MeshVoid ? "_and_void" : "");
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

TEST(Ranks, StairStepAndSmoothingOff)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  const std::vector<std::vector<IndexBox>> cuts{ CutBox(c.Grid.Global(), 4) };
  for (Kind kind : { Kind::Hexes, Kind::Cells, Kind::Lattice })
  {
    MeshOptions options = OptionsOf(kind);
    options.StairStep = true;
    CompareWithSerial(c.Grid, c.Fractions, cuts, options, MakerOf(kind));
    options.StairStep = false;
    options.Smoothing = SmoothingMethod::Off;
    CompareWithSerial(c.Grid, c.Fractions, cuts, options, MakerOf(kind));
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
    MeshOptions options;
    options.Method = TetMethod::TetGen;
    const RankMesh alone = MakeAlone(grid, field, options, MakeTetMesh);
    const Mesh serial = alone.Merged.Join();
    for (int ranks : { 1, 2, 4 })
    {
      SCOPED_TRACE(name + (" on " + std::to_string(ranks)));
      const RankMesh made =
        MakeOnRanks(grid, field, CutBox(grid.Global(), ranks), options, MakeTetMesh);
      const Mesh merged = made.Merged.Join();
      EXPECT_EQ(FindTopologyProblem(merged), "");
      EXPECT_EQ(FindFragmentProblem(merged), "");
      EXPECT_GT(SmallestCornerDeterminant(merged), 0.0);
      EXPECT_EQ(FindGeometryDifference(made.Merged, alone.Merged), "");
      EXPECT_EQ(FindGeometryProblem(made.Merged), "");
      for (int m = 1; m <= field.NumberOfMaterials(); ++m)
      {
        const double volume = MeasureVolume(serial, m);
        EXPECT_NEAR(MeasureVolume(merged, m), volume, 1e-13 * volume) << "material " << m;
        for (const MeshReport& report : made.Reports)
        {
          EXPECT_NEAR(report.MeshVolume[m], volume, 1e-13 * volume) << "material " << m;
        }
      }
      std::printf("%s on %d ranks: %zu tets, dihedral %.1f - %.1f, %lld parts rejected\n", name,
        ranks, made.Merged.Elements.size(), made.Reports[0].MinimumDihedralAngle,
        made.Reports[0].MaximumDihedralAngle, static_cast<long long>(made.Reports[0].RefusedParts));
    }
  }
}
