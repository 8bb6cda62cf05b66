/// Fractions smoothed from labels are nearer to the true surface than the steps; labels and
/// volumes are kept, and ranks agree.
#include "Labels/SmoothLabels.h"
#include "Base/Vector3.h"
#include "Labels/Labels.h"
#include "MeshCases.h"
#include "RankFields.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double HalfCell = 0.5;

double Smooth(const CartesianGrid& grid, int passes, FractionField& field)
{
  Runtime runtime;
  return SmoothLabels(grid, passes, Partition(grid, runtime.Group()), runtime, field);
}

/// Returns a case of labels: the materials at cell centres.
MeshCase MakeLabelCase(const std::string& name, const CartesianGrid& grid, int materials,
  const std::function<int(const Vector3&)>& materialAt,
  const std::function<double(int, int, const Vector3&)>& distance)
{
  const auto label = [&](const Index3& p) {
    return materialAt({ { p[0] + HalfCell, p[1] + HalfCell, p[2] + HalfCell } });
  };
  return { name, grid, MakeLabels(grid, materials, label), distance, 0, 0, 0, 0, 0 };
}

MeshCase MakeShapeLabels(const std::string& name, const CartesianGrid& grid, const Shape& shape)
{
  return MakeLabelCase(
    name, grid, 1, [&](const Vector3& x) { return SignedDistance(shape, x) < 0.0 ? 1 : 0; },
    [shape](int, int, const Vector3& x) { return SignedDistance(shape, x); });
}

MeshCase MakeSectorLabels()
{
  const Vector3 centre{ { 12.1, 11.9, 12.2 } };
  const Shape ball = MakeSphere(1, centre, 9.6);
  const auto sector = [centre](const Vector3& x)
  {
    const double turn = std::atan2(x[1] - centre[1], x[0] - centre[0]) - 0.3 + 4.0 * M_PI;
    return static_cast<int>(std::fmod(turn, 2.0 * M_PI) / (2.0 * M_PI / 3.0)) + 1;
  };
  const auto distance = [=](int a, int b, const Vector3& x)
  {
    const double angle = 0.3 + 2.0 * M_PI / 3.0 * (a == 1 && b == 3 ? 0 : b - 1);
    return a == 0 ? SignedDistance(ball, x)
                  : Dot(x - centre, { { std::sin(angle), -std::cos(angle), 0.0 } });
  };
  return MakeLabelCase(
    "ball of 3 sectors", MakeUnitGrid(24), 3,
    [=](const Vector3& x) { return SignedDistance(ball, x) < 0.0 ? sector(x) : 0; }, distance);
}

/// Returns the rms distance in cells after 0, 1, 2, 3 and 5 passes.
std::vector<double> MeasurePasses(const MeshCase& labels)
{
  std::vector<double> rms;
  for (int passes : { 0, 1, 2, 3, 5 })
  {
    MeshCase c = labels;
    const double error = passes > 0 ? Smooth(c.Grid, passes, c.Fractions) : 0.0;
    Runtime runtime;
    const MeshFigures figures = MeasureCase(c, MeshOptions(), runtime);
    EXPECT_LT(error, 1e-8) << c.Name << ", " << passes << " passes";
    EXPECT_LT(figures.VolumeError, 1e-5) << c.Name << ", " << passes << " passes";
    EXPECT_GT(figures.Report.MinimumScaledJacobian, 0.45) << c.Name << ", " << passes;
    std::printf(
      "%d passes, volume error %.1e %s", passes, error, FormatFigures(c.Name, figures).c_str());
    rms.push_back(figures.Distance.RootMeanSquare);
  }
  return rms;
}

TEST(SmoothLabels, SphereComesNearer)
{
  const std::vector<double> rms = MeasurePasses(
    MakeShapeLabels("sphere 24", MakeUnitGrid(32), MakeSphere(1, { { 16.1, 16.2, 16.3 } }, 12.0)));
  EXPECT_LT(rms[1], 0.75 * rms[0]);
  EXPECT_LT(rms[2], 0.6 * rms[0]);
  EXPECT_LT(rms[3], 0.5 * rms[0]);
  EXPECT_LT(rms[4], 0.4 * rms[0]);
}

TEST(SmoothLabels, ObliquePlaneComesNearer)
{
  const std::vector<double> rms = MeasurePasses(MakeShapeLabels("oblique plane", MakeUnitGrid(24),
    MakeHalfSpace(1, { { 12.03, 12.0, 12.0 } }, { { 1, 2, 3.3 } })));
  EXPECT_LT(rms[2], 0.8 * rms[0]);
}

TEST(SmoothLabels, TorusComesNearer)
{
  const std::vector<double> rms = MeasurePasses(MakeShapeLabels(
    "torus", MakeUnitGrid(40, 40, 16), MakeTorus(1, { { 20.1, 20.2, 8.3 } }, 12.0, 4.8)));
  EXPECT_LT(rms[2], 0.8 * rms[0]);
}

TEST(SmoothLabels, SectorsComeNearer)
{
  const std::vector<double> rms = MeasurePasses(MakeSectorLabels());
  EXPECT_LT(rms[2], 0.75 * rms[0]);
}

/// Returns difficult labels: noise, and a wire, a plate one cell thick and a single cell in void.
std::vector<std::pair<CartesianGrid, FractionField>> MakeHardLabels()
{
  std::vector<std::pair<CartesianGrid, FractionField>> fields;
  for (const CartesianGrid& grid :
    { MakeUnitGrid(9, 8, 7), MakeUnevenGrid(9), MakeUnitGrid(9, 9, 1) })
  {
    fields.emplace_back(grid, MakeRandomLabels(grid, 3, 0, 5));
    fields.emplace_back(grid,
      MakeLabels(grid, 3,
        [](const Index3& p)
        {
          const bool isWire = p[0] == 2 && p[1] == 2, isPlate = p[0] == 5;
          return isWire ? 1 : (isPlate ? 2 : (p == Index3{ { 7, 3, 0 } } ? 3 : 0));
        }));
  }
  return fields;
}

TEST(SmoothLabels, LabelsStayAndVolumesToo)
{
  for (const auto& hard : MakeHardLabels())
  {
    const CartesianGrid& grid = hard.first;
    for (int passes : { 1, 3, 10 })
    {
      FractionField field = hard.second;
      EXPECT_LT(Smooth(grid, passes, field), 1e-6);
      std::vector<double> volume(4, 0.0), expected(4, 0.0);
      Index lost = 0, mixed = 0;
      ForCells(grid.Owned(),
        [&](const Index3& p)
        {
          const Index cell = grid.Linear(p);
          const int label = hard.second.Label(cell);
          double sum = 0.0;
          expected[label] += grid.CellVolume(p);
          for (int m = 0; m < 4; ++m)
          {
            sum += field.Fraction(cell, m);
            volume[m] += grid.CellVolume(p) * field.Fraction(cell, m);
          }
          EXPECT_NEAR(sum, 1.0, 1e-8);
          lost += field.Fraction(cell, label) <= 0.5;
          mixed += field.IsMixed(cell);
        });
      EXPECT_EQ(lost, 0) << passes << " passes";
      EXPECT_GT(mixed, 0) << passes << " passes";
      for (int m = 0; m < 4; ++m)
      {
        EXPECT_NEAR(volume[m], expected[m], 1e-6 * expected[m]) << "label " << m;
      }
    }
  }
}

TEST(SmoothLabels, CellsAwayFromInterfacesStayPure)
{
  const Shape sphere = MakeSphere(1, { { 8.2, 8.1, 8.3 } }, 5.2);
  const MeshCase c = MakeShapeLabels("sphere", MakeUnitGrid(16), sphere);
  FractionField field = c.Fractions;
  Smooth(c.Grid, 5, field);
  Index mixed = 0;
  ForCells(c.Grid.Owned(),
    [&](const Index3& p)
    {
      const bool isMixed = field.IsMixed(c.Grid.Linear(p));
      mixed += isMixed;
      const Vector3 x{ { p[0] + HalfCell, p[1] + HalfCell, p[2] + HalfCell } };
      EXPECT_FALSE(isMixed && std::fabs(SignedDistance(sphere, x)) > 1.3);
    });
  EXPECT_GT(mixed, 300);
}

TEST(SmoothLabels, SingleCellsStayNearlyWhole)
{
  const CartesianGrid grid = MakeUnitGrid(9);
  FractionField field = MakeLabels(grid, 1,
    [](const Index3& p) {
      return p == Index3{ { 2, 6, 2 } } || p[2] > 5 ? 1 : 0;
    });
  Smooth(grid, 2, field);
  EXPECT_GT(field.Fraction(grid.Linear({ { 2, 6, 2 } }), 1), 0.9);
}

TEST(SmoothLabels, NothingToSmooth)
{
  const CartesianGrid grid = MakeUnitGrid(4);
  FractionField field = MakeLabels(grid, 1, [](const Index3&) { return 1; });
  EXPECT_EQ(Smooth(grid, 3, field), 0.0);
  EXPECT_FALSE(field.IsMixed(grid.Linear({ { 1, 1, 1 } })));
}

TEST(SmoothLabels, RanksAgree)
{
  for (int passes : { 2, 7, 10 }) // also more passes than ghost layers
  {
    for (int seed : { 1, 2 })
    {
      const CartesianGrid grid = seed == 1 ? MakeUnevenGrid(13) : MakeUnitGrid(8, 5, 17);
      EXPECT_EQ(FindRankProblem(grid, MakeRandomLabels(grid, 3, 0, seed),
                  [passes](const CartesianGrid& part, const Partition& partition, Runtime& runtime,
                    FractionField& fractions)
                  { SmoothLabels(part, passes, partition, runtime, fractions); }),
        "");
    }
  }
}

} // namespace
