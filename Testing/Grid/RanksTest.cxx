/// The mesh is the same, bit for bit, on any number of ranks and any partition.
#include "MeshCases.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// What a mesh is made of, by global id.
struct MergedMesh
{
  std::map<Index, std::array<double, 5>> Points; // coordinates, dimension, geometry
  std::map<Index, std::array<double, 11>> Hexes; // ids of points, material, fragment, quality
  std::map<std::array<Index, 4>, std::array<int, 4>> Quads;
  int Conflicts = 0;

  void Add(const HexMesh& m)
  {
    for (std::size_t p = 0; p < m.PointIds.size(); ++p)
    {
      const std::array<double, 5> point{ { m.Points[3 * p], m.Points[3 * p + 1],
        m.Points[3 * p + 2], 1.0 * m.GeometryDimension[p], 1.0 * m.GeometryId[p] } };
      const auto at = this->Points.emplace(m.PointIds[p], point);
      this->Conflicts += at.first->second != point;
    }
    for (std::size_t h = 0; h < m.HexIds.size(); ++h)
    {
      std::array<double, 11> hex;
      for (int c = 0; c < 8; ++c)
      {
        hex[c] = static_cast<double>(m.PointIds[m.Hexes[8 * h + c]]);
      }
      hex[8] = m.Material[h];
      hex[9] = m.Fragment[h];
      hex[10] = m.ScaledJacobian[h];
      this->Conflicts += !this->Hexes.emplace(m.HexIds[h], hex).second;
    }
    const SurfaceQuads& s = m.Surfaces;
    for (std::size_t q = 0; q < s.SurfaceId.size(); ++q)
    {
      std::array<Index, 4> points;
      for (int c = 0; c < 4; ++c)
      {
        points[c] = m.PointIds[s.Points[4 * q + c]];
      }
      this->Conflicts += !this->Quads
                            .emplace(points,
                              std::array<int, 4>{ { s.SurfaceId[q], s.MaterialPair[2 * q],
                                s.MaterialPair[2 * q + 1], s.DomainSide[q] } })
                            .second;
    }
  }
};

bool operator==(const HexMeshReport& a, const HexMeshReport& b)
{
  return a.TargetVolume == b.TargetVolume && a.MeshVolume == b.MeshVolume &&
    a.FlippedCells == b.FlippedCells && a.ResolveRounds == b.ResolveRounds &&
    a.NumberOfFragments == b.NumberOfFragments && a.NumberOfSurfaces == b.NumberOfSurfaces &&
    a.NumberOfCurves == b.NumberOfCurves && a.NumberOfVertices == b.NumberOfVertices &&
    a.MinimumScaledJacobian == b.MinimumScaledJacobian &&
    a.MeanScaledJacobian == b.MeanScaledJacobian;
}

/// Meshes on ranks, each with one of the boxes, and compares with the mesh of one process.
void CompareWithSerial(const CartesianGrid& whole, const FractionField& field,
  const std::vector<IndexBox>& boxes, const HexMeshOptions& options)
{
  Runtime alone;
  HexMeshReport report;
  MergedMesh serial, merged;
  serial.Add(MakeHexMesh(whole, field, options, alone, report));
  const int count = static_cast<int>(boxes.size());
  std::vector<HexMesh> meshes(count);
  std::vector<HexMeshReport> reports(count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      RankRuntime runtime(ranks);
      meshes[ranks.Rank()] =
        MakeHexMesh(grid, CopyToLocal(whole, field, grid), options, runtime, reports[ranks.Rank()]);
    });
  for (int rank = 0; rank < count; ++rank)
  {
    merged.Add(meshes[rank]);
    EXPECT_TRUE(reports[rank] == report) << "rank " << rank;
  }
  EXPECT_EQ(serial.Conflicts, 0);
  EXPECT_EQ(merged.Conflicts, 0);
  EXPECT_TRUE(merged.Points == serial.Points);
  EXPECT_TRUE(merged.Hexes == serial.Hexes);
  EXPECT_TRUE(merged.Quads == serial.Quads);
}

struct RankCase
{
  std::string Mesh;
  int Ranks;
  int Axis; // of slabs, -1 boxes
};

class RanksTest : public ::testing::TestWithParam<RankCase>
{
};

std::vector<RankCase> MakeRankCases()
{
  std::vector<RankCase> cases;
  for (const char* mesh : { "sphere 16", "ball of 3 sectors", "noise", "polycrystal" })
  {
    for (int ranks : { 2, 3, 4, 8 })
    {
      cases.push_back({ mesh, ranks, ranks == 3 ? 0 : (ranks == 4 ? 2 : -1) });
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
  HexMeshOptions options;
  options.MeshVoid = noise && c.Ranks == 2;
  CompareWithSerial(grid, field, boxes, options);
}

INSTANTIATE_TEST_SUITE_P(Cases, RanksTest, ::testing::ValuesIn(MakeRankCases()),
  [](const ::testing::TestParamInfo<RankCase>& info)
  {
    std::string name = info.param.Mesh + "_" + std::to_string(info.param.Ranks);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

TEST(Ranks, OneRankMayBeEmpty)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 2, -1, boxes);
  boxes.insert(boxes.begin() + 1, IndexBox());
  CompareWithSerial(c.Grid, c.Fractions, boxes, HexMeshOptions());
}

TEST(Ranks, SlabsThinnerThanTheGhostLevels)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 14, 1, boxes);
  CompareWithSerial(c.Grid, c.Fractions, boxes, HexMeshOptions());
}

TEST(Ranks, ThirtyThree)
{
  const MeshCase c = MakeMeshCase("sphere 16");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 33, -1, boxes);
  CompareWithSerial(c.Grid, c.Fractions, boxes, HexMeshOptions());
}

TEST(Ranks, StairStepAndSmoothingOff)
{
  const MeshCase c = MakeMeshCase("sphere 8");
  std::vector<IndexBox> boxes;
  CutBox(c.Grid.Global(), 4, -1, boxes);
  HexMeshOptions options;
  options.StairStep = true;
  CompareWithSerial(c.Grid, c.Fractions, boxes, options);
  options.StairStep = false;
  options.Method = Smoothing::Off;
  CompareWithSerial(c.Grid, c.Fractions, boxes, options);
}
