#include "Smoothing/Tet/TetEnergy.h"
#include "Base/Vector3.h"
#include "RandomDraw.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace vfm;
using vfm::testing::RandomDraw;

namespace
{

const double Pi = std::acos(-1.0);
const TetQualityFloors Floors{ 0.5, 0.6, 0.5, 0.25 };

SmoothingStage Stage(int halfPower)
{
  return { halfPower, 1.0, 0.125, 1, 0.0 };
}

void SwapTwoPairs(int* tet, int bits)
{
  const std::array<int, 4> old{ { tet[0], tet[1], tet[2], tet[3] } };
  for (int c = 0; c < 4; ++c)
  {
    tet[c] = old[c ^ bits];
  }
}

/// Lists the corners at point 0, the only active one.
void ListCornersOfCentre(ActiveMesh& mesh)
{
  mesh.IsActive.assign(mesh.X.size(), 0);
  mesh.IsActive[0] = 1;
  mesh.ListCorners();
}

/// Returns the 24 tets at a node of the body-centred lattice, randomly distorted. Point 0 is
/// the node, points 1..8 are corners of the cube, points 9..14 lie beyond its faces. The node
/// is a random corner of each tet.
ActiveMesh Star(RandomDraw& random, double shake, bool uniform)
{
  ActiveMesh mesh;
  mesh.Corners = 4;
  mesh.X.push_back({ { 0.0, 0.0, 0.0 } });
  for (int c = 0; c < 8; ++c)
  {
    mesh.X.push_back({ { (c & 1) - 0.5, (c >> 1 & 1) - 0.5, (c >> 2 & 1) - 0.5 } });
  }
  for (int side = 0; side < 6; ++side)
  {
    const int a = side / 2, b = (a + 1) % 3, c = (a + 2) % 3;
    Vector3 beyond{ { 0.0, 0.0, 0.0 } };
    beyond[a] = side % 2 ? 1.0 : -1.0;
    mesh.X.push_back(beyond);
    const int base = 1 + ((side % 2) << a);
    const int ring[4] = { base, base + (1 << b), base + (1 << b) + (1 << c), base + (1 << c) };
    for (int i = 0; i < 4; ++i)
    {
      int tet[4] = { 0, 9 + side, ring[i], ring[(i + 1) % 4] };
      if (side % 2 == 0)
      {
        std::swap(tet[2], tet[3]);
      }
      SwapTwoPairs(tet, (side + i) % 4);
      mesh.Elements.insert(mesh.Elements.end(), tet, tet + 4);
    }
  }
  const Vector3 common{ { 1.5, 0.75, 1.125 } };
  for (Vector3& x : mesh.X)
  {
    x = Scaled(common, x + shake * random.Vector(-1.0, 1.0)) + Vector3{ { 40.0, 30.0, 20.0 } };
  }
  mesh.Widths.assign(uniform ? 1 : 24, common);
  if (!uniform)
  {
    for (Vector3& widths : mesh.Widths)
    {
      widths = widths + 0.2 * random.Vector(-1.0, 1.0);
    }
  }
  ListCornersOfCentre(mesh);
  return mesh;
}

/// Returns one tet whose corner 0 is the active point.
ActiveMesh OneTet(const Vector3 corners[4], const Vector3& widths)
{
  ActiveMesh mesh;
  mesh.Corners = 4;
  mesh.X.assign(corners, corners + 4);
  mesh.Elements = { 0, 1, 2, 3 };
  mesh.Widths = { widths };
  ListCornersOfCentre(mesh);
  return mesh;
}

/// Returns the tets from first to last (excluded) of a mesh.
ActiveMesh SomeTets(const ActiveMesh& mesh, int first, int last)
{
  ActiveMesh part = mesh;
  part.Elements.assign(mesh.Elements.begin() + 4 * first, mesh.Elements.begin() + 4 * last);
  if (mesh.Widths.size() > 1)
  {
    part.Widths.assign(mesh.Widths.begin() + first, mesh.Widths.begin() + last);
  }
  ListCornersOfCentre(part);
  return part;
}

/// Computes the energy of a tet by definition, with roots, powers and angles. edgesFrom: the corner
/// whose edges count, or -1 for all.
double Definition(
  const Vector3 corners[4], const Vector3& widths, const SmoothingStage& stage, int edgesFrom)
{
  Vector3 x[4];
  for (int c = 0; c < 4; ++c)
  {
    x[c] = Divided(corners[c], widths);
  }
  const double volume = Dot(x[1] - x[0], Cross(x[2] - x[0], x[3] - x[0])) / 6.0;
  double energy = 0.0, sumOfSquares = 0.0;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = a + 1; b < 4; ++b)
    {
      int rest[2], count = 0;
      for (int c = 0; c < 4; ++c)
      {
        if (c != a && c != b)
        {
          rest[count++] = c;
        }
      }
      const Vector3 axis = Unit(x[b] - x[a]);
      const Vector3 u = x[rest[0]] - x[a], v = x[rest[1]] - x[a];
      const double angle =
        std::acos(Dot(Unit(u - Dot(u, axis) * axis), Unit(v - Dot(v, axis) * axis)));
      const double floor = angle > Pi / 2 ? Floors.Obtuse : Floors.Acute;
      const double p = 2.0 * stage.HalfPower;
      energy += std::pow(floor / std::sin(angle), p) - std::pow(floor, p);
      const double length = Norm(x[b] - x[a]);
      sumOfSquares += length * length;
      if (edgesFrom < 0 || edgesFrom == a || edgesFrom == b)
      {
        energy += 0.25 * std::pow(Floors.ShortestEdge / length, 8.0);
      }
    }
  }
  const double mu = sumOfSquares / (12.0 * std::cbrt(9.0 * volume * volume));
  const int q = std::max(1, stage.HalfPower / 2);
  return energy + std::pow(Floors.MeanRatio * mu, 3.0 * q) + stage.Omega * mu * mu * mu;
}

double DefinitionAtCentre(const ActiveMesh& mesh, const SmoothingStage& stage)
{
  double energy = 0.0;
  for (Index position : mesh.CornerList)
  {
    Vector3 corners[4];
    for (int c = 0; c < 4; ++c)
    {
      corners[c] = mesh.X[mesh.Elements[position / 4 * 4 + c]];
    }
    energy += Definition(corners, mesh.WidthsAt(position), stage, static_cast<int>(position % 4));
  }
  return energy;
}

const Vector3 UnitWidths{ { 1.0, 1.0, 1.0 } };

/// Regular has edges of length 1; Skew is not regular.
const Vector3 Regular[4] = { { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } },
  { { 0.5, std::sqrt(0.75), 0.0 } }, { { 0.5, std::sqrt(1.0 / 12.0), std::sqrt(2.0 / 3.0) } } };
const Vector3 Skew[4] = { { { 0.1, -0.1, 0.0 } }, { { 1.2, 0.1, 0.0 } }, { { 0.6, 0.7, 0.1 } },
  { { 0.9, 0.6, 0.8 } } };

} // namespace

TEST(TetEnergy, IsWhatItsDefinitionSays)
{
  const TetEnergy energy(Floors, true);
  RandomDraw random(7);
  for (int trial = 0; trial < 40; ++trial)
  {
    const ActiveMesh mesh = Star(random, 0.12, trial % 2 == 0);
    for (int halfPower : { 1, 2, 4, 8 })
    {
      const SmoothingStage stage = Stage(halfPower);
      const double expected = DefinitionAtCentre(mesh, stage);
      EXPECT_NEAR(energy.Evaluate(mesh, 0, mesh.X[0], stage), expected, 1e-10 * expected);
    }
  }
}

TEST(TetEnergy, HasTheDerivativesThatDifferencesGive)
{
  const TetEnergy energy(Floors, true);
  RandomDraw random(7);
  for (int trial = 0; trial < 40; ++trial)
  {
    ActiveMesh mesh = Star(random, 0.12, trial % 2 == 0);
    const Vector3 centre = mesh.X[0];
    for (int halfPower : { 1, 2, 8 })
    {
      const SmoothingStage stage = Stage(halfPower);
      mesh.X[0] = centre;
      const Derivatives d = energy.Differentiate(mesh, 0, stage);
      EXPECT_EQ(d.Value, energy.Evaluate(mesh, 0, centre, stage));
      const auto& h = d.Hessian;
      const double hessian[3][3] = { { h[0], h[3], h[4] }, { h[3], h[1], h[5] },
        { h[4], h[5], h[2] } };
      const double size = Norm({ { h[0], h[1], h[2] } });
      for (int a = 0; a < 3; ++a)
      {
        const double step = 1e-6;
        Vector3 up = centre, down = centre;
        up[a] += step;
        down[a] -= step;
        const double slope =
          (energy.Evaluate(mesh, 0, up, stage) - energy.Evaluate(mesh, 0, down, stage)) /
          (up[a] - down[a]);
        EXPECT_NEAR(d.Gradient[a], slope, 1e-7 * (size + Norm(d.Gradient)));
        mesh.X[0] = up;
        const Vector3 above = energy.Differentiate(mesh, 0, stage).Gradient;
        mesh.X[0] = down;
        const Vector3 below = energy.Differentiate(mesh, 0, stage).Gradient;
        for (int b = 0; b < 3; ++b)
        {
          EXPECT_NEAR(hessian[a][b], (above[b] - below[b]) / (up[a] - down[a]), 1e-6 * size);
        }
      }
    }
  }
}

/// A demand d multiplies the targets by d and the weight of the shape by d.
TEST(TetEnergy, EachTetHasItsDemand)
{
  constexpr double demand = 0.3;
  const SmoothingStage stage = Stage(2);
  SmoothingStage lenientStage = stage;
  lenientStage.Omega *= demand;
  TetQualityFloors lower = Floors;
  for (double* floor : { &lower.Acute, &lower.Obtuse, &lower.MeanRatio, &lower.ShortestEdge })
  {
    *floor *= demand;
  }
  RandomDraw random(7);
  for (int trial = 0; trial < 20; ++trial)
  {
    const ActiveMesh mesh = Star(random, 0.12, trial % 2 == 0);
    const int tets = static_cast<int>(mesh.Elements.size()) / 4, strict = tets / 3;
    ActiveMesh both = mesh;
    both.Demands.assign(tets, static_cast<float>(demand));
    std::fill_n(both.Demands.begin(), strict, 1.0f);
    const ActiveMesh first = SomeTets(mesh, 0, strict), rest = SomeTets(mesh, strict, tets);
    for (bool precise : { true, false })
    {
      const TetEnergy energy(Floors, precise), lenient(lower, precise);
      const Derivatives a = energy.Differentiate(first, 0, stage),
                        b = lenient.Differentiate(rest, 0, lenientStage);
      const double expected = a.Value + b.Value, tolerance = precise ? 1e-6 : 1e-4;
      EXPECT_NEAR(energy.Evaluate(both, 0, both.X[0], stage), expected, tolerance * expected);
      const Derivatives d = energy.Differentiate(both, 0, stage);
      EXPECT_NEAR(d.Value, expected, tolerance * expected);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(d.Gradient[axis], a.Gradient[axis] + b.Gradient[axis],
          tolerance * (Norm(a.Gradient) + Norm(b.Gradient)));
      }
    }
  }
}

TEST(TetEnergy, CountsEachTetOnceHoweverManyThereAre)
{
  const TetEnergy energy(Floors, true);
  RandomDraw random(7);
  const SmoothingStage stage = Stage(2);
  for (bool uniform : { true, false })
  {
    const ActiveMesh mesh = Star(random, 0.12, uniform);
    for (int count = 0; count <= 24; ++count)
    {
      const ActiveMesh part = SomeTets(mesh, 0, count);
      const double expected = DefinitionAtCentre(part, stage);
      EXPECT_NEAR(energy.Evaluate(part, 0, part.X[0], stage), expected, 1e-10 * expected);
      const Derivatives d = energy.Differentiate(part, 0, stage);
      EXPECT_NEAR(d.Value, expected, 1e-10 * expected);
      if (count > 0) // derivatives add up
      {
        const Derivatives before = energy.Differentiate(SomeTets(mesh, 0, count - 1), 0, stage);
        const Derivatives added = energy.Differentiate(SomeTets(mesh, count - 1, count), 0, stage);
        EXPECT_NEAR(d.Gradient[1], before.Gradient[1] + added.Gradient[1], 1e-10 * d.Hessian[1]);
        EXPECT_NEAR(d.Hessian[1], before.Hessian[1] + added.Hessian[1], 1e-10 * d.Hessian[1]);
      }
    }
  }
}

TEST(TetEnergy, DoesNotDependOnTheOrderOfCorners)
{
  const TetEnergy energy(Floors, true);
  RandomDraw random(7);
  const SmoothingStage stage = Stage(4);
  const ActiveMesh mesh = Star(random, 0.12, false);
  const Derivatives d = energy.Differentiate(mesh, 0, stage);
  for (int turns = 0; turns < 3; ++turns)
  {
    for (int bits = 0; bits < 4; ++bits)
    {
      ActiveMesh other = mesh;
      for (std::size_t first = 0; first < other.Elements.size(); first += 4)
      {
        int* tet = other.Elements.data() + first;
        std::rotate(tet + 1, tet + 1 + turns, tet + 4);
        SwapTwoPairs(tet, bits);
      }
      ListCornersOfCentre(other);
      const Derivatives o = energy.Differentiate(other, 0, stage);
      EXPECT_NEAR(o.Value, d.Value, 1e-11 * d.Value);
      EXPECT_LT(Norm(o.Gradient - d.Gradient), 1e-11 * d.Hessian[0]);
      for (int i = 0; i < 6; ++i)
      {
        EXPECT_NEAR(o.Hessian[i], d.Hessian[i], 1e-11 * d.Hessian[0]);
      }
    }
  }
}

TEST(TetEnergy, OfTheRegularTetIsKnown)
{
  const TetEnergy energy(Floors, true);
  const Vector3 widths{ { 0.5, 2.0, 1.25 } };
  for (int halfPower : { 1, 2, 8 })
  {
    for (double size : { 0.2, 1.0, 3.0 })
    {
      Vector3 corners[4];
      for (int c = 0; c < 4; ++c)
      {
        corners[c] = Scaled(widths, size * Regular[c]);
      }
      const SmoothingStage stage = Stage(halfPower);
      const double sine = std::sqrt(8.0) / 3.0;
      const double shape = 6.0 *
          (std::pow(Floors.Acute / sine, 2.0 * halfPower) -
            std::pow(Floors.Acute, 2.0 * halfPower)) +
        std::pow(Floors.MeanRatio, 3.0 * std::max(1, halfPower / 2)) + stage.Omega;
      const double edge = 0.25 * std::pow(Floors.ShortestEdge / size, 8.0);
      const double whole = shape + 6.0 * edge, atCorner = shape + 3.0 * edge;
      EXPECT_NEAR(energy.OfTet(corners, widths, stage), whole, 1e-12 * whole);
      const ActiveMesh mesh = OneTet(corners, widths);
      EXPECT_NEAR(energy.Evaluate(mesh, 0, mesh.X[0], stage), atCorner, 1e-12 * atCorner);
      // The shape of a regular tet is optimal in any frame: the gradient is zero.
      if (size > 0.5)
      {
        const Derivatives d = energy.Differentiate(mesh, 0, stage);
        EXPECT_LT(Norm(d.Gradient), 1e-3 * d.Hessian[0]);
      }
    }
  }
}

TEST(TetEnergy, IsInvalidWhereATetIsFlatOrInverted)
{
  const TetEnergy energy(Floors, true);
  const SmoothingStage stage = Stage(1);
  RandomDraw random(7);
  for (int bad = 0; bad < 24; ++bad)
  {
    ActiveMesh mesh = Star(random, 0.05, bad % 2 == 0);
    std::swap(mesh.Elements[4 * bad + 1], mesh.Elements[4 * bad + 2]);
    ListCornersOfCentre(mesh);
    EXPECT_EQ(energy.Evaluate(mesh, 0, mesh.X[0], stage), InvalidEnergy);
    // far away: about half of the tets are inverted
    mesh = Star(random, 0.05, bad % 2 == 0);
    EXPECT_LT(energy.Evaluate(mesh, 0, mesh.X[0], stage), 1e6);
    EXPECT_EQ(energy.Evaluate(mesh, 0, 3.0 * random.Vector(-1.0, 1.0), stage), InvalidEnergy);
  }
  Vector3 corners[4] = { Skew[0], Skew[1], Skew[2], Skew[3] };
  std::swap(corners[0], corners[1]);
  EXPECT_EQ(energy.OfTet(corners, UnitWidths, stage), InvalidEnergy);
  corners[0] = corners[2];
  EXPECT_EQ(energy.OfTet(corners, UnitWidths, stage), InvalidEnergy);
  // D is relative to the cell size
  const double nearlyFlat = 1.1e-9;
  for (double width : { 1e-3, 1.0, 1e3 })
  {
    const Vector3 widths{ { width, width, width } };
    Vector3 low[4] = { { { 0.0, 0.0, 0.0 } }, { { width, 0.0, 0.0 } }, { { 0.0, width, 0.0 } },
      { { 0.0, 0.0, nearlyFlat * width } } };
    EXPECT_LT(energy.OfTet(low, widths, stage), InvalidEnergy);
    low[3][2] *= 0.8;
    EXPECT_EQ(energy.OfTet(low, widths, stage), InvalidEnergy);
  }
}

TEST(TetEnergy, OfOneTetIsWhatItsCornersSee)
{
  const TetEnergy energy(Floors, true);
  const Vector3 widths{ { 0.9, 1.1, 1.2 } };
  const SmoothingStage stage = Stage(2);
  const double whole = energy.OfTet(Skew, widths, stage);
  EXPECT_NEAR(whole, Definition(Skew, widths, stage, -1), 1e-12 * whole);
  // The corners together count the shape four times and each edge twice.
  double corners = 0.0, shape = 0.0;
  TetQualityFloors noEdges = Floors;
  noEdges.ShortestEdge = 0.0;
  for (int bits = 0; bits < 4; ++bits)
  {
    Vector3 turned[4];
    for (int c = 0; c < 4; ++c)
    {
      turned[c] = Skew[c ^ bits];
    }
    const ActiveMesh mesh = OneTet(turned, widths);
    corners += energy.Evaluate(mesh, 0, mesh.X[0], stage);
    shape += TetEnergy(noEdges, true).Evaluate(mesh, 0, mesh.X[0], stage) / 4.0;
  }
  EXPECT_NEAR(whole, shape + (corners - 4.0 * shape) / 2.0, 1e-12 * whole);

  Vector3 four[4][4];
  for (int t = 0; t < 4; ++t)
  {
    for (int c = 0; c < 4; ++c)
    {
      four[t][c] = t % 2 ? Skew[c] : Regular[c];
    }
  }
  std::swap(four[2][0], four[2][1]);
  const std::array<double, 4> energies = energy.OfTets(four, widths, stage);
  EXPECT_EQ(energies[0], energy.OfTet(Regular, widths, stage));
  EXPECT_EQ(energies[1], whole);
  EXPECT_EQ(energies[2], InvalidEnergy);
  EXPECT_EQ(energies[3], whole);
}

TEST(TetEnergy, HasNeitherJumpNorKinkAtRightAngles)
{
  const TetEnergy energy(Floors, true);
  const SmoothingStage stage = Stage(1);
  const Vector3 corners[4] = { { { 0.0, 0.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.4, 0.9, 0.0 } },
    { { 0.3, 0.0, 0.8 } } };
  // The dihedral angle at edge 0 1 is 90 degrees; corner 2 moves it slightly to either side.
  ActiveMesh mesh = OneTet(corners, UnitWidths);
  Derivatives d[2];
  for (int side = 0; side < 2; ++side)
  {
    mesh.X[2][2] = side ? 1e-9 : -1e-9;
    d[side] = energy.Differentiate(mesh, 0, stage);
  }
  EXPECT_NEAR(d[0].Value, d[1].Value, 1e-7);
  EXPECT_LT(Norm(d[0].Gradient - d[1].Gradient), 1e-7);
}

namespace
{

void ExpectNear(const Derivatives& a, const Derivatives& b, double tolerance)
{
  const double size = std::fabs(b.Hessian[0]) + std::fabs(b.Hessian[1]) + std::fabs(b.Hessian[2]);
  EXPECT_NEAR(a.Value, b.Value, tolerance * b.Value);
  EXPECT_LE(Norm(a.Gradient - b.Gradient), tolerance * size);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(a.Hessian[i], b.Hessian[i], tolerance * size);
  }
}

} // namespace

TEST(TetEnergy, InFloatsIsThatInDoubles)
{
  const TetEnergy floats(Floors), doubles(Floors, true);
  RandomDraw random(7);
  int differ = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const ActiveMesh whole = Star(random, 0.1, trial % 2 == 0);
    const ActiveMesh mesh = SomeTets(whole, 0, 1 + trial % 24);
    for (int halfPower : { 1, 2, 8 })
    {
      const SmoothingStage stage = Stage(halfPower);
      const Derivatives d = doubles.Differentiate(mesh, 0, stage);
      if (d.Value < 100.0)
      {
        ExpectNear(floats.Differentiate(mesh, 0, stage), d, 5e-5);
        const double energy = floats.Evaluate(mesh, 0, mesh.X[0], stage);
        EXPECT_NEAR(energy, d.Value, 5e-5 * d.Value);
        differ += energy != d.Value;
      }
    }
  }
  EXPECT_GT(differ, 300); // shows that floats are used
}

TEST(TetEnergy, IsInDoublesWhereFloatsDoNot)
{
  const TetEnergy floats(Floors), doubles(Floors, true);
  RandomDraw random(7);
  const SmoothingStage stage = Stage(1);
  for (bool uniform : { true, false })
  {
    ActiveMesh mesh = Star(random, 0.0, uniform);
    const Vector3 centre = mesh.X[0];
    for (const double height : { 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 0.0, -1e-10, -1e-4, -0.1 })
    {
      // near a face of the hull, so that two tets are nearly flat
      mesh.X[0] = centre + (1.0 - height) * (mesh.X[9] - centre) +
        Scaled(mesh.Widths[0], Vector3{ { 0.0, 0.05, 0.03 } });
      const double energy = doubles.Evaluate(mesh, 0, mesh.X[0], stage);
      EXPECT_EQ(floats.Evaluate(mesh, 0, mesh.X[0], stage), energy);
      if (energy < InvalidEnergy)
      {
        EXPECT_EQ(floats.Differentiate(mesh, 0, stage).Gradient,
          doubles.Differentiate(mesh, 0, stage).Gradient);
      }
    }
  }
  // more neighbours than a star may have: a fan of tets around an edge
  ActiveMesh fan;
  fan.Corners = 4;
  fan.X = { { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } };
  const int count = TetStars::MaximumNeighbours;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    fan.X.push_back({ { std::cos(angle), std::sin(angle), 0.4 } });
    fan.Elements.insert(fan.Elements.end(), { 0, 2 + i, 2 + (i + 1) % count, 1 });
  }
  fan.Widths = { UnitWidths };
  ListCornersOfCentre(fan);
  EXPECT_LT(doubles.Evaluate(fan, 0, fan.X[0], stage), InvalidEnergy);
  EXPECT_EQ(floats.Evaluate(fan, 0, fan.X[0], stage), doubles.Evaluate(fan, 0, fan.X[0], stage));
}
