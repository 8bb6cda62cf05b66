#include "RankMeshes.h"

#include "GeometryChecks.h"
#include "Octree/OctreeKeys.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace vfm
{
namespace testing
{
namespace
{

using Materials = std::vector<MeshReport::Material>;

bool AreEqual(const Materials& a, const Materials& b)
{
  const auto areEqual = [](const MeshReport::Material& one, const MeshReport::Material& other)
  {
    return one.Elements == other.Elements && one.Fragments == other.Fragments &&
      one.MinimumScaledJacobian == other.MinimumScaledJacobian &&
      one.MeanScaledJacobian == other.MeanScaledJacobian;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), areEqual);
}

bool AreEqual(const MeshReport& a, const MeshReport& b)
{
  return a.TargetVolume == b.TargetVolume && a.MeshVolume == b.MeshVolume &&
    a.FlippedCells == b.FlippedCells && a.ResolveRounds == b.ResolveRounds &&
    a.NarrowVoidCells == b.NarrowVoidCells && a.NumberOfFragments == b.NumberOfFragments &&
    a.NumberOfSurfaces == b.NumberOfSurfaces && a.NumberOfCurves == b.NumberOfCurves &&
    a.NumberOfVertices == b.NumberOfVertices &&
    a.MinimumScaledJacobian == b.MinimumScaledJacobian &&
    a.MeanScaledJacobian == b.MeanScaledJacobian &&
    a.MinimumDihedralAngle == b.MinimumDihedralAngle &&
    a.MaximumDihedralAngle == b.MaximumDihedralAngle && a.DihedralAngles == b.DihedralAngles &&
    a.RefusedParts == b.RefusedParts && AreEqual(a.Materials, b.Materials);
}

/// Lists the differences.
class DifferenceText
{
public:
  void Add(std::size_t count, const char* what)
  {
    this->Text += count > 0 ? std::to_string(count) + " " + what + ", " : "";
  }
  std::string Get() const
  {
    return this->Text.empty() ? "" : this->Text + "differ from one rank. ";
  }

private:
  std::string Text;
};

/// Returns coordinates and geometry of the points of facets by id.
std::map<Index, std::array<double, 5>> PointsOfFacets(const MergedMesh& mesh)
{
  std::map<Index, std::array<double, 5>> points;
  for (const auto& facet : mesh.Facets)
  {
    for (int c = 0; c < ShapeOf(mesh.Corners).CornersOfFace; ++c)
    {
      points[facet.first[c]] = mesh.Points.at(facet.first[c]);
    }
  }
  return points;
}

std::vector<int> NumbersTo(std::size_t count)
{
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

/// Returns a table with the numbers of its rows.
GeometryTables WithIds(GeometryTables tables)
{
  if (tables.HasAllSurfaces)
  {
    tables.SurfaceIds = NumbersTo(tables.SurfaceVolumes.size());
  }
  if (tables.HasAllCurves)
  {
    tables.CurveIds = NumbersTo(tables.CurveEnds.size());
  }
  tables.HasAllSurfaces = tables.HasAllCurves = false;
  return tables;
}

/// Returns the numbers of both lists; places: those of the second list among them.
std::vector<int> JoinIds(
  const std::vector<int>& a, const std::vector<int>& b, std::array<std::vector<int>, 2>& places)
{
  std::vector<int> joined;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(joined));
  const auto find = [&joined](int id)
  { return static_cast<int>(std::lower_bound(joined.begin(), joined.end(), id) - joined.begin()); };
  places = {};
  std::transform(a.begin(), a.end(), std::back_inserter(places[0]), find);
  std::transform(b.begin(), b.end(), std::back_inserter(places[1]), find);
  return joined;
}

/// Joins a column with that of other rows.
/// @return number of rows of which both have different values
template <class Value>
int JoinColumns(const std::array<std::vector<int>, 2>& places, std::size_t rows,
  const std::vector<Value>& more, std::vector<Value>& column)
{
  std::vector<Value> joined(rows);
  std::vector<bool> isSet(rows, false);
  for (std::size_t row = 0; row < column.size(); ++row)
  {
    joined[places[0][row]] = column[row];
    isSet[places[0][row]] = true;
  }
  int conflicts = 0;
  for (std::size_t row = 0; row < more.size(); ++row)
  {
    const int to = places[1][row];
    conflicts += isSet[to] && joined[to] != more[row];
    joined[to] = more[row];
  }
  column = std::move(joined);
  return conflicts;
}

template <class Row>
void JoinLists(const std::vector<Row>& more, std::vector<Row>& list)
{
  std::vector<Row> joined;
  std::set_union(list.begin(), list.end(), more.begin(), more.end(), std::back_inserter(joined));
  list = std::move(joined);
}

} // namespace

int JoinTables(const GeometryTables& more, GeometryTables& tables)
{
  tables = WithIds(std::move(tables));
  const GeometryTables other = WithIds(more);
  std::array<std::vector<int>, 2> places;
  tables.SurfaceIds = JoinIds(tables.SurfaceIds, other.SurfaceIds, places);
  int conflicts = 0;
  const auto join = [&](auto GeometryTables::*column)
  { conflicts += JoinColumns(places, tables.SurfaceIds.size(), other.*column, tables.*column); };
  join(&GeometryTables::SurfaceVolumes);
  join(&GeometryTables::SurfaceMaterials);
  join(&GeometryTables::SurfaceSides);
  join(&GeometryTables::SurfaceParts);
  join(&GeometryTables::SurfaceAreas);
  join(&GeometryTables::SurfaceCentroids);
  join(&GeometryTables::SurfaceNormals);
  if (!tables.PatchNames.empty() || !other.PatchNames.empty())
  {
    join(&GeometryTables::PatchNames);
  }
  tables.CurveIds = JoinIds(tables.CurveIds, other.CurveIds, places);
  conflicts += JoinColumns(places, tables.CurveIds.size(), other.CurveEnds, tables.CurveEnds);
  JoinLists(other.VolumeSurfaces, tables.VolumeSurfaces);
  JoinLists(other.SurfaceCurves, tables.SurfaceCurves);
  JoinLists(other.CurveVertices, tables.CurveVertices);
  JoinLists(other.EdgeFacets, tables.EdgeFacets);
  return conflicts;
}

void MergedMesh::Add(const Mesh& m)
{
  this->Conflicts += JoinTables(m.Tables, this->Tables);
  this->Corners = m.Corners;
  for (std::size_t p = 0; p < m.PointIds.size(); ++p)
  {
    const std::array<double, 5> point{ { m.Points[3 * p], m.Points[3 * p + 1], m.Points[3 * p + 2],
      1.0 * m.GeometryDimension[p], 1.0 * m.GeometryId[p] } };
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
      points[c] = m.UnsplitPointIds()[s.Points[corners * f + c]];
    }
    this->Conflicts += !this->Facets
                          .emplace(points,
                            std::array<int, 4>{ { s.SurfaceId[f], s.MaterialPair[2 * f],
                              s.MaterialPair[2 * f + 1], s.DomainSide[f] } })
                          .second;
  }
  for (std::size_t e = 0; e < m.Curves.CurveId.size(); ++e)
  {
    const std::array<Index, 2> ends{ { m.UnsplitPointIds()[m.Curves.Points[2 * e]],
      m.UnsplitPointIds()[m.Curves.Points[2 * e + 1]] } };
    this->Conflicts += !this->CurveEdges.emplace(ends, m.Curves.CurveId[e]).second;
  }
  for (std::size_t v = 0; v < m.Vertices.VertexId.size(); ++v)
  {
    const Index id = m.UnsplitPointIds()[m.Vertices.Points[v]];
    this->Conflicts += !this->Vertices.emplace(id, m.Vertices.VertexId[v]).second;
  }
}

Mesh MergedMesh::Join() const
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

RankMesh MakeAlone(const CartesianGrid& whole, const FractionField& field,
  const MeshOptions& options, MeshMaker make)
{
  Runtime alone;
  RankMesh made;
  made.Reports.resize(1);
  made.Merged.Add(make(whole, field, options, alone, made.Reports[0]));
  EXPECT_EQ(made.Merged.Conflicts, 0);
  return made;
}

RankMesh MakeOnRanks(const CartesianGrid& whole, const FractionField& field,
  const std::vector<IndexBox>& boxes, const MeshOptions& options, MeshMaker make,
  const RankMeshChange& change)
{
  const bool isTetGen = make == MakeTetMesh && options.Method == TetMethod::TetGen;
  const GridLayers layers = isTetGen ? GridLayers() : LayersFor(options.Levels);
  const int count = static_cast<int>(boxes.size());
  std::vector<Mesh> meshes(count);
  RankMesh made;
  made.Reports.resize(count);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()], layers);
      RankRuntime runtime(ranks);
      meshes[ranks.Rank()] =
        make(grid, CopyToLocal(whole, field, grid), options, runtime, made.Reports[ranks.Rank()]);
      if (change)
      {
        change(runtime, meshes[ranks.Rank()], made.Reports[ranks.Rank()]);
      }
    });
  for (const Mesh& mesh : meshes)
  {
    made.Merged.Add(mesh);
  }
  EXPECT_EQ(made.Merged.Conflicts, 0);
  return made;
}

std::string FindGeometryDifference(const MergedMesh& made, const MergedMesh& alone)
{
  DifferenceText text;
  text.Add(CountDifferences(made.Facets, alone.Facets), "facets");
  text.Add(CountDifferences(PointsOfFacets(made), PointsOfFacets(alone)), "points of facets");
  text.Add(CountDifferences(made.CurveEdges, alone.CurveEdges), "edges of curves");
  text.Add(CountDifferences(made.Vertices, alone.Vertices), "vertices");
  text.Add(made.Tables == alone.Tables ? 0 : 1, "set of tables");
  return text.Get();
}

std::string FindDifference(const RankMesh& made, const RankMesh& alone)
{
  const auto same = [&](const MeshReport& report) { return AreEqual(report, alone.Reports[0]); };
  DifferenceText text;
  text.Add(CountDifferences(made.Merged.Points, alone.Merged.Points), "points");
  text.Add(CountDifferences(made.Merged.Elements, alone.Merged.Elements), "elements");
  text.Add(
    made.Reports.size() - std::count_if(made.Reports.begin(), made.Reports.end(), same), "reports");
  text.Add(made.Merged.Conflicts + alone.Merged.Conflicts, "conflicts");
  return text.Get() + FindGeometryDifference(made.Merged, alone.Merged);
}

void CompareWithSerial(const CartesianGrid& whole, const FractionField& field,
  const std::vector<std::vector<IndexBox>>& cuts, const MeshOptions& options, MeshMaker make)
{
  SCOPED_TRACE(make == MakeHexMesh ? "hexes" : NameOf(options.Method));
  const RankMesh alone = MakeAlone(whole, field, options, make);
  EXPECT_GT(alone.Merged.Elements.size(), 0u);
  EXPECT_EQ(FindGeometryProblem(alone.Merged), "");
  for (const std::vector<IndexBox>& boxes : cuts)
  {
    SCOPED_TRACE(std::to_string(boxes.size()) + " ranks");
    EXPECT_EQ(FindDifference(MakeOnRanks(whole, field, boxes, options, make), alone), "");
  }
}

std::map<Index, std::array<double, 3>> InterfacePoints(const Mesh& mesh)
{
  const int corners = mesh.CornersOfFacet();
  std::map<Index, std::array<double, 3>> points;
  for (std::size_t f = 0; f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    for (int c = 0; mesh.Surfaces.DomainSide[f] < 0 && c < corners; ++c)
    {
      const Index p = mesh.Surfaces.Points[corners * f + c];
      points[mesh.PointIds[p]] = { { mesh.Points[3 * p], mesh.Points[3 * p + 1],
        mesh.Points[3 * p + 2] } };
    }
  }
  return points;
}

FractionField MakeBlockLabels(const CartesianGrid& grid, int refinements, unsigned seed)
{
  std::mt19937 random(seed);
  std::map<std::array<Index, 3>, int> labels;
  return MakeLabels(grid, 2,
    [&](const Index3& p)
    {
      const Index3 block{ { p[0] >> refinements, p[1] >> refinements, p[2] >> refinements } };
      const auto at = labels.emplace(block, 0);
      if (at.second)
      {
        at.first->second = random() % 40 == 0 ? static_cast<int>(random() % 3) : 1;
      }
      return at.first->second;
    });
}

FractionField MakeNearTies(const CartesianGrid& grid, double share, unsigned seed)
{
  std::mt19937 random(seed);
  FractionField field(grid, 3);
  ForCells(grid.Local(),
    [&](const Index3& p)
    {
      const bool isRandom = random() < share * 4294967296.0;
      const int most = isRandom ? 1 + static_cast<int>(random() % 3) : 1;
      std::vector<FractionField::Part> parts;
      for (int m = 1; m <= 3; ++m)
      {
        parts.push_back({ m, m == most ? 0.34 : 0.33 });
      }
      field.SetParts(grid.Linear(p), parts);
    });
  return field;
}

std::vector<std::vector<Index>> MakeRandomFamilies(
  const CartesianGrid& grid, int refinements, double chance, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::vector<Index>> families(refinements);
  for (int level = 0; level < refinements; ++level)
  {
    Index count = 1;
    for (Index n : grid.Global().Upper)
    {
      count *= ((n >> (refinements - level)) + 1) / 2;
    }
    for (Index key = 0; key < count; ++key)
    {
      if (random() < chance * 4294967296.0)
      {
        families[level].push_back(key);
      }
    }
  }
  return families;
}

std::vector<std::vector<Index>> RefineBelow(
  const CartesianGrid& grid, int refinements, double share)
{
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= grid.Global().Upper[a]; i += Index(1) << refinements)
    {
      coordinates[a].push_back(grid.Coordinates(a)[i]);
    }
  }
  const CartesianGrid base(coordinates);
  const OctreeKeys lattice(base, refinements);
  std::vector<std::vector<Index>> families(refinements);
  for (int level = 0; level < refinements; ++level)
  {
    IndexBox box;
    for (int a = 0; a < 3; ++a)
    {
      box.Upper[a] = lattice.Families(level, a);
    }
    box.Upper[0] = static_cast<Index>(share * static_cast<double>(box.Upper[0])) - level;
    ForCells(box, [&](const Index3& q) { families[level].push_back(lattice.FamilyKey(level, q)); });
  }
  return families;
}

std::vector<IndexBox> CutBaseBox(const CartesianGrid& grid, int refinements, int ranks, int axis)
{
  std::vector<IndexBox> boxes = CutBox(ChangeLevel(grid.Domain(), -refinements), ranks, axis);
  for (IndexBox& box : boxes)
  {
    box = ChangeLevel(box, refinements);
  }
  return boxes;
}

} // namespace testing
} // namespace vfm
