/// Fractions of models of intersecting surfaces, and the fit of such models.
#include "SharpFeatures/FeatureModel.h"
#include "Base/ConvexClip.h"
#include "RandomDraw.h"
#include "SharpFeatures/BoxCut.h"
#include "SharpFeatures/FeatureFit.h"
#include "SharpFeatures/FeatureStarts.h"

#include <gtest/gtest.h>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

/// Returns the half-space inside a plane (outside, if flipped).
HalfSpace HalfSpaceOf(const BoxPlane& plane, bool flipped)
{
  const double scale = (flipped ? 1.0 : -1.0) / Norm(plane.Normal);
  return { scale * plane.Normal, -scale * plane.Height };
}

double ClippedVolume(const std::array<BoxPlane, 3>& planes, int mask, int inside)
{
  ConvexPiece piece = MakeBoxPiece({ { -0.5, -0.5, -0.5 } }, { { 0.5, 0.5, 0.5 } });
  for (int k = 0; k < 3; ++k)
  {
    if (mask >> k & 1 && !piece.IsEmpty())
    {
      ConvexPiece in, out;
      std::vector<Vector3> section;
      ClipPiece(piece, HalfSpaceOf(planes[k], !(inside >> k & 1)), in, out, section);
      piece = in;
    }
  }
  return ComputeVolume(piece);
}

double VolumeOf(const std::array<BoxPlane, 3>& planes, int mask, std::array<PlaneRates, 3>& rates)
{
  return mask == 1 ? CutBox(planes[0], rates[0]) : CutBox(planes, mask, rates);
}

/// Returns planes that cut the cube; one component in four is zero, so that
/// some are parallel to its sides.
std::array<BoxPlane, 3> RandomPlanes(RandomDraw& random)
{
  std::array<BoxPlane, 3> planes;
  for (BoxPlane& plane : planes)
  {
    plane.Normal = random.Vector(-1.0, 1.0);
    for (double& n : plane.Normal)
    {
      n = random.Between(0.0, 1.0) < 0.25 ? 0.0 : n;
    }
    plane.Normal[0] = Norm(plane.Normal) < 0.3 ? 1.0 : plane.Normal[0];
    plane.Height = 0.95 * random.Between(-1.0, 1.0) * ReachOf(plane);
  }
  return planes;
}

/// Returns the first `surfaces` of three surfaces around the corner of a slightly rotated box.
FeatureModel MakeModel(int surfaces, int composition, double curvature, RandomDraw& random)
{
  FeatureModel model;
  model.Count = surfaces;
  model.Composition = composition;
  for (int k = 0; k < surfaces; ++k)
  {
    Vector3 normal = random.Vector(-0.3, 0.3);
    normal[k] += 1.0;
    model.Surfaces[k] = MakeLocalPlane(random.Vector(-0.4, 0.4), Unit(normal));
    for (int i = 0; i < 6; ++i)
    {
      model.Surfaces[k].C[i] = random.Between(-1.0, 1.0) * (i < 3 ? 0.1 : curvature);
    }
  }
  return model;
}

/// Returns the cells around a node in the middle of a grid of cubes.
std::vector<SampleCell> CellsAround(const Vector3& node)
{
  std::vector<SampleCell> cells;
  for (int i = 0; i < 216; ++i)
  {
    const Vector3 centre = Vector3{ { i % 6 - 2.5, i / 6 % 6 - 2.5, i / 36 - 2.5 } } - node;
    if (Norm(centre) <= 3.3)
    {
      cells.push_back({ centre, { { 0.5, 0.5, 0.5 } }, 0.0, std::exp(-Dot(centre, centre) / 4.5) });
    }
  }
  return cells;
}

void Fill(std::vector<SampleCell>& cells, const FeatureModel& model)
{
  for (SampleCell& cell : cells)
  {
    cell.Fraction = FractionIn(model, cell);
  }
}

template <class Function>
void ForAllCompositions(const Function& function)
{
  for (int surfaces = 1; surfaces <= FeatureModel::MaximumSurfaces; ++surfaces)
  {
    for (int composition = 0; composition < NumberOfCompositions(surfaces); ++composition)
    {
      SCOPED_TRACE(::testing::Message() << surfaces << " surfaces, composition " << composition);
      function(surfaces, composition);
    }
  }
}

} // namespace

TEST(FeatureModel, BoxesUnderPlanesHaveTheVolumeOfPolyhedra)
{
  RandomDraw random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const std::array<BoxPlane, 3> planes = RandomPlanes(random);
    for (int mask : { 1, 3, 5, 6, 7 })
    {
      std::array<PlaneRates, 3> rates;
      EXPECT_NEAR(VolumeOf(planes, mask, rates), ClippedVolume(planes, mask, 7), 1e-13);
    }
  }
}

TEST(FeatureModel, RatesAreDifferencesOfVolumes)
{
  RandomDraw random(1);
  const double step = 1e-5;
  for (int i = 0; i < 200; ++i)
  {
    const std::array<BoxPlane, 3> planes = RandomPlanes(random);
    for (int mask : { 1, 3, 5, 6, 7 })
    {
      std::array<PlaneRates, 3> rates, none;
      VolumeOf(planes, mask, rates);
      for (int k = 0; k < 3; ++k)
      {
        if (!(mask >> k & 1))
        {
          continue;
        }
        for (int axis = 0; axis < 4; ++axis)
        {
          std::array<BoxPlane, 3> low = planes, high = planes;
          (axis < 3 ? low[k].Normal[axis] : low[k].Height) -= step;
          (axis < 3 ? high[k].Normal[axis] : high[k].Height) += step;
          const double difference =
            (VolumeOf(high, mask, none) - VolumeOf(low, mask, none)) / (2.0 * step);
          const double rate = axis < 3 ? rates[k].ByNormal[axis] : rates[k].ByHeight;
          EXPECT_NEAR(rate, difference, 1e-3 * (1.0 + std::fabs(difference)));
        }
      }
    }
  }
}

TEST(FeatureModel, FractionsAreThoseOfTheComposition)
{
  RandomDraw random(1);
  ForAllCompositions(
    [&random](int surfaces, int composition)
    {
      for (int i = 0; i < 50; ++i)
      {
        const FeatureModel model = MakeModel(surfaces, composition, 0.0, random);
        SampleCell cell{ random.Vector(-0.5, 0.5), { { 0.5, 0.4, 0.7 } }, 0.0, 1.0 };
        std::array<BoxPlane, 3> planes{ { { { { 1.0, 0.0, 0.0 } }, 9.0 },
          { { { 1.0, 0.0, 0.0 } }, 9.0 }, { { { 1.0, 0.0, 0.0 } }, 9.0 } } };
        for (int k = 0; k < surfaces; ++k)
        {
          Vector3 normal;
          const double distance = DistanceTo(model.Surfaces[k], cell.Centre, normal);
          planes[k] = { 2.0 * Scaled(cell.Half, normal), distance };
        }
        double expected = 0.0;
        for (int bits = 0; bits < 8; ++bits)
        {
          expected += IsInside(model, bits) ? ClippedVolume(planes, 7, bits) : 0.0;
        }
        EXPECT_NEAR(FractionIn(model, cell), expected, 1e-13);
      }
    });
}

TEST(FeatureModel, CompositionsAreWhatTheyAreCalled)
{
  for (int bits = 0; bits < 8; ++bits)
  {
    FeatureModel model;
    model.Count = 3;
    const std::array<bool, 3> in{ { (bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0 } };
    std::array<bool, 8> expected{ { in[0] && in[1] && in[2], in[0] || in[1] || in[2] } };
    for (int z = 0; z < 3; ++z)
    {
      const bool x = in[(z + 1) % 3], y = in[(z + 2) % 3];
      expected[2 + z] = (x || y) && in[z];
      expected[5 + z] = (x && y) || in[z];
    }
    for (model.Composition = 0; model.Composition < NumberOfCompositions(3); ++model.Composition)
    {
      EXPECT_EQ(IsInside(model, bits), expected[model.Composition]) << model.Composition;
    }
  }
}

TEST(FeatureModel, DerivativesAreDifferencesOfFractions)
{
  RandomDraw random(1);
  const double step = 1e-5;
  ForAllCompositions(
    [&](int surfaces, int composition)
    {
      const FeatureModel model = MakeModel(surfaces, composition, 0.05, random);
      for (SampleCell& cell : CellsAround({ { 0.2, 0.1, -0.3 } }))
      {
        cell.Half = { { 0.6, 0.5, 0.4 } };
        std::array<double, 18> derivatives{};
        EXPECT_EQ(FractionIn(model, cell, derivatives.data()), FractionIn(model, cell));
        for (int i = 0; i < 6 * surfaces; ++i)
        {
          FeatureModel low = model, high = model;
          low.Surfaces[i / 6].C[i % 6] -= step;
          high.Surfaces[i / 6].C[i % 6] += step;
          const double difference = (FractionIn(high, cell) - FractionIn(low, cell)) / (2.0 * step);
          EXPECT_NEAR(derivatives[i], difference, 1e-3 * (1.0 + std::fabs(difference)));
        }
      }
    });
}

TEST(FeatureModel, SurfacesBetweenCellsHaveAreasAndNoResidual)
{
  // The part x > 0, y < 1 of [-2,2]^3 consists of whole cells.
  FeatureModel model;
  model.Count = 2;
  model.Surfaces[0] = MakeLocalPlane({ { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } });
  model.Surfaces[1] = MakeLocalPlane({ { 0.0, 1.0, 0.0 } }, { { 0.0, -1.0, 0.0 } });
  std::vector<SampleCell> cells;
  for (int i = 0; i < 64; ++i)
  {
    const bool isInside = i % 4 >= 2 && i / 4 % 4 <= 2;
    cells.push_back({ { { i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5 } }, { { 0.5, 0.5, 0.5 } },
      isInside ? 1.0 : 0.0, 1.0 });
  }
  const std::array<double, 3> areas = AreasOf(model, cells);
  EXPECT_NEAR(areas[0], 4.0 * 3.0, 1e-3);
  EXPECT_NEAR(areas[1], 4.0 * 2.0, 1e-3);
  EXPECT_EQ(ResidualOf(model, cells), 0.0);
  model.Composition = 1;
  EXPECT_GT(ResidualOf(model, cells), 0.5);
}

TEST(FeatureModel, AreasAreThoseBetweenTheLabels)
{
  // Labels of cells for x > .2 and y > -.1 in [-2,2]^3: a quarter of the cells.
  FeatureModel model;
  model.Count = 2;
  model.Surfaces[0] = MakeLocalPlane({ { 0.2, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } });
  model.Surfaces[1] = MakeLocalPlane({ { 0.0, -0.1, 0.0 } }, { { 0.0, 1.0, 0.0 } });
  std::vector<SampleCell> cells;
  for (int i = 0; i < 64; ++i)
  {
    cells.push_back(
      { { { i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5 } }, { { 0.5, 0.5, 0.5 } }, 0.0, 1.0 });
  }
  const std::array<double, 3> both = AreasOf(model, cells);
  EXPECT_NEAR(both[0], 4.0 * 2.1, 1e-3);
  EXPECT_NEAR(both[1], 4.0 * 1.8, 1e-3);
  EXPECT_EQ(both[2], 0.0);
  model.Composition = 1;
  const std::array<double, 3> either = AreasOf(model, cells);
  EXPECT_NEAR(either[0], 4.0 * 1.9, 1e-3);
  EXPECT_NEAR(either[1], 4.0 * 2.2, 1e-3);
}

TEST(FeatureModel, FitFindsPlanesOfEveryComposition)
{
  RandomDraw random(1);
  ForAllCompositions(
    [&random](int surfaces, int composition)
    {
      const FeatureModel truth = MakeModel(surfaces, composition, 0.0, random);
      std::vector<SampleCell> cells = CellsAround({ { 0.1, 0.2, -0.1 } });
      Fill(cells, truth);
      FeatureModel model = truth;
      for (int k = 0; k < surfaces; ++k)
      {
        model.Surfaces[k] = MakeLocalPlane(truth.Surfaces[k].Base + random.Vector(-0.2, 0.2),
          Unit(truth.Surfaces[k].N + random.Vector(-0.1, 0.1)));
      }
      const double before = ResidualOf(model, cells);
      FitModel(model, cells, 3, 12);
      EXPECT_GT(before, 0.03);
      EXPECT_LT(ResidualOf(model, cells), 2e-3);
      for (int k = 0; k < surfaces; ++k)
      {
        Vector3 found, expected;
        DistanceTo(model.Surfaces[k], {}, found);
        DistanceTo(truth.Surfaces[k], {}, expected);
        EXPECT_GT(Dot(found, expected), std::cos(0.02));
      }
    });
}

TEST(FeatureModel, FitFindsQuadrics)
{
  RandomDraw random(1);
  ForAllCompositions(
    [&random](int surfaces, int composition)
    {
      const FeatureModel truth = MakeModel(surfaces, composition, 0.08, random);
      std::vector<SampleCell> cells = CellsAround({});
      Fill(cells, truth);
      FeatureModel planes = truth;
      for (int k = 0; k < surfaces; ++k)
      {
        planes.Surfaces[k].C = {};
      }
      FitModel(planes, cells, 3, 12);
      FeatureModel quadrics = planes;
      FitModel(quadrics, cells, 6, 10);
      EXPECT_LT(ResidualOf(quadrics, cells), 0.012);
      EXPECT_LT(ResidualOf(quadrics, cells), ResidualOf(planes, cells));
    });
}

TEST(FeatureModel, StartsBeginWithTheCompositionOfTheData)
{
  RandomDraw random(1);
  ForAllCompositions(
    [&random](int surfaces, int composition)
    {
      const FeatureModel truth = MakeModel(surfaces, composition, 0.0, random);
      std::vector<SampleCell> cells = CellsAround({ { 0.1, 0.2, -0.1 } });
      Fill(cells, truth);
      const PackedCells packed = cells;
      const std::vector<LocalQuadric> seeds(
        truth.Surfaces.begin(), truth.Surfaces.begin() + surfaces);
      const std::vector<FeatureStart> starts = FeatureStarts(seeds, packed).Best(surfaces, 2);
      ASSERT_EQ(
        starts.size(), static_cast<std::size_t>(std::min(NumberOfCompositions(surfaces), 2)));
      EXPECT_EQ(starts[0].Model.Composition, composition);
      EXPECT_LT(starts[0].Residual, 0.03);
      EXPECT_LT(ResidualOf(truth, packed), 1e-12);
    });
}
