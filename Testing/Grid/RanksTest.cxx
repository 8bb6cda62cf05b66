/// The mesh is the same, bit for bit, on any number of ranks and any partition.
#include "MeshCases.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// What a mesh is made of, by global id. Tets leave the last places empty.
struct MergedMesh
{
  std::map<Index, std::array<double, 5>> Points;    // coordinates, dimension, geometry
  std::map<Index, std::array<double, 11>> Elements; // ids of points, material, fragment, quality
  std::map<std::array<Index, 4>, std::array<int, 4>> Facets;
  int Corners = 0;
  int Conflicts = 0;

  void Add(const Mesh& m)
  {
    this->Corners = m.Corners;
    for (std::size_t p = 0; p < m.PointIds.size(); ++p)
    {
      const std::array<double, 5> point{ { m.Points[3 * p], m.Points[3 * p + 1],
        m.Points[3 * p + 2], 1.0 * m.GeometryDimension[p], 1.0 * m.GeometryId[p] } };
      const auto at = this->Points.emplace(m.PointIds[p], point);
      this->Conflicts += at.first->second != point;
    }
    for (std::size_t e = 0; e < m.ElementIds.size(); ++e)
    {
      std::array<double, 11> element{};
      for (int c = 0; c < m.Corners; ++c)
      {
        element[c] = static_cast<double>(m.PointIds[m.Elements[m.Corners * e + c]]);
      }
      element[8] = m.Material[e];
      element[9] = m.Fragment[e];
      element[10] = m.ScaledJacobian[e];
      this->Conflicts += !this->Elements.emplace(m.ElementIds[e], element).second;
    }
    const SurfaceFacets& s = m.Surfaces;
    const int corners = m.CornersOfFacet();
    for (std::size_t f = 0; f < s.SurfaceId.size(); ++f)
    {
      std::array<Index, 4> points{};
      for (int c = 0; c < corners; ++c)
      {
        points[c] = m.PointIds[s.Points[corners * f + c]];
      }
      this->Conflicts += !this->Facets
                            .emplace(points,
                              std::array<int, 4>{ { s.SurfaceId[f], s.MaterialPair[2 * f],
                                s.MaterialPair[2 * f + 1], s.DomainSide[f] } })
                            .second;
    }
  }

  /// As one mesh, without its facets.
  Mesh Join() const
  {
    Mesh mesh;
    mesh.Corners = this->Corners;
    mesh.Points = Buffer<double>(3 * this->Points.size());
    mesh.PointIds = Buffer<Index>(this->Points.size());
    mesh.Elements = Buffer<Index>(this->Corners * this->Elements.size());
    mesh.ElementIds = Buffer<Index>(this->Elements.size());
    mesh.Material = Buffer<int>(this->Elements.size());
    mesh.Fragment = Buffer<int>(this->Elements.size());
    std::map<Index, Index> places;
    for (const auto& point : this->Points)
    {
      const Index at = static_cast<Index>(places.size());
      std::copy_n(point.second.begin(), 3, mesh.Points.data() + 3 * at);
      mesh.PointIds[at] = point.first;
      places[point.first] = at;
    }
    Index at = 0;
    for (const auto& element : this->Elements)
    {
      for (int c = 0; c < this->Corners; ++c)
      {
        mesh.Elements[this->Corners * at + c] = places.at(static_cast<Index>(element.second[c]));
      }
      mesh.ElementIds[at] = element.first;
      mesh.Material[at] = static_cast<int>(element.second[8]);
      mesh.Fragment[at] = static_cast<int>(element.second[9]);
      ++at;
    }
    return mesh;
  }
};

bool operator==(const MeshReport& a, const MeshReport& b)
{
  return a.TargetVolume == b.TargetVolume && a.MeshVolume == b.MeshVolume &&
    a.FlippedCells == b.FlippedCells && a.ResolveRounds == b.ResolveRounds &&
    a.NumberOfFragments == b.NumberOfFragments && a.NumberOfSurfaces == b.NumberOfSurfaces &&
    a.NumberOfCurves == b.NumberOfCurves && a.NumberOfVertices == b.NumberOfVertices &&
    a.MinimumScaledJacobian == b.MinimumScaledJacobian &&
    a.MeanScaledJacobian == b.MeanScaledJacobian &&
    a.MinimumDihedralAngle == b.MinimumDihedralAngle &&
    a.MaximumDihedralAngle == b.MaximumDihedralAngle && a.DihedralAngles == b.DihedralAngles &&
    a.RefusedParts == b.RefusedParts;
}

struct Meshes
{
  MergedMesh Serial, Merged;
  MeshReport SerialReport;
  std::vector<MeshReport> Reports; // of the ranks
};

/// Meshes alone, and on ranks, each with one of the boxes.
Meshes MakeBoth(const CartesianGrid& whole, const FractionField& field,
  const std::vector<IndexBox>& boxes, const MeshOptions& options, MeshMaker make)
{
  Runtime alone;
  Meshes both;
  both.Serial.Add(make(whole, field, options, alone, both.SerialReport));
  const int count = static_cast<int>(boxes.size());
  std::vector<Mesh> meshes(count);
  both.Reports.resize(count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
      RankRuntime runtime(ranks);
      meshes[ranks.Rank()] =
        make(grid, CopyToLocal(whole, field, grid), options, runtime, both.Reports[ranks.Rank()]);
    });
  for (const Mesh& mesh : meshes)
  {
    both.Merged.Add(mesh);
  }
  EXPECT_EQ(both.Serial.Conflicts, 0);
  EXPECT_EQ(both.Merged.Conflicts, 0);
  return both;
}

/// Entries of one map that the other has not, or has with another value.
template <class Map>
std::size_t CountDifferences(const Map& a, const Map& b)
{
  const auto missing = [](const Map& from, const Map& in)
  {
    return std::count_if(from.begin(), from.end(),
      [&](const auto& entry)
      {
        const auto at = in.find(entry.first);
        return at == in.end() || at->second != entry.second;
      });
  };
  return static_cast<std::size_t>(std::max(missing(a, b), missing(b, a)));
}

void CompareWithSerial(const CartesianGrid& whole, const FractionField& field,
  const std::vector<IndexBox>& boxes, const MeshOptions& options, MeshMaker make = MakeHexMesh)
{
  SCOPED_TRACE(make == MakeHexMesh ? "hexes" : NameOf(options.Tets));
  const Meshes both = MakeBoth(whole, field, boxes, options, make);
  const auto same = [&](const MeshReport& report) { return report == both.SerialReport; };
  EXPECT_EQ(std::count_if(both.Reports.begin(), both.Reports.end(), same),
    static_cast<std::ptrdiff_t>(boxes.size()))
    << "reports as of one process";
  EXPECT_GT(both.Serial.Elements.size(), 0u);
  EXPECT_EQ(CountDifferences(both.Merged.Points, both.Serial.Points), 0u) << "points";
  EXPECT_EQ(CountDifferences(both.Merged.Elements, both.Serial.Elements), 0u) << "elements";
  EXPECT_EQ(CountDifferences(both.Merged.Facets, both.Serial.Facets), 0u) << "facets";
}

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

TEST(Ranks, SlabsThinnerThanTheGhostLevels)
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
