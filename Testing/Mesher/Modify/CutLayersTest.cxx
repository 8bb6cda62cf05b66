/// Layers of hexahedra along surfaces of a finished mesh.
#include "Elements/ElementFaces.h"
#include "Elements/MeasureFragments.h"
#include "InterfaceLayers.h"
#include "RankMeshes.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Layers = 3;
constexpr double Growth = 1.5;

bool IsInterface(const MeshFacet& facet)
{
  return facet.DomainSide == -1;
}

/// Makes a mesh, and layers of a first thickness along all interfaces.
Mesh MakeWithLayers(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, double thickness, Runtime& runtime, MeshReport& report)
{
  Mesh mesh = MakeHexMesh(grid, fractions, options, runtime, report);
  CutAtInterfaces({ Layers, Growth, thickness }, runtime, mesh, report);
  return mesh;
}

Mesh MakeEvenLayers(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  return MakeWithLayers(grid, fractions, options, 0.0, runtime, report);
}

Mesh MakeThinLayers(const CartesianGrid& grid, const FractionField& fractions,
  const MeshOptions& options, Runtime& runtime, MeshReport& report)
{
  return MakeWithLayers(grid, fractions, options, 0.1, runtime, report);
}

/// Returns the number of facets between materials or at void.
Index CountInterfaceFacets(const Mesh& mesh)
{
  return std::count_if(mesh.Facets.begin(), mesh.Facets.end(), IsInterface);
}

class CutLayersOf : public ::testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(CutLayersOf, GivesAValidMesh)
{
  const MeshCase c = MakeMeshCase(this->GetParam());
  MeshOptions options;
  options.MeshVoid = true;
  Runtime runtime;
  MeshReport report, cutReport;
  const Mesh plain = MakeHexMesh(c.Grid, c.Fractions, options, runtime, report);
  for (const MeshMaker make : { MakeEvenLayers, MakeThinLayers })
  {
    const Mesh mesh = make(c.Grid, c.Fractions, options, runtime, cutReport);
    EXPECT_EQ(
      mesh.ElementIds.size(), plain.ElementIds.size() + (Layers - 1) * CountInterfaceFacets(plain));
    EXPECT_EQ(CountInterfaceFacets(mesh), CountInterfaceFacets(plain));
    EXPECT_EQ(FindConformityProblem(mesh), "");
    EXPECT_EQ(FindFragmentProblem(mesh), "");
    EXPECT_EQ(FindFacetProblem(mesh), "");
    EXPECT_TRUE(IsPositiveEverywhere(mesh));
    EXPECT_TRUE(std::is_sorted(mesh.ElementIds.begin(), mesh.ElementIds.end()));
    EXPECT_TRUE(std::is_sorted(mesh.PointIds.begin(), mesh.PointIds.end()));
    for (int material : { 0, 1 })
    {
      const double volume = MeasureVolume(plain, material);
      EXPECT_NEAR(MeasureVolume(mesh, material), volume, 1e-12 * volume);
    }
    for (int layer = 1; layer <= Layers; ++layer)
    {
      EXPECT_EQ(
        std::count(mesh.Layer.begin(), mesh.Layer.end(), layer), CountInterfaceFacets(plain));
    }
    std::printf("%s: smallest scaled Jacobian %.3f, with layers %.3f\n", this->GetParam(),
      report.MinimumScaledJacobian, cutReport.MinimumScaledJacobian);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, CutLayersOf,
  ::testing::Values("sphere 16", "ball and plate", "gyroid", "ball of 3 sectors", "polycrystal"),
  [](const auto& info)
  {
    std::string name = info.param;
    std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
    return name;
  });

/// First thickness .1 of a cell on a sphere: the volume of a first layer over the area of its facet
/// is within 20 % at 95 % of the facets.
TEST(CutLayers, HaveTheGivenThickness)
{
  const MeshCase c = MakeSphereCase(32);
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeThinLayers(c.Grid, c.Fractions, MeshOptions(), runtime, report);
  Index facets = 0, within = 0;
  for (const MeshFacet& facet : mesh.Facets)
  {
    if (IsInterface(facet))
    {
      const FaceIds points =
        ElementFaces(8).PointsOf(mesh.Elements.data() + 8 * facet.Element, facet.Side);
      const auto x = [&](int corner) { return mesh.PointAt(points[corner]); };
      const double area = 0.5 * Norm(Cross(x(2) - x(0), x(3) - x(1)));
      const double thickness = VolumeOfElement(mesh, facet.Element) / area;
      ++facets;
      within += std::abs(thickness - 0.1) < 0.02 ? 1 : 0;
    }
  }
  std::printf("%.2f %% of %d facets\n",
    100.0 * static_cast<double>(within) / static_cast<double>(facets), static_cast<int>(facets));
  EXPECT_GE(static_cast<double>(within), 0.95 * static_cast<double>(facets));
}

TEST(CutLayers, EndsFollowGrowthAndThickness)
{
  const auto expect = [](const LayerSpacing& spacing, double height, std::vector<double> ends)
  {
    const std::vector<double> found = FindLayerEnds(spacing, height);
    ASSERT_EQ(found.size(), ends.size());
    for (std::size_t e = 0; e < ends.size(); ++e)
    {
      EXPECT_NEAR(found[e], ends[e], 1e-12);
    }
  };
  expect({ 3, 2.0 }, 0.0, { 0.0, 1.0 / 7.0, 3.0 / 7.0, 1.0 });
  expect({ 3, 2.0 }, 10.0, { 0.0, 0.1, 0.3, 1.0 }); // room for more: the last layer fills it
  expect({ 3, 2.0 }, 4.75, { 0.0, 4.0 / 19.0, 10.0 / 19.0, 1.0 }); // growth 1.5
  expect({ 3, 2.0 }, 2.0, { 0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 });
  expect({ 4, 1.0 }, 0.0, { 0.0, 0.25, 0.5, 0.75, 1.0 });
}
