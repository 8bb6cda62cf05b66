/// Meshes of a plane: a layer of one cell with the option Flat.
#include "Base/Vector3.h"
#include "LabelInput.h"
#include "Mesher.h"
#include "Modify/FlattenMesh.h"
#include "Phases/FlatLayer.h"
#include "RankFields.h"
#include "Report/FlatData.h"
#include "Smoothing/Hex/FlatColumns.h"
#include "ThreadRanks.h"

#include "Base/ThreadRuntime.h"
#include "Input/PlainArrays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double Width = 0.3;

/// Returns labels of n x n cells of grains: the nearest of random points.
std::vector<int> MakeGrains(int n, int grains, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::array<double, 2>> points(grains);
  for (auto& point : points)
  {
    point = { { n * (random() / 4294967296.0), n * (random() / 4294967296.0) } };
  }
  std::vector<int> labels;
  for (int cell = 0; cell < n * n; ++cell)
  {
    const auto distance = [&](const std::array<double, 2>& p)
    { return std::pow(cell % n + 0.5 - p[0], 2) + std::pow(cell / n + 0.5 - p[1], 2); };
    labels.push_back(static_cast<int>(1 +
      (std::min_element(points.begin(), points.end(),
         [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
        points.begin())));
  }
  return labels;
}

MesherOptions FlatOptions(ElementKind elements = ElementKind::Hexes)
{
  MesherOptions options;
  options.Flat = true;
  options.Elements = elements;
  options.LabelSmoothing = 3;
  return options;
}

MesherInput MakeGrainInput(Ranks& ranks, unsigned seed = 1, int axis = 2)
{
  Index3 cells{ { 24, 24, 24 } };
  cells[axis] = 1;
  return MakeLabelInput({ cells, 0.1, Width }, MakeGrains(24, 12, seed), ranks);
}

/// Returns fractions of a disc in 16 x 16 cells of different width and height, sampled.
MesherInput MakeDiscInput(Ranks& ranks)
{
  constexpr int N = 16, Samples = 20;
  std::vector<double> fractions;
  for (int cell = 0; cell < N * N; ++cell)
  {
    int inside = 0;
    for (int s = 0; s < Samples * Samples; ++s)
    {
      const double x = cell % N + (s % Samples + 0.5) / Samples - 7.7;
      const double y = cell / N + (s / Samples + 0.5) / Samples - 8.2;
      inside += x * x + y * y < 5.1 * 5.1;
    }
    fractions.push_back(inside / double(Samples * Samples));
  }
  auto arrays = std::make_shared<PlainArrays>(static_cast<Index>(fractions.size()));
  arrays->Store("disc", ValueType::Double, std::move(fractions));
  MesherInput input = MakeInput(
    { MakeBlock({ { { 0, 0, 0 } }, { { N, N, 1 } } }, { { 0, 0, 0 } }, Width, arrays) }, ranks);
  input.Arrays.Fractions = { "disc" };
  return input;
}

double AreaOf(const Mesh& mesh, std::size_t element, int axis = 2)
{
  const Index* corners = mesh.Elements.data() + mesh.Corners * element;
  double area = 0.0;
  for (int c = 1; c + 1 < mesh.Corners; ++c)
  {
    const Vector3 x = mesh.PointAt(corners[0]);
    area += 0.5 * Cross(mesh.PointAt(corners[c]) - x, mesh.PointAt(corners[c + 1]) - x)[axis];
  }
  return area;
}

/// Returns the area of each fragment.
std::map<int, double> SumAreas(const Mesh& mesh, int axis = 2)
{
  std::map<int, double> areas;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    EXPECT_GT(AreaOf(mesh, e, axis), 0.0);
    areas[mesh.Fragment[e]] += AreaOf(mesh, e, axis);
  }
  return areas;
}

std::vector<double> FieldOf(const MesherResult& result, const char* name)
{
  for (const FieldArray& field : result.Fields)
  {
    if (field.Name == name)
    {
      return std::get<std::vector<double>>(field.Values);
    }
  }
  return {};
}

/// Expects the areas of the fractions, in the mesh and in the report.
/// @param tolerance  relative error of the area of a fragment
void ExpectAreas(const MesherResult& result, int axis = 2, double tolerance = 1e-6)
{
  const MeshReport& report = result.Report;
  double sum = 0.0, target = 0.0;
  for (const auto& [fragment, area] : SumAreas(result.TheMesh, axis))
  {
    const double aim = report.Fragments.Volumes.at(fragment - 1);
    EXPECT_NEAR(area, aim, tolerance * aim) << fragment;
    sum += area;
    target += aim;
  }
  EXPECT_NEAR(sum, target, 1e-6 * target);
  const std::vector<double> volumes = FieldOf(result, "TargetVolume");
  EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), target, 1e-9 * target);
}

struct Angles
{
  double Least = 180.0, Most = 0.0;
};

Angles FindAngles(const Mesh& mesh)
{
  Angles angles;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    for (int c = 0; c < mesh.Corners; ++c)
    {
      const auto at = [&](int k)
      { return mesh.PointAt(mesh.Elements[mesh.Corners * e + k % mesh.Corners]); };
      const Vector3 a = at(c + 1) - at(c), b = at(c + mesh.Corners - 1) - at(c);
      const double angle =
        std::acos(Dot(a, b) / std::sqrt(Dot(a, a) * Dot(b, b))) * 180.0 / 3.14159265358979;
      angles.Least = std::min(angles.Least, angle);
      angles.Most = std::max(angles.Most, angle);
    }
  }
  return angles;
}

/// Points and elements by id.
struct ById
{
  std::map<Index, std::array<double, 5>> Points;
  std::map<Index, std::vector<double>> Elements;
  std::map<std::array<Index, 2>, std::array<int, 3>> Facets;
  bool operator==(const ById& other) const = default;

  void Add(const Mesh& mesh)
  {
    for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
    {
      const double* x = mesh.Points.data() + 3 * p;
      const std::array<double, 5> point{ { x[0], x[1], x[2], double(mesh.GeometryDimension[p]),
        double(mesh.GeometryId[p]) } };
      const auto [at, isNew] = this->Points.try_emplace(mesh.PointIds[p], point);
      EXPECT_EQ(at->second, point);
    }
    for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
    {
      std::vector<double> values{ double(mesh.Material[e]), double(mesh.Fragment[e]),
        mesh.ScaledJacobian[e] };
      for (int c = 0; c < mesh.Corners; ++c)
      {
        values.push_back(static_cast<double>(mesh.PointIds[mesh.Elements[mesh.Corners * e + c]]));
      }
      EXPECT_TRUE(this->Elements.emplace(mesh.ElementIds[e], values).second);
    }
    for (const MeshFacet& facet : mesh.Facets)
    {
      this->Facets[{ { mesh.ElementIds[facet.Element], facet.Side } }] = { { facet.Behind,
        facet.Surface, facet.DomainSide } };
    }
  }
};

ById MakeOnRanks(int count, const MesherOptions& options)
{
  ById all;
  std::mutex mutex;
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      const MesherResult result = RunMesher(MakeGrainInput(ranks), options, runtime);
      const std::lock_guard<std::mutex> lock(mutex);
      all.Add(result.TheMesh);
    });
  return all;
}

/// Expects that facets are the edges between materials and around the mesh.
void ExpectFacets(const Mesh& mesh)
{
  std::map<std::array<Index, 2>, std::vector<std::pair<Index, int>>> edges;
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    for (int s = 0; s < mesh.Corners; ++s)
    {
      const Index* corners = mesh.Elements.data() + mesh.Corners * e;
      const auto ends = std::minmax(corners[s], corners[(s + 1) % mesh.Corners]);
      edges[{ { ends.first, ends.second } }].emplace_back(e, s);
    }
  }
  std::map<std::pair<Index, int>, int> behind;
  for (const auto& [ends, sides] : edges)
  {
    ASSERT_LE(sides.size(), 2u);
    for (std::size_t k = 0; k < sides.size(); ++k)
    {
      const int other = sides.size() == 2 ? mesh.Material[sides[1 - k].first] : NothingBehind;
      if (other != mesh.Material[sides[k].first])
      {
        behind[sides[k]] = other;
      }
    }
  }
  ASSERT_EQ(mesh.Facets.size(), behind.size());
  for (const MeshFacet& facet : mesh.Facets)
  {
    const auto found = behind.find({ facet.Element, facet.Side });
    ASSERT_TRUE(found != behind.end());
    EXPECT_EQ(found->second, facet.Behind);
    EXPECT_EQ(facet.DomainSide >= 0, facet.Behind == NothingBehind);
    EXPECT_LT(facet.DomainSide, 4);
  }
}

} // namespace

TEST(FlatMesh, DiscHasItsAreaAndGoodQuads)
{
  Runtime serial;
  const MesherResult result = RunMesher(MakeDiscInput(serial.Group()), FlatOptions(), serial);
  ASSERT_EQ(result.TheMesh.Corners, 4);
  EXPECT_TRUE(IsFlat(result.TheMesh));
  ExpectAreas(result);
  EXPECT_GE(result.Report.MinimumScaledJacobian, 0.55);
  EXPECT_EQ(FieldOf(result, "DomainBounds").at(4), FieldOf(result, "DomainBounds").at(5));
  EXPECT_EQ(FieldOf(result, FlatThicknessName), std::vector{ Width });
  // Points of the boundary are outside of the circle, so that the polygon has its area.
  for (const MeshFacet& facet : result.TheMesh.Facets)
  {
    const Vector3 x =
      result.TheMesh.PointAt(result.TheMesh.Elements[4 * facet.Element + facet.Side]);
    EXPECT_NEAR(std::hypot(x[0] - 7.7 * Width, x[1] - 8.2 * Width), 5.1 * Width, 0.04 * Width);
  }
}

TEST(FlatMesh, GrainsHaveTheirAreasAndGoodElements)
{
  Runtime serial;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    const MesherResult quads =
      RunMesher(MakeGrainInput(serial.Group(), seed), FlatOptions(), serial);
    ExpectAreas(quads);
    ExpectFacets(quads.TheMesh);
    EXPECT_GE(quads.Report.MinimumScaledJacobian, 0.45) << seed;
    const MesherResult triangles =
      RunMesher(MakeGrainInput(serial.Group(), seed), FlatOptions(ElementKind::Tets), serial);
    ASSERT_EQ(triangles.TheMesh.Corners, 3);
    EXPECT_EQ(triangles.TheMesh.ElementIds.size(), 2u * 24 * 24); // two in each cell
    ExpectAreas(triangles, 2, 1e-4); // a grain of 0.7 cells misses its area by 2e-6
    ExpectFacets(triangles.TheMesh);
    const Angles angles = FindAngles(triangles.TheMesh);
    EXPECT_GE(angles.Least, 30.0) << seed;
    EXPECT_LE(angles.Most, 130.0) << seed;
  }
}

TEST(FlatMesh, LayersAlongAnyAxisAreMeshed)
{
  Runtime serial;
  for (int axis = 0; axis < 3; ++axis)
  {
    const MesherResult result =
      RunMesher(MakeGrainInput(serial.Group(), 3, axis), FlatOptions(), serial);
    ExpectAreas(result, axis);
    for (std::size_t p = 0; p < result.TheMesh.PointIds.size(); ++p)
    {
      EXPECT_EQ(result.TheMesh.Points[3 * p + axis], 0.1);
    }
  }
}

TEST(FlatMesh, BitsDoNotDependOnRanksAndThreads)
{
  for (const ElementKind kind : { ElementKind::Hexes, ElementKind::Tets })
  {
    const MesherOptions options = FlatOptions(kind);
    Ranks alone;
    ThreadRuntime threads(3);
    ById expected;
    expected.Add(RunMesher(MakeGrainInput(alone), options, threads).TheMesh);
    for (const int count : { 1, 2, 3 })
    {
      const ById made = MakeOnRanks(count, options);
      EXPECT_EQ(made.Points, expected.Points) << count;
      EXPECT_EQ(made.Elements, expected.Elements) << count;
      EXPECT_EQ(made.Facets, expected.Facets) << count;
    }
  }
}

TEST(FlatMesh, VoidAndNoiseAreMeshed)
{
  Runtime serial;
  for (const ElementKind kind : { ElementKind::Hexes, ElementKind::Tets })
  {
    for (const bool meshVoid : { false, true })
    {
      MesherOptions options = FlatOptions(kind);
      options.MeshVoid = meshVoid;
      options.LabelSmoothing = 0;
      const Index3 cells{ { 20, 17, 1 } };
      const MesherResult result =
        RunMesher(MakeLabelInput({ cells, 0.1, Width }, RandomLabels(cells, 7), serial.Group()),
          options, serial);
      EXPECT_GT(result.Report.MinimumScaledJacobian, 0.4);
      EXPECT_FALSE(SumAreas(result.TheMesh).empty()); // all are positive
      EXPECT_EQ(SumAreas(result.TheMesh).count(0), 0u);
    }
  }
}

TEST(FlatMesh, TrianglesOfUnmovedPointsAreHalvesOfCells)
{
  Runtime serial;
  for (const bool isStair : { false, true })
  {
    MesherOptions options = FlatOptions(ElementKind::Tets);
    options.StairStep = isStair;
    options.Smoothing = isStair ? options.Smoothing : SmoothingMethod::Off;
    const MesherResult result = RunMesher(MakeGrainInput(serial.Group()), options, serial);
    const Mesh& mesh = result.TheMesh;
    ASSERT_EQ(mesh.ElementIds.size(), 2u * 24 * 24);
    for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
    {
      EXPECT_NEAR(AreaOf(mesh, e), 0.5 * Width * Width, 1e-12);
    }
    ExpectFacets(mesh);
  }
}

TEST(FlatMesh, PeriodicSidesAreCopies)
{
  Runtime serial;
  MesherOptions options = FlatOptions();
  options.Periodic = 3;
  const MesherResult result = RunMesher(MakeGrainInput(serial.Group()), options, serial);
  ExpectAreas(result);
  const Mesh& mesh = result.TheMesh;
  ASSERT_FALSE(mesh.PeriodicPartner.empty());
  std::map<Index, Vector3> places;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    places[mesh.PointIds[p]] = mesh.PointAt(static_cast<Index>(p));
  }
  int copies = 0;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Vector3 away = mesh.PointAt(static_cast<Index>(p)) - places.at(mesh.PeriodicPartner[p]);
    copies += mesh.PeriodicPartner[p] != mesh.PointIds[p];
    EXPECT_TRUE(away[0] == 0.0 || std::fabs(away[0] - 24 * Width) < 1e-12);
    EXPECT_TRUE(away[1] == 0.0 || std::fabs(away[1] - 24 * Width) < 1e-12);
  }
  EXPECT_GT(copies, 40);
}

TEST(FlatMesh, LayersKeepAreas)
{
  Runtime serial;
  MesherOptions options = FlatOptions();
  const std::size_t before =
    RunMesher(MakeGrainInput(serial.Group()), options, serial).TheMesh.ElementIds.size();
  options.Layers = 3;
  const MesherResult result = RunMesher(MakeGrainInput(serial.Group()), options, serial);
  EXPECT_GT(result.TheMesh.ElementIds.size(), before + 400);
  ExpectAreas(result);
  ExpectFacets(result.TheMesh);
  EXPECT_GE(result.Report.MinimumScaledJacobian, 0.45);
}

TEST(FlatMesh, SplitMaterialsShareNoPoints)
{
  for (const ElementKind kind : { ElementKind::Hexes, ElementKind::Tets })
  {
    MesherOptions options = FlatOptions(kind);
    options.SplitInterfaces = "all";
    Runtime serial;
    const MesherResult result = RunMesher(MakeGrainInput(serial.Group()), options, serial);
    ExpectAreas(result);
    const Mesh& mesh = result.TheMesh;
    std::vector<std::set<int>> materials(mesh.PointIds.size());
    std::set<Index> originals;
    for (std::size_t i = 0; i < mesh.Elements.size(); ++i)
    {
      materials[mesh.Elements[i]].insert(mesh.Material[i / mesh.Corners]);
      originals.insert(mesh.OriginalPointIds[mesh.Elements[i]]);
    }
    for (const std::set<int>& ofPoint : materials)
    {
      EXPECT_EQ(ofPoint.size(), 1u);
    }
    EXPECT_GT(mesh.PointIds.size(), originals.size() + 50);
    const ById alone = MakeOnRanks(1, options);
    EXPECT_EQ(MakeOnRanks(3, options), alone);
  }
}

TEST(FlatMesh, InputThatDoesNotFitIsAnError)
{
  const auto messageOf = [](const Index3& cells, const MesherOptions& options)
  {
    Runtime serial;
    try
    {
      RunMesher(MakeLabelInput({ cells, 0.1, Width },
                  std::vector<int>(cells[0] * cells[1] * cells[2], 1), serial.Group()),
        options, serial);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(messageOf({ { 4, 5, 2 } }, FlatOptions()),
    "The option Flat needs one layer of cells, but the input has 4 x 5 x 2 cells: choose a slice "
    "of it.");
  EXPECT_EQ(messageOf({ { 4, 5, 1 } }, FlatOptions()), "");
  MesherOptions refined = FlatOptions();
  refined.Refinement = RefinementMode::Uniform;
  refined.MaximumLevel = 1;
  EXPECT_NE(messageOf({ { 4, 5, 1 } }, refined).find("Flat needs"), std::string::npos);
  MesherOptions layers = FlatOptions();
  layers.ElementOrder = InterpolationOrder::Quadratic;
  EXPECT_EQ(messageOf({ { 4, 5, 1 } }, layers),
    "The option Flat, for meshes of a plane, does not support ElementOrder: set it to Linear.");
}
