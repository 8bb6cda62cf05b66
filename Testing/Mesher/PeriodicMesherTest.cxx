/// Meshes of periodic domains: ids, partners and sides of the output.
#include "Elements/ElementFaces.h"
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "RankFields.h"
#include "Report/ElementMoments.h"
#include "Report/MeshFacets.h"
#include "Report/Sets/MeshSets.h"
#include "Report/Sets/PeriodicPairs.h"
#include "State/ViewMesh.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index3 Cells{ { 7, 8, 6 } };
constexpr double Width = 0.3; // coordinates are not exact

/// Returns the part of a rank of an image of random labels.
MesherInput MakeRandomInput(const Index3& cells, Ranks& ranks)
{
  return MakeLabelInput({ cells, 0.1, Width }, RandomLabels(cells, 5), ranks);
}

/// Returns the part of a rank of an input of two levels: a box at the lower sides, and one at the
/// upper side of x.
MesherInput MakeRandomLevels(Ranks& ranks)
{
  return MakeLevelInput({ { { 8, 8, 6 } }, 0.1, Width },
    { { { { 0, 0, 0 } }, { { 2, 3, 2 } } }, { { { 6, 3, 1 } }, { { 8, 5, 3 } } } }, ranks);
}

struct Method
{
  const char* Name;
  ElementKind Elements;
  Sides Kind;
  bool HasLevels = false;
  bool FineInterfaces = true;
  int Layers = 0;
};

MesherInput MakeInput(const Method& method, Ranks& ranks)
{
  return method.HasLevels ? MakeRandomLevels(ranks) : MakeRandomInput(Cells, ranks);
}

MesherOptions OptionsOf(const Method& method)
{
  MesherOptions options;
  options.Elements = method.Elements;
  options.PeriodicSides = method.Kind;
  options.Periodic = 5; // x and z
  options.Layers = method.Layers;
  options.FirstLayer = 0.1;
  options.MeshVoid = method.HasLevels;
  options.FineInterfaces = method.FineInterfaces;
  return options;
}

class PeriodicMesher : public ::testing::TestWithParam<Method>
{
};

FaceIds IdsOfFace(const Mesh& mesh, Index element, int side)
{
  FaceIds face =
    ElementFaces(mesh.Corners).PointsOf(mesh.Elements.data() + mesh.Corners * element, side);
  for (Index& point : face)
  {
    point = point < 0 ? -1 : mesh.PointIds[point];
  }
  std::sort(face.begin(), face.end());
  return face;
}

void CountFaces(const Mesh& mesh, std::map<FaceIds, int>& faces)
{
  for (std::size_t element = 0; element < mesh.ElementIds.size(); ++element)
  {
    for (int side = 0; side < ElementFaces(mesh.Corners).Count; ++side)
    {
      ++faces[IdsOfFace(mesh, static_cast<Index>(element), side)];
    }
  }
}

/// Returns the volume of the elements of a mesh with joined sides; all must be positive.
double SumVolumes(const MesherResult& result)
{
  double sum = 0.0;
  for (const ElementMoments& element :
    FindElementMoments(ViewMesh(result.TheMesh, result.State, result.Fields)))
  {
    EXPECT_GT(element.Volume, 0.0);
    sum += element.Volume;
  }
  return sum;
}

using Point = std::array<double, 4>; // position and partner
/// A mesh by global ids.
struct MeshById
{
  std::map<Index, Point> Points;
  std::map<Index, std::vector<Index>> Elements;
  std::map<FaceIds, int> Sides; // side of the domain of each face on it

  void Add(const Mesh& mesh)
  {
    for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
    {
      const Vector3 x = mesh.PointAt(static_cast<Index>(p));
      const Index partner = mesh.PeriodicPartner.empty() ? 0 : mesh.PeriodicPartner[p];
      this->Points[mesh.PointIds[p]] = { { x[0], x[1], x[2], static_cast<double>(partner) } };
    }
    for (std::size_t at = 0; at < mesh.Elements.size(); ++at)
    {
      this->Elements[mesh.ElementIds[at / mesh.Corners]].push_back(
        mesh.PointIds[mesh.Elements[at]]);
    }
    for (const MeshFacet& facet : mesh.Facets)
    {
      if (facet.DomainSide >= 0)
      {
        this->Sides[IdsOfFace(mesh, facet.Element, facet.Side)] = facet.DomainSide;
      }
    }
  }
};

/// A mesh from a file has no facets: a search finds those of the mesher.
void ExpectFacetsAreFoundAgain(const MesherResult& result, Ranks& ranks)
{
  MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
  mesh.Facets = nullptr;
  const std::vector<MeshFacet> found = FindMeshFacets(mesh, ranks);
  const std::vector<MeshFacet>& expected = result.TheMesh.Facets;
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t f = 0; f < found.size(); ++f)
  {
    EXPECT_EQ(found[f].Element, expected[f].Element);
    EXPECT_EQ(found[f].Side, expected[f].Side);
    EXPECT_EQ(found[f].Behind, expected[f].Behind);
    EXPECT_EQ(found[f].DomainSide, expected[f].DomainSide);
  }
}

} // namespace

TEST_P(PeriodicMesher, PairsAreExactTranslates)
{
  Runtime serial;
  const MesherResult result =
    RunMesher(MakeInput(this->GetParam(), serial.Group()), OptionsOf(this->GetParam()), serial);
  const MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
  const std::vector<PeriodicPair> pairs = FindPeriodicPairs(mesh);
  ASSERT_GT(pairs.size(), 100u);
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  EXPECT_EQ(lengths[1], 0.0);
  for (const PeriodicPair& pair : pairs)
  {
    EXPECT_NE(pair.Periods, Index3{});
    for (int a = 0; a < 3; ++a)
    {
      EXPECT_EQ(mesh.Point(pair.Point)[a],
        mesh.Point(pair.Partner)[a] + static_cast<double>(pair.Periods[a]) * lengths[a]);
    }
  }
}

TEST_P(PeriodicMesher, FacesOfOppositeSidesMatch)
{
  Runtime serial;
  const MesherResult result =
    RunMesher(MakeInput(this->GetParam(), serial.Group()), OptionsOf(this->GetParam()), serial);
  MeshById mesh;
  mesh.Add(result.TheMesh);
  std::map<FaceIds, std::vector<int>> sides; // of faces with partners as points
  for (const auto& [ids, side] : mesh.Sides)
  {
    FaceIds face = ids;
    for (Index& id : face)
    {
      id = id < 0 ? -1 : static_cast<Index>(mesh.Points.at(id)[3]);
    }
    std::sort(face.begin(), face.end());
    if (side / 2 != 1)
    {
      sides[face].push_back(side);
    }
  }
  ASSERT_GT(sides.size(), 50u);
  for (const auto& face : sides)
  {
    ASSERT_EQ(face.second.size(), 2u);
    EXPECT_EQ(face.second[0] ^ 1, face.second[1]);
  }
}

/// Sides that are not flat, and sides next to void, can have points without a copy.
TEST_P(PeriodicMesher, NodeSetsOfOppositeSidesBeginInTheSameOrder)
{
  Runtime serial;
  const MesherResult result =
    RunMesher(MakeInput(this->GetParam(), serial.Group()), OptionsOf(this->GetParam()), serial);
  const MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
  const std::vector<NodeSet> sets = FindMeshSets(mesh, serial.Group()).NodeSets;
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  for (int axis : { 0, 2 })
  {
    std::array<std::vector<Vector3>, 2> points; // of the lower side, and of the upper side moved
    for (int side : { 0, 1 })
    {
      for (Index point : sets[2 * axis + side].Points)
      {
        points[side].push_back(mesh.PointAt(point));
        points[side].back()[axis] -= side * lengths[axis];
      }
    }
    auto end = std::mismatch(points[0].begin(), points[0].end(), points[1].begin(), points[1].end(),
      [](const Vector3& a, const Vector3& b) {
        return Norm(a - b) < 1e-12;
      }).first;
    EXPECT_GT(end - points[0].begin(), 45);
    for (; end != points[0].end(); ++end)
    {
      EXPECT_EQ(std::count_if(points[1].begin(), points[1].end(),
                  [&](const Vector3& b) { return Norm(*end - b) < 1e-12; }),
        0);
    }
  }
}

TEST_P(PeriodicMesher, RanksGiveTheSameMeshAndFindItsFacets)
{
  MeshById alone;
  for (int count : { 1, 2, 3, 8 })
  {
    MeshById joined;
    std::mutex mutex;
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        RankRuntime runtime(ranks);
        const MesherResult result =
          RunMesher(MakeInput(this->GetParam(), ranks), OptionsOf(this->GetParam()), runtime);
        ExpectFacetsAreFoundAgain(result, ranks);
        const std::lock_guard<std::mutex> lock(mutex);
        joined.Add(result.TheMesh);
      });
    alone = count == 1 ? joined : alone;
    EXPECT_TRUE(joined.Points == alone.Points);
    EXPECT_TRUE(joined.Elements == alone.Elements);
    EXPECT_TRUE(joined.Sides == alone.Sides);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, PeriodicMesher,
  ::testing::Values(Method{ "FlatHexes", ElementKind::Hexes, Sides::Flat },
    Method{ "FreeHexes", ElementKind::Hexes, Sides::Free },
    Method{ "FlatTets", ElementKind::Tets, Sides::Flat },
    Method{ "FlatHexesOfLevels", ElementKind::Hexes, Sides::Flat, true },
    Method{ "FreeHexesOfLevels", ElementKind::Hexes, Sides::Free, true },
    Method{ "FlatHexesAcrossLevels", ElementKind::Hexes, Sides::Flat, true, false },
    Method{ "FreeHexesAcrossLevels", ElementKind::Hexes, Sides::Free, true, false },
    Method{ "FlatTetsOfLevels", ElementKind::Tets, Sides::Flat, true },
    Method{ "FlatTetsAcrossLevels", ElementKind::Tets, Sides::Flat, true, false },
    Method{ "FlatLayers", ElementKind::Hexes, Sides::Flat, false, true, 3 },
    Method{ "FreeLayers", ElementKind::Hexes, Sides::Free, false, true, 2 }),
  [](const auto& info) { return std::string(info.param.Name); });

class JoinedMesher : public ::testing::TestWithParam<Method>
{
};

/// All cells have elements, so all faces of the torus are on two elements.
TEST_P(JoinedMesher, HasNoBoundary)
{
  MesherOptions options = OptionsOf(this->GetParam());
  options.Periodic = 7;
  options.MeshVoid = true;
  MeshById alone;
  for (int count : { 1, 2, 3 })
  {
    MeshById joined;
    std::map<FaceIds, int> faces; // number of elements of each
    double volume = 0.0;
    std::mutex mutex;
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        RankRuntime runtime(ranks);
        const MesherResult result = RunMesher(MakeInput(this->GetParam(), ranks), options, runtime);
        const Mesh& mesh = result.TheMesh;
        EXPECT_TRUE(std::is_sorted(mesh.PointIds.begin(), mesh.PointIds.end()));
        EXPECT_TRUE(mesh.PointIds.empty() || mesh.PointIds[0] > 0);
        EXPECT_TRUE(mesh.PeriodicPartner.empty());
        const std::lock_guard<std::mutex> lock(mutex);
        joined.Add(mesh);
        CountFaces(mesh, faces);
        volume += SumVolumes(result);
      });
    for (const auto& face : faces)
    {
      ASSERT_EQ(face.second, 2);
    }
    const double cells = this->GetParam().HasLevels ? 8.0 * 8.0 * 6.0 : 7.0 * 8.0 * 6.0;
    EXPECT_NEAR(volume / (cells * Width * Width * Width), 1.0, 1e-12);
    alone = count == 1 ? joined : alone;
    EXPECT_TRUE(joined.Points == alone.Points);
    EXPECT_TRUE(joined.Elements == alone.Elements);
  }
}

INSTANTIATE_TEST_SUITE_P(Elements, JoinedMesher,
  ::testing::Values(Method{ "Hexes", ElementKind::Hexes, Sides::Joined },
    Method{ "Tets", ElementKind::Tets, Sides::Joined },
    Method{ "HexesOfLevels", ElementKind::Hexes, Sides::Joined, true },
    Method{ "HexesAcrossLevels", ElementKind::Hexes, Sides::Joined, true, false },
    Method{ "TetsOfLevels", ElementKind::Tets, Sides::Joined, true },
    Method{ "TetsAcrossLevels", ElementKind::Tets, Sides::Joined, true, false },
    Method{ "Layers", ElementKind::Hexes, Sides::Joined, false, true, 2 }),
  [](const auto& info) { return std::string(info.param.Name); });

/// Material 1 below, 2 above: they meet inside, and across z at the sides.
TEST(PeriodicMesher, WarnsIfMaterialsDoNotContinue)
{
  Runtime serial;
  MesherInput input = MakeRandomInput({ { 4, 4, 12 } }, serial.Group());
  auto arrays = std::make_shared<PlainArrays>(Index(192));
  std::vector<int> labels(192, 1);
  std::fill(labels.begin() + 96, labels.end(), 2);
  arrays->Store("labels", ValueType::Int, std::move(labels));
  input.Levels.Levels[0].Blocks[0].Arrays = arrays;
  std::vector<std::string> warnings;
  input.Warn = [&warnings](const std::string& text) { warnings.push_back(text); };
  MesherOptions options;
  options.Periodic = 3;
  RunMesher(input, options, serial);
  EXPECT_TRUE(warnings.empty());
  options.Periodic = 7;
  const MesherResult result = RunMesher(input, options, serial);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
    "Across z, the materials of 16 of 16 faces of cells on opposite sides differ: the mesh has an "
    "interface there. Is the input one period?");
  EXPECT_EQ(result.Report.FlippedCells, 0);
}

TEST(PeriodicMesher, WrongInput)
{
  Runtime serial;
  const auto messageOf = [&](const MesherOptions& options, const Index3& cells) -> std::string
  {
    try
    {
      RunMesher(MakeRandomInput(cells, serial.Group()), options, serial);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return "";
  };
  MesherOptions options;
  options.Periodic = 1;
  EXPECT_EQ(
    messageOf(options, { { 2, 5, 5 } }), "A periodic mesh needs at least 3 cells along x, not 2.");
  EXPECT_EQ(messageOf(options, { { 3, 2, 2 } }), "");
  options.Elements = ElementKind::Tets;
  options.PeriodicSides = Sides::Free;
  EXPECT_EQ(messageOf(options, { { 5, 5, 5 } }),
    "PeriodicSides is Free: the sides of tetrahedra can only be Flat or Joined.");
}
