/// The energy for untangling.
#include "Smoothing/UntangleEnergy.h"

#include "Base/Vector3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vfm;

/// Compares gradient and Hessian with differences, for hexes on both sides of inversion.
TEST(UntangleEnergy, DerivativesAreRight)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-0.6, 0.6);
  UntangleEnergy energy;
  const SmoothingStage stage{ 1, 0.0, 0.3, 1, 0.0 };
  for (int trial = 0; trial < 50; ++trial)
  {
    energy.SetRegularisation(trial % 2 ? 0.05 : 0.3);
    ActiveMesh mesh;
    for (int c = 0; c < 8; ++c)
    {
      mesh.X.push_back(
        { { (c & 1) + any(random), (c >> 1 & 1) + any(random), (c >> 2) + any(random) } });
      mesh.IsActive.push_back(1);
      mesh.Elements.push_back(c);
    }
    mesh.Widths = { { { 1.0, 1.3, 0.8 } } };
    mesh.ListCorners();
    const int point = trial % 8;
    const Derivatives d = energy.Differentiate(mesh, point, stage);
    const Vector3 x = mesh.X[point];
    EXPECT_NEAR(d.Value, energy.Evaluate(mesh, point, x, stage), 1e-12 * d.Value);
    const double h = 1e-6;
    const int entry[3][3] = { { 0, 3, 4 }, { 3, 1, 5 }, { 4, 5, 2 } };
    for (int a = 0; a < 3; ++a)
    {
      Vector3 low = x, high = x;
      low[a] -= h;
      high[a] += h;
      const double slope =
        (energy.Evaluate(mesh, point, high, stage) - energy.Evaluate(mesh, point, low, stage)) /
        (2.0 * h);
      EXPECT_NEAR(d.Gradient[a], slope, 1e-4 * (d.Value + std::fabs(slope)));
      mesh.X[point] = low;
      const Derivatives before = energy.Differentiate(mesh, point, stage);
      mesh.X[point] = high;
      const Derivatives after = energy.Differentiate(mesh, point, stage);
      mesh.X[point] = x;
      for (int b = 0; b < 3; ++b)
      {
        const double curvature = (after.Gradient[b] - before.Gradient[b]) / (2.0 * h);
        EXPECT_NEAR(d.Hessian[entry[a][b]], curvature, 1e-3 * (d.Value + std::fabs(curvature)));
      }
    }
  }
}
