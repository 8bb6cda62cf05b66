/// Points are attached to the edges and corners of models, here the exact models of a rotated cube.
#include "RankMeshes.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexFacets.h"
#include "Labels/ResolveLabels.h"
#include "SharpFeatures/FeaturePlaces.h"
#include "Smoothing/AttachFeatures.h"
#include "Smoothing/Hex/ActiveHexes.h"
#include "Smoothing/Hex/HexEnergy.h"
#include "Smoothing/Hex/MakeLevels.h"
#include "Smoothing/Smoother.h"

#include <gtest/gtest.h>

#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const Shape Cube =
  MakeBox(1, { { 6.1, 5.9, 6.05 } }, { { 6.4, 6.6, 6.2 } }, { { 20.0, 35.0, 10.0 } });

/// Returns the face of the cube on one side of an axis, in the frame of a node; the cube is inside.
LocalQuadric FaceOfCube(int axis, double side, const Vector3& node)
{
  const Vector3 out = side * Cube.Axes[axis];
  return MakeLocalPlane(Cube.Center + Cube.Size[axis] * out - node, -1.0 * out);
}

/// Returns the three faces of the cube that are nearest to a node.
FeatureModel ModelNear(const Vector3& node)
{
  FeatureModel model;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = Dot(Cube.Axes[axis], node - Cube.Center) > 0.0 ? 1.0 : -1.0;
    model.Surfaces[model.Count++] = FaceOfCube(axis, side, node);
  }
  return model;
}

/// Returns the distance of a point from the planes of the nearest `faces` faces of the cube.
double DistanceToFaces(const Vector3& x, int faces)
{
  Vector3 away;
  for (int axis = 0; axis < 3; ++axis)
  {
    away[axis] = std::fabs(std::fabs(Dot(Cube.Axes[axis], x - Cube.Center)) - Cube.Size[axis]);
  }
  std::sort(away.begin(), away.end());
  return away[faces - 1];
}

/// The stages of hexahedral meshing up to the attachment to known models, which it includes.
struct CubeHexes
{
  CubeHexes(const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime) :
    Run(runtime), Parts(grid, runtime.Group())
  {
    MeshReport report;
    LevelPlan plan;
    this->Labelled.Labels = AssignMaterials(grid, fractions, 0.5);
    ResolveLabels(grid, fractions, this->Labelled.Labels, this->Parts, runtime);
    this->Labelled.Mixed = FindMixedNodes(grid, this->Labelled.Labels);
    MakeLevels(grid, this->Labelled.Labels, this->Labelled.Mixed, { false, true }, plan, Run,
      report, this->Labelled.Levels);
    CoarseHexes& coarse = *this->Labelled.Levels.Coarse;
    PointNumbering numbering(grid, this->Labelled.Labels, false, false, this->Labelled.Narrow);
    HexTopology topology =
      BuildHexes(grid, this->Labelled.Labels, this->Labelled.Mixed, false, numbering, Run, coarse);
    topology.Hexes.Levels = this->Labelled.Levels.Grid;
    const Fragments fragments(grid, this->Labelled.Labels, false, this->Parts);
    FillFragments(this->Labelled, numbering, fragments, runtime, topology);
    this->Facets =
      FindHexFacets(this->Labelled, numbering, fragments, this->Parts, runtime, topology);
    this->Hexes = std::move(topology.Hexes);
    const LevelInterfaces interfaces(
      *this->Hexes.Levels, fractions, this->Labelled.Labels, this->Labelled.Mixed, 0.5, Run);
    this->Targets =
      std::make_unique<SurfaceTargets>(interfaces.All(), SurfaceTargets::Kind::Quadrics, Run);
    this->Active = MakeActiveHexes(this->Labelled, this->Parts, this->Hexes, {}, runtime);
    AttachHexes(interfaces, coarse, this->Hexes, this->Facets, runtime, this->Active);
    const Interface& interface = *interfaces.All().back();
    this->Kinds = AttachFeatures({ MakeFeatures(interface), { &interface }, 0 }, this->Facets,
      this->Hexes, *this->Targets, this->Active, Run);
  }

  /// Returns models of owned points only.
  SharpFeatures MakeFeatures(const Interface& interface) const
  {
    std::vector<Index> points;
    std::vector<NodeFeature> models;
    for (std::size_t n = 0; n < interface.Nodes().size(); ++n)
    {
      const Index node = interface.Nodes()[n];
      const Vector3 origin = interface.NodePoint(node);
      if (this->Parts.OwnsNode(interface.Grid().Position(node)))
      {
        points.push_back(interface.PointOffset(n));
        models.push_back({ ModelNear(origin), origin, { { 1.0, 1.0, 1.0 } } });
      }
    }
    return { points, models };
  }

  void Smooth()
  {
    const HexEnergy energy(0.5);
    Smoother(this->Active, this->Targets.get(), energy, this->Run)
      .RunRamp(
        { { 1, 1.0, 0.1, 5, 0.0 }, { 2, 10.0, 0.05, 10, 0.0 }, { 8, 60.0, 0.01, 40, 2e-3 } });
  }

  /// Calls visit(a, b) for the edges of the interface, as points of the active mesh.
  template <class Visitor>
  void ForEdges(const Visitor& visit) const
  {
    for (const Facet& facet : this->Facets)
    {
      for (int c = 0; facet.DomainSide < 0 && c < 4; ++c)
      {
        visit(
          this->Active.PointOf[facet.Points[c]], this->Active.PointOf[facet.Points[(c + 1) % 4]]);
      }
    }
  }

  Runtime& Run;
  Partition Parts;
  LabelledGrid Labelled;
  Mesh Hexes;
  std::vector<Facet> Facets;
  std::unique_ptr<SurfaceTargets> Targets;
  ActiveMesh Active;
  std::vector<FeatureKind> Kinds;
};

CartesianGrid CubeGrid()
{
  return MakeUnitGrid(12);
}

FractionField CubeFractions()
{
  return FractionsOfShapes(CubeGrid(), { Cube });
}

/// Kinds of the points that have one, by point id.
using KindsById = std::map<Index, FeatureKind>;

KindsById ListKinds(const CubeHexes& cube)
{
  KindsById kinds;
  for (std::size_t p = 0; p < cube.Kinds.size(); ++p)
  {
    if (cube.Kinds[p] != FeatureKind::None)
    {
      kinds[cube.Hexes.PointIds[cube.Active.MeshPoint[p]]] = cube.Kinds[p];
    }
  }
  return kinds;
}

} // namespace

TEST(FeaturePlaces, OfTwoPlanes)
{
  FeatureModel both;
  both.Count = 2;
  both.Surfaces[0] = MakeLocalPlane({ { 0.5, 0.0, 0.0 } }, { { -1.0, 0.0, 0.0 } });
  both.Surfaces[1] = MakeLocalPlane({ { 0.0, 1.0, 0.0 } }, { { 0.0, -1.0, 0.0 } });
  const Vector3 inside{ { 0.0, 0.0, 0.3 } };
  EXPECT_EQ(FindSide(both, inside).Surface, 0);
  EXPECT_NEAR(FindSide(both, inside).Distance, 0.5, 1e-14);
  const std::optional<EdgePlace> edge = FindEdge(both, inside);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(Norm(edge->Point - Vector3{ { 0.5, 1.0, 0.3 } }), 0.0, 1e-14);
  EXPECT_NEAR(edge->Distance, std::sqrt(1.25), 1e-14);
  EXPECT_FALSE(FindCorner(both, inside));
  // x = .5 bounds the intersection where y < 1 and the union where y > 1.
  FeatureModel either = both;
  either.Composition = 1;
  for (const double y : { -1.0, 3.0 })
  {
    const Vector3 x{ { 0.5, y, 0.0 } };
    EXPECT_EQ(IsBoundary(both, 1, x), y < 1.0);
    EXPECT_EQ(IsBoundary(either, 1, x), y > 1.0);
  }
  // Beyond the plane y = 1 the foot on it still lies inside the other half-space. The foot on x =
  // .5 no longer lies on the boundary.
  EXPECT_EQ(FindSide(both, { { 0.4, 1.8, 0.0 } }).Surface, 1);
}

TEST(FeaturePlaces, AcuteEdgesAreLessBlunt)
{
  const Vector3 x{ { 1.0, 0.0, 0.0 } };
  const auto at = [](double degrees)
  {
    const double angle = degrees * std::acos(-1.0) / 180.0; // angle between the surfaces
    return Vector3{ { -std::cos(angle), std::sin(angle), 0.0 } };
  };
  EXPECT_NEAR(BluntnessOf(x, at(0.0)), 0.0, 1e-12);
  EXPECT_NEAR(BluntnessOf(x, at(45.0)), std::sqrt(1.0 - std::sqrt(0.5)), 1e-12);
  EXPECT_NEAR(BluntnessOf(x, at(90.0)), 1.0, 1e-12);
  EXPECT_EQ(BluntnessOf(x, at(120.0)), 1.0);
}

TEST(FeaturePlaces, OnCurvedSurfaces)
{
  FeatureModel model; // oblique end of a cylinder of radius 4
  model.Count = 2;
  model.Surfaces[0] = MakeLocalPlane({ { 1.0, 0.0, 0.0 } }, { { -1.0, 0.0, 0.0 } });
  model.Surfaces[0].C[model.Surfaces[0].U[1] != 0.0 ? 3 : 5] = 0.125;
  model.Surfaces[1] = MakeLocalPlane({ { 0.0, 0.0, 0.5 } }, Unit({ { 0.0, -0.3, -1.0 } }));
  for (const double y : { -1.2, 0.0, 0.8 })
  {
    const std::optional<EdgePlace> edge = FindEdge(model, { { 0.2, y, 0.1 } });
    ASSERT_TRUE(edge);
    EXPECT_EQ(edge->Surfaces, (std::array<int, 2>{ { 0, 1 } }));
    for (const LocalQuadric& surface : { model.Surfaces[0], model.Surfaces[1] })
    {
      Vector3 normal;
      EXPECT_NEAR(DistanceTo(surface, edge->Point, normal), 0.0, 1e-6);
    }
  }
}

TEST(FeaturePlaces, CornerOfThreePlanes)
{
  const Vector3 node{ { 8.0, 8.0, 8.0 } };
  Vector3 corner = Cube.Center;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = Dot(Cube.Axes[axis], node - Cube.Center) > 0.0 ? 1.0 : -1.0;
    corner = corner + side * Cube.Size[axis] * Cube.Axes[axis];
  }
  const std::optional<CornerPlace> found = FindCorner(ModelNear(node), { { 0.0, 0.0, 0.0 } });
  ASSERT_TRUE(found);
  EXPECT_NEAR(Norm(node + found->Point - corner), 0.0, 1e-12);
  EXPECT_NEAR(found->Distance, Norm(corner - node), 1e-12);
  EXPECT_NEAR(found->Bluntness, 1.0, 1e-12);
  EXPECT_TRUE(FindCorner(ModelNear(corner), { { 0.5, 0.5, -0.5 } }));
  EXPECT_FALSE(FindCorner(ModelNear(corner), { { 4.5, 0.0, 0.0 } }));
  FeatureModel flat = ModelNear(corner);
  flat.Surfaces[2] = flat.Surfaces[1]; // two equal planes do not meet in a point
  EXPECT_FALSE(FindCorner(flat, { { 0.0, 0.0, 0.0 } }));
}

TEST(AttachFeatures, HexesHaveTheEdgesOfACube)
{
  Runtime runtime;
  CubeHexes cube(CubeGrid(), CubeFractions(), runtime);
  cube.Smooth();
  std::array<int, 4> counts{};
  std::array<double, 4> squares{};
  for (std::size_t p = 0; p < cube.Kinds.size(); ++p)
  {
    const int attached =
      static_cast<int>(cube.Active.AttachmentOffset[p + 1] - cube.Active.AttachmentOffset[p]);
    const bool isCarrier = IsCarrier(cube.Kinds[p]);
    EXPECT_EQ(isCarrier, attached > 1);
    if (attached > 0)
    {
      EXPECT_EQ(attached == 3, cube.Kinds[p] == FeatureKind::Corner);
      const double distance = DistanceToFaces(cube.Active.X[p], attached);
      EXPECT_LT(distance, isCarrier ? 0.1 : 0.2);
      ++counts[attached];
      squares[attached] += distance * distance;
    }
  }
  EXPECT_EQ(counts[3], 8);
  EXPECT_GT(counts[2], 60); // 12 edges of 6 cells
  for (const int faces : { 1, 2, 3 })
  {
    const double distance = std::sqrt(squares[faces] / counts[faces]);
    std::printf("%d faces: %d points, %.4f cells off\n", faces, counts[faces], distance);
    EXPECT_LT(distance, 0.04);
  }
}

/// The attached faces define the sides, not the positions: a carrier must separate any two sides.
TEST(AttachFeatures, NoMeshEdgeJoinsTwoSides)
{
  Runtime runtime;
  const CubeHexes cube(CubeGrid(), CubeFractions(), runtime);
  const auto normalAt = [&](int point)
  {
    Vector3 normal;
    const Attachment& a = cube.Active.Attachments[cube.Active.AttachmentOffset[point]];
    cube.Targets->Distance(a.Target, cube.Active.X[point], normal);
    return normal;
  };
  int sides = 0, covered = 0;
  cube.ForEdges(
    [&](int a, int b)
    {
      const bool transferred = IsCarrier(cube.Kinds[a]) || IsCarrier(cube.Kinds[b]);
      covered += transferred;
      if (!transferred)
      {
        EXPECT_GT(Dot(normalAt(a), normalAt(b)), 0.9);
        ++sides;
      }
    });
  EXPECT_GT(sides, 100);
  EXPECT_GT(covered, 100);
}

TEST(AttachFeatures, EnergiesUseTheDemandOfElements)
{
  Runtime runtime;
  CubeHexes cube(CubeGrid(), CubeFractions(), runtime);
  const SmoothingStage stage{ 8, 60.0, 0.01, 1, 0.0 };
  const HexEnergy strict(0.5), lenient(0.4);
  const auto evaluate = [&](const HexEnergy& energy, int point)
  { return energy.Evaluate(cube.Active, point, cube.Active.X[point], stage); };
  const auto differentiate = [&](const HexEnergy& energy, int point)
  { return energy.Differentiate(cube.Active, point, stage).Value; };
  cube.Active.Demands.clear();
  cube.Active.ListCorners();
  cube.Active.Rings = HexRings(cube.Active, runtime);
  std::vector<double> requested;
  cube.Active.ForOwned([&](int point) { requested.push_back(evaluate(lenient, point)); });
  cube.Active.Demands.assign(cube.Active.Elements.size() / 8, 0.8f);
  cube.Active.Rings = HexRings(cube.Active, runtime);
  std::size_t at = 0;
  cube.Active.ForOwned(
    [&](int point)
    {
      EXPECT_NEAR(evaluate(strict, point), requested[at], 1e-5 * requested[at]);
      EXPECT_NEAR(differentiate(strict, point), requested[at], 1e-5 * requested[at]);
      ++at;
    });
}

TEST(Smoother, SnapsBringPointsToTheirTargets)
{
  Runtime runtime;
  CubeHexes cube(CubeGrid(), CubeFractions(), runtime);
  for (Attachment& attachment : cube.Active.Attachments)
  {
    attachment.Weight = 1.0; // as without sharp features, near which points take Newton steps
  }
  const HexEnergy energy(0.5);
  const SmoothingStage snaps{ 2, 10.0, 0.05, 0, 0.0, {}, 2 };
  const auto sumSquares = [&]
  {
    double sum = 0.0;
    for (int point = 0; point < static_cast<int>(cube.Active.X.size()); ++point)
    {
      for (Index i = cube.Active.AttachmentOffset[point];
           i < cube.Active.AttachmentOffset[point + 1]; ++i)
      {
        Vector3 gradient;
        const double distance =
          cube.Targets->Distance(cube.Active.Attachments[i].Target, cube.Active.X[point], gradient);
        sum += distance * distance;
      }
    }
    return sum;
  };
  const double before = sumSquares();
  Smoother smoother(cube.Active, &*cube.Targets, energy, runtime);
  smoother.RunStage(snaps, [](double) {});
  EXPECT_EQ(smoother.Sweeps(), 2);
  EXPECT_LT(sumSquares(), 0.4 * before);
  cube.Active.ForOwned(
    [&](int point) {
      EXPECT_LT(energy.Evaluate(cube.Active, point, cube.Active.X[point], snaps), InvalidEnergy);
    });
}

TEST(AttachFeatures, RanksAndThreadsChangeNothing)
{
  Runtime runtime;
  const CartesianGrid whole = CubeGrid();
  const FractionField fractions = CubeFractions();
  const KindsById alone = ListKinds(CubeHexes(whole, fractions, runtime));
  ThreadedRuntime threaded;
  EXPECT_EQ(ListKinds(CubeHexes(whole, fractions, threaded)), alone);
  for (const int count : { 2, 3, 8 })
  {
    KindsById joined;
    std::mutex lock;
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        RankRuntime own(ranks);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        const CubeHexes cube(grid, CopyToLocal(whole, fractions, grid), own);
        const std::lock_guard<std::mutex> locked(lock);
        for (const auto& entry : ListKinds(cube))
        {
          EXPECT_EQ(joined.insert(entry).first->second, entry.second); // also for ghosts
        }
      });
    EXPECT_EQ(joined, alone) << count;
  }
}
