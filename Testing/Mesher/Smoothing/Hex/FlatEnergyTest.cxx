#include "Smoothing/Hex/FlatEnergy.h"

#include "Smoothing/Hex/FlatDiagonals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vfm;

namespace
{

/// Returns 2 x 2 hexes of one layer across an axis, shaken in its plane, around point 0.
ActiveMesh MakeStar(int axis, double shake, unsigned seed)
{
  std::mt19937 engine(seed);
  const auto random = [&] { return shake * (engine() * (2.0 / 4294967296.0) - 1.0); };
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  ActiveMesh mesh;
  Vector3 widths{};
  widths[u] = 1.5;
  widths[v] = 0.5;
  widths[axis] = 0.7;
  mesh.Widths = { widths };
  const auto number = [](int i, int j, int k)
  {
    const int n = i + 3 * j;
    return (n == 4 ? 0 : n < 4 ? n + 1 : n) + 9 * k;
  };
  mesh.X.resize(18);
  for (int n = 0; n < 9; ++n)
  {
    Vector3 x{};
    x[u] = (n % 3 - 1 + random()) * widths[u];
    x[v] = (n / 3 - 1 + random()) * widths[v];
    mesh.X[number(n % 3, n / 3, 0)] = x;
    x[axis] = widths[axis];
    mesh.X[number(n % 3, n / 3, 1)] = x;
  }
  for (int hex = 0; hex < 4; ++hex)
  {
    for (int c = 0; c < 8; ++c)
    {
      mesh.Elements.push_back(
        number((hex & 1) + (c >> u & 1), (hex >> 1) + (c >> v & 1), c >> axis & 1));
    }
  }
  mesh.IsActive.assign(18, 0);
  mesh.IsActive[0] = 1;
  mesh.ListCorners();
  return mesh;
}

constexpr double Target = 0.55;
const SmoothingStage Stage{ 8, 60.0, 0.01, 30, 2e-3 };

} // namespace

TEST(FlatEnergy, IsThatOfPerfectCells)
{
  const ActiveMesh mesh = MakeStar(2, 0.0, 1);
  const double energy = FlatEnergy(Target, 2).Evaluate(mesh, 0, mesh.X[0], Stage);
  // 4 quads of 3 corners, and 2 edges of each with 2 ends.
  const double expected = 12 * (std::pow(Target, 16) + Stage.Omega) + 16 * std::pow(0.15, 8);
  EXPECT_NEAR(energy, expected, 1e-12 * expected);
}

/// Expects the derivatives of differences.
void ExpectDerivatives(const ActiveMesh& mesh, const FlatEnergy& energy, int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto at = [&](double du, double dv)
  {
    Vector3 x = mesh.X[0];
    x[u] += du;
    x[v] += dv;
    return energy.Evaluate(mesh, 0, x, Stage);
  };
  ASSERT_LT(at(0, 0), 1e6);
  const Derivatives d = energy.Differentiate(mesh, 0, Stage);
  const double e = 1e-5, scale = 1e-3 * (1.0 + d.Value) * 100;
  const int mixed = axis == 2 ? 3 : axis == 1 ? 4 : 5;
  EXPECT_NEAR(d.Value, at(0, 0), 1e-12 * d.Value);
  EXPECT_NEAR(d.Gradient[u], (at(e, 0) - at(-e, 0)) / (2 * e), 1e-3 * scale);
  EXPECT_NEAR(d.Gradient[v], (at(0, e) - at(0, -e)) / (2 * e), 1e-3 * scale);
  EXPECT_EQ(d.Gradient[axis], 0.0);
  EXPECT_NEAR(d.Hessian[u], (at(e, 0) - 2 * at(0, 0) + at(-e, 0)) / (e * e), scale);
  EXPECT_NEAR(d.Hessian[v], (at(0, e) - 2 * at(0, 0) + at(0, -e)) / (e * e), scale);
  EXPECT_NEAR(
    d.Hessian[mixed], (at(e, e) - at(e, -e) - at(-e, e) + at(-e, -e)) / (4 * e * e), scale);
}

TEST(FlatEnergy, DerivativesAreThoseOfDifferences)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
      const ActiveMesh mesh = MakeStar(axis, 0.25, seed);
      ExpectDerivatives(mesh, FlatEnergy(Target, axis), axis);
      FlatDiagonals diagonals(axis);
      ExpectDerivatives(mesh, FlatEnergy(Target, axis, &diagonals), axis);
      diagonals.Turn(mesh);
      ExpectDerivatives(mesh, FlatEnergy(Target, axis, &diagonals), axis);
    }
  }
}

TEST(FlatEnergy, TrianglesOfPerfectCells)
{
  const ActiveMesh mesh = MakeStar(2, 0.0, 1);
  FlatDiagonals diagonals(2);
  const double energy = FlatEnergy(Target, 2, &diagonals).Evaluate(mesh, 0, mesh.X[0], Stage);
  // Cells of 1.5 x 0.5: sines of 1 at the right angle, of 3 and 1 / sqrt(10) at the others.
  const double target = Target * std::sqrt(2.0 / (1.5 * 1.5 + 0.5 * 0.5)) * 0.5, area = 0.75;
  const double corners = std::pow(target, 16) * (1 + std::pow(10.0, 8) + std::pow(10.0 / 9.0, 8));
  const double shape = Stage.Omega * (1.5 * 1.5 + 0.5 * 0.5) * 2 / area;
  const double shortest = 0.15 * 0.15 * area;
  const auto ends = [&](double length) { return 2 * std::pow(shortest / (length * length), 4); };
  // Six triangles: two at each diagonal through the point, and two others.
  const double edges = 4 * (ends(1.5) + ends(0.5) + ends(std::sqrt(2.5)));
  EXPECT_NEAR(energy, 6 * (corners + shape) + edges, 1e-12 * energy);
}

TEST(FlatEnergy, DiagonalsTurnWhereThatLeavesLargerAngles)
{
  ActiveMesh mesh = MakeStar(2, 0.0, 1);
  FlatDiagonals diagonals(2);
  EXPECT_TRUE(diagonals.Turn(mesh).empty()); // both are equal
  // Smallest angles of the lower cells: 13 and 18 degrees, then 18 and 25; above they would shrink.
  mesh.X[0] = { { 0.6, 0.2, 0.0 } };
  EXPECT_EQ(diagonals.Turn(mesh).size(), 8u);
  for (int hex = 0; hex < 4; ++hex)
  {
    EXPECT_EQ(diagonals.IsTurned(hex), hex < 2);
  }
  EXPECT_TRUE(diagonals.Turn(mesh).empty());
  const FlatEnergy energy(Target, 2, &diagonals);
  EXPECT_LT(energy.Evaluate(mesh, 0, mesh.X[0], Stage), InvalidEnergy);
}

TEST(FlatEnergy, InvertedQuadsAreInvalidAndLost)
{
  ActiveMesh mesh = MakeStar(2, 0.0, 1);
  const FlatEnergy energy(Target, 2);
  const Vector3 beyond{ { 1.6, 0.0, 0.0 } };
  EXPECT_GE(energy.Evaluate(mesh, 0, beyond, Stage), InvalidEnergy);
  EXPECT_FALSE(energy.KeepsAt(mesh, 0, beyond));
  EXPECT_TRUE(energy.KeepsAt(mesh, 0, { { 0.5, 0.1, 0.0 } }));
  Runtime serial;
  std::vector<unsigned char> points(18, 0);
  EXPECT_FALSE(energy.MarkLost(mesh, serial, {}, {}, points));
  mesh.X[0] = beyond;
  EXPECT_TRUE(energy.MarkLost(mesh, serial, {}, {}, points));
  EXPECT_EQ(points[0], 1);
}

TEST(FlatEnergy, QuadsThatAreNotConvexHaveValidTriangles)
{
  ActiveMesh mesh = MakeStar(2, 0.0, 1);
  // The corner of the last cell at the point is beyond the line between its neighbours.
  const Vector3 dent{ { 0.8, 0.26, 0.0 } };
  FlatDiagonals diagonals(2);
  const FlatEnergy quads(Target, 2), triangles(Target, 2, &diagonals);
  EXPECT_GE(quads.Evaluate(mesh, 0, dent, Stage), InvalidEnergy);
  EXPECT_LT(triangles.Evaluate(mesh, 0, dent, Stage), InvalidEnergy);
  EXPECT_FALSE(quads.KeepsAt(mesh, 0, dent));
  EXPECT_TRUE(triangles.KeepsAt(mesh, 0, dent));
  mesh.X[0] = dent;
  Runtime serial;
  std::vector<unsigned char> points(18, 0);
  EXPECT_TRUE(quads.MarkLost(mesh, serial, {}, {}, points));
  EXPECT_FALSE(triangles.MarkLost(mesh, serial, {}, {}, points));
}
