#include "Smoothing/Hex/HexEnergy.h"
#include "Base/Vector3.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;

namespace
{

constexpr double Target = 0.5;

/// Returns `times` copies of the 2^3 hexes around point 0, randomly distorted; only point 0 is
/// common. Widths: one entry for all cells, or one per cell.
ActiveMesh MakeStar(double shake, int times, std::vector<Vector3> widths, unsigned seed = 1)
{
  std::mt19937 engine(seed);
  const auto random = [&] { return shake * (engine() * (2.0 / 4294967296.0) - 1.0); };
  ActiveMesh mesh;
  const Vector3 width = widths[0];
  mesh.Widths = std::move(widths);
  mesh.X.push_back({ { random() * width[0], random() * width[1], random() * width[2] } });
  for (int time = 0; time < times; ++time)
  {
    const int first = static_cast<int>(mesh.X.size());
    const auto number = [&](int i, int j, int k)
    {
      const int n = i + 3 * j + 9 * k;
      return n == 13 ? 0 : first + n - (n > 13);
    };
    for (int n = 0; n < 27; ++n)
    {
      if (n != 13)
      {
        mesh.X.push_back({ { (n % 3 - 1 + random()) * width[0],
          (n / 3 % 3 - 1 + random()) * width[1], (n / 9 - 1 + random()) * width[2] } });
      }
    }
    for (int hex = 0; hex < 8; ++hex)
    {
      for (int c = 0; c < 8; ++c)
      {
        mesh.Elements.push_back(
          number((hex & 1) + (c & 1), (hex >> 1 & 1) + (c >> 1 & 1), (hex >> 2) + (c >> 2)));
      }
    }
  }
  mesh.IsActive.assign(mesh.X.size(), 0);
  mesh.IsActive[0] = 1;
  mesh.ListCorners();
  Runtime runtime;
  mesh.Rings = HexRings(mesh, runtime);
  return mesh;
}

/// Returns the rings of one hex. Its upper four points are numbered from `upper` on.
/// @param moves  whether these points move; if not, they are the rim
HexRings RingsOfHex(int upper, bool moves)
{
  ActiveMesh mesh;
  mesh.Elements = { 0, 1, 2, 3, upper, upper + 1, upper + 2, upper + 3 };
  mesh.X.resize(upper + 4);
  mesh.IsActive.assign(mesh.X.size(), moves);
  std::fill_n(mesh.IsActive.begin(), 4, 1);
  mesh.ListCorners();
  Runtime runtime;
  return HexRings(mesh, runtime);
}

/// Type of higher precision, so that the reference has no rounding error.
using Real = long double;

/// Returns the energy of one corner of a hex by the definition in HexEnergy.h.
Real EnergyOfCorner(const Vector3 (&edges)[3], int corner, const Vector3& widths, Real target,
  const SmoothingStage& stage)
{
  Real lengths = 1.0, trace = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const Real l = Dot(edges[a], edges[a]);
    lengths *= l;
    trace += l / (Real(widths[a]) * widths[a]);
  }
  const bool isLeftHanded = ((corner & 1) + (corner >> 1 & 1) + (corner >> 2)) % 2 == 1;
  const Real determinant = (isLeftHanded ? -1.0 : 1.0) * Dot(edges[0], Cross(edges[1], edges[2]));
  const Real shape = determinant / (Real(widths[0]) * widths[1] * widths[2]);
  return std::pow(target * std::sqrt(lengths) / determinant, Real(2 * stage.HalfPower)) +
    stage.Omega * std::pow(trace / 3.0, Real(1.5)) / shape;
}

/// Returns the energy of the corners and edge ends that depend on point 0 if it is at x.
double EnergyByDefinition(ActiveMesh mesh, const Vector3& x, const SmoothingStage& stage)
{
  mesh.X[0] = x;
  Real sum = 0.0;
  for (Index position : mesh.CornerList)
  {
    const int* hex = mesh.Elements.data() + position / 8 * 8;
    const int own = static_cast<int>(position % 8);
    const Vector3& widths = mesh.WidthsAt(position);
    for (int corner : { own, own ^ 1, own ^ 2, own ^ 4 })
    {
      Vector3 edges[3];
      for (int a = 0; a < 3; ++a)
      {
        edges[a] = mesh.X[hex[corner ^ 1 << a]] - mesh.X[hex[corner]];
      }
      sum += EnergyOfCorner(edges, corner, widths, mesh.DemandAt(position) * Target, stage);
    }
    for (int a = 0; a < 3; ++a)
    {
      const Real length = Norm(mesh.X[hex[own ^ 1 << a]] - x) / widths[a];
      sum += 2.0 * std::pow(0.15 / length, Real(8.0));
    }
  }
  return static_cast<double>(sum);
}

Vector3 UnitAlong(int axis)
{
  Vector3 unit{ { 0.0, 0.0, 0.0 } };
  unit[axis] = 1.0;
  return unit;
}

/// Compares derivatives with finite differences of the definition; tolerance:
/// relative to the largest entry.
void ExpectDerivatives(const ActiveMesh& mesh, const SmoothingStage& stage, double tolerance)
{
  const Derivatives d = HexEnergy(Target).Differentiate(mesh, 0, stage);
  const double h = 1e-4 * mesh.WidthsAt(0)[0];
  const auto at = [&](const Vector3& step)
  { return EnergyByDefinition(mesh, mesh.X[0] + step, stage); };
  const double value = at({ { 0.0, 0.0, 0.0 } });
  EXPECT_NEAR(d.Value, value, tolerance * value);
  double largest[2] = { 0.0, 0.0 };
  for (int a = 0; a < 3; ++a)
  {
    largest[0] = std::max(largest[0], std::fabs(d.Gradient[a]));
    largest[1] = std::max(largest[1], std::fabs(d.Hessian[a]));
  }
  constexpr int Entry[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };
  for (int a = 0; a < 3; ++a)
  {
    const Vector3 u = h * UnitAlong(a);
    EXPECT_NEAR(d.Gradient[a], (at(u) - at(-1.0 * u)) / (2.0 * h), tolerance * largest[0]);
    for (int b = 0; b < 3; ++b)
    {
      const Vector3 v = h * UnitAlong(b);
      EXPECT_NEAR(d.Hessian[Entry[a][b]],
        (at(u + v) - at(u - v) - at(v - u) + at(-1.0 * (u + v))) / (4.0 * h * h),
        tolerance * largest[1])
        << a << b;
    }
  }
}

const Vector3 Cube{ { 1.0, 1.0, 1.0 } }, Box{ { 0.5, 1.0, 2.0 } };
constexpr double Tolerance = 2e-4; // error of differences with steps of 1e-4

} // namespace

TEST(HexEnergyTest, DerivativesAreThoseOfTheDefinition)
{
  for (int halfPower : { 1, 2, 8 })
  {
    for (const Vector3& widths : { Cube, Box })
    {
      ExpectDerivatives(MakeStar(0.15, 1, { widths }), { halfPower, 1.0, 0.1, 1, 0.0 }, Tolerance);
    }
  }
}

TEST(HexEnergyTest, AnyNumberOfHexes)
{
  const SmoothingStage stage{ 2, 1.0, 0.05, 1, 0.0 };
  ExpectDerivatives(MakeStar(0.15, 2, { Cube }), stage, Tolerance);
  for (int hexes = 1; hexes < 16; ++hexes)
  {
    ActiveMesh mesh = MakeStar(0.1, 2, { Cube });
    mesh.Elements.resize(8 * hexes);
    mesh.ListCorners();
    Runtime runtime;
    mesh.Rings = HexRings(mesh, runtime);
    ExpectDerivatives(mesh, stage, Tolerance);
  }
}

TEST(HexEnergyTest, EachHexHasItsWidthsAndDemand)
{
  std::vector<Vector3> widths;
  for (int hex = 0; hex < 8; ++hex)
  {
    widths.push_back({ { 0.5 + 0.01 * hex, 1.0 - 0.02 * hex, 2.0 + 0.03 * hex } });
  }
  ActiveMesh mesh = MakeStar(0.1, 1, widths);
  mesh.Demands = { 1.0f, 0.5f, 0.25f, 1.0f, 0.75f, 1.0f, 0.5f, 1.0f };
  Runtime runtime;
  mesh.Rings = HexRings(mesh, runtime);
  ExpectDerivatives(mesh, { 8, 1.0, 0.01, 1, 0.0 }, Tolerance);
}

/// Single precision would not suffice here: corner determinants are 1e-3
/// to 1e-6 of the cell volume.
TEST(HexEnergyTest, NearlyInvertedCornersAreComputedInDoubles)
{
  const SmoothingStage stage{ 1, 1.0, 0.1, 1, 0.0 };
  for (double gap : { 1e-3, 1e-4, 1e-5, 1e-6 })
  {
    ActiveMesh mesh = MakeStar(0.0, 1, { Cube });
    // the point approaches the plane of three of its neighbours
    mesh.X[0] = { { 1.0 / 3.0 - gap, 1.0 / 3.0 - gap, 1.0 / 3.0 - gap } };
    const HexEnergy energy(Target);
    const double exact = EnergyByDefinition(mesh, mesh.X[0], stage);
    EXPECT_NEAR(energy.Evaluate(mesh, 0, mesh.X[0], stage), exact, 1e-7 * exact) << gap;
    EXPECT_NEAR(energy.Differentiate(mesh, 0, stage).Value, exact, 1e-7 * exact) << gap;
  }
}

TEST(HexEnergyTest, InvertedCornersAreRejected)
{
  const ActiveMesh mesh = MakeStar(0.0, 1, { Cube });
  const SmoothingStage stage{ 1, 1.0, 0.1, 1, 0.0 };
  const HexEnergy energy(Target);
  EXPECT_LT(energy.Evaluate(mesh, 0, { { 0.3, 0.3, 0.3 } }, stage), InvalidEnergy);
  EXPECT_EQ(energy.Evaluate(mesh, 0, { { 0.34, 0.34, 0.34 } }, stage), InvalidEnergy);
  EXPECT_EQ(energy.Evaluate(mesh, 0, { { 1.2, 0.0, 0.0 } }, stage), InvalidEnergy);
}

TEST(HexEnergyTest, SteepnessIsThatOfTheNearestPlane)
{
  const SmoothingStage stage{ 1, 1.0, 0.1, 1, 0.0 };
  const HexEnergy energy(Target);
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  for (const Vector3& widths : { Cube, Box })
  {
    const ActiveMesh mesh = MakeStar(0.15, 2, { widths });
    const double distance = 1.0 / energy.Differentiate(mesh, 0, stage).Steepness;
    int beyond = 0;
    for (int i = 0; i < 2000; ++i)
    {
      const Vector3 u = Unit(Vector3{ { normal(engine), normal(engine), normal(engine) } });
      const auto isValid = [&](double length)
      { return energy.Evaluate(mesh, 0, mesh.X[0] + length * u, stage) < InvalidEnergy; };
      EXPECT_TRUE(isValid(0.999 * distance));
      beyond += !isValid(1.05 * distance);
    }
    EXPECT_GT(beyond, 0);
  }
}

/// Smoother does not mark these points.
TEST(HexEnergyTest, FarCornersOfHexesDoNotCount)
{
  const SmoothingStage stage{ 8, 1.0, 0.1, 1, 0.0 };
  const HexEnergy energy(Target);
  ActiveMesh mesh = MakeStar(0.15, 1, { Cube });
  const Derivatives before = energy.Differentiate(mesh, 0, stage);
  for (int corner : { 0, 2, 6, 8, 17, 19, 23, 25 })
  {
    mesh.X[1 + corner] = 1.1 * mesh.X[1 + corner];
  }
  const Derivatives after = energy.Differentiate(mesh, 0, stage);
  EXPECT_EQ(before.Value, after.Value);
  EXPECT_EQ(before.Gradient, after.Gradient);
  EXPECT_EQ(before.Hessian, after.Hessian);
}

/// Far from the origin differences of coordinates are as accurate as near it.
TEST(HexEnergyTest, PlaceDoesNotMatter)
{
  const SmoothingStage stage{ 8, 1.0, 0.01, 1, 0.0 };
  const ActiveMesh near = MakeStar(0.1, 1, { Cube });
  ActiveMesh far = near;
  for (Vector3& x : far.X)
  {
    x = x + Vector3{ { 4096.0, 8192.0, 1024.0 } };
  }
  const HexEnergy energy(Target);
  const double here = energy.Evaluate(near, 0, near.X[0], stage);
  EXPECT_NEAR(energy.Evaluate(far, 0, far.X[0], stage), here, 1e-5 * here);
}

TEST(HexRingsTest, HoldsPointsOfAnyNumber)
{
  for (int upper : { 4, 60000, 70000 })
  {
    for (bool moves : { false, true })
    {
      const HexRings rings = RingsOfHex(upper, moves);
      const HexRings::Ring ring = rings.PointsAt(3);
      std::vector<int> points;
      for (int n = 0; n < ring.Count; ++n)
      {
        points.push_back(ring[n]);
      }
      EXPECT_EQ(points.back(), upper) << "the far corner";
      EXPECT_EQ(ring.Near, 6);
      std::sort(points.begin(), points.end());
      EXPECT_EQ(points, (std::vector<int>{ 0, 1, 2, upper, upper + 1, upper + 2, upper + 3 }));
    }
  }
}
