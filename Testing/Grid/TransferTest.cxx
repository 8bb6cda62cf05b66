/// State carried to meshes: totals, bounds, constants, linear fields, order.
#include "StateCases.h"

#include "Base/Vector3.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

Vector3 CentreOf(const CartesianGrid& grid, const Index3& p)
{
  return 0.5 * (grid.NodePoint(p) + grid.NodePoint(CornerOfCell(p, 7)));
}

/// What a code may have in a cell; see MakeCodeQuantities.
void FillSmooth(const CartesianGrid& grid, const Index3& p, int material, double* v)
{
  const Vector3 x = 1.0 / static_cast<double>(grid.Global().Upper[0]) * CentreOf(grid, p);
  const double jump = material == 1 ? 1.0 : 1e6;
  v[0] = jump * (1.0 + 0.5 * x[0] + 0.3 * x[1] * x[1]);
  for (int a = 0; a < 3; ++a)
  {
    v[1 + a] = std::sin(2.0 * x[a]) + x[2] + 0.3 * material;
  }
  v[4] = 2.0 + x[1] * x[2];
  v[5] = 400.0 + 100.0 * x[0];
  v[6] = 300.0 + 50.0 * std::cos(3.0 * x[1]);
  for (int i = 0; i < 6; ++i)
  {
    v[7 + i] = x[i % 3] - 0.2 * i;
  }
  v[13] = grid.CellVolume(p) * (1.0 + x[0]);
}

std::vector<MeshMaker> AllMakers()
{
  return { MakeHexMesh, MakeTetMesh };
}

} // namespace

TEST(TransferState, TotalsStay)
{
  for (const char* name : { "sphere 8", "sphere 16", "ball of 3 sectors", "half sphere" })
  {
    SCOPED_TRACE(name);
    const MeshCase shape = MakeMeshCase(name);
    for (MeshMaker make : AllMakers())
    {
      StateCase c{ shape.Grid, shape.Fractions, FillSmooth };
      c.Quantities = MakeCodeQuantities();
      c.Density = 0;
      c.Make = make;
      const StateOutcome outcome = TransferAlone(c);
      EXPECT_EQ(FindTotalsProblem(c, outcome), "");
      for (std::size_t m = 0; m < outcome.Factors.size(); ++m)
      {
        std::printf("%s material %zu: factors %.12g %.12g, unmeshed %g of %g\n", name, m,
          outcome.Factors[m][0], outcome.Factors[m][1], outcome.Unmeshed[m][0], outcome.Input[m][0]);
      }
    }
  }
}

namespace
{

/// The cells of a mesh that lie so deep in a ball that no interface is near.
bool IsInside(const ElementOutcome& e, const Vector3& centre, double radius)
{
  Vector3 farthest;
  for (int a = 0; a < 3; ++a)
  {
    farthest[a] = std::max(centre[a] - e.Lower[a], e.Upper[a] - centre[a]);
  }
  return Norm(farthest) < radius;
}

} // namespace

TEST(TransferState, LinearFieldsAndConstantsAreMet)
{
  for (bool isUneven : { false, true })
  {
    const CartesianGrid grid = isUneven ? MakeUnevenGrid(48) : MakeUnitGrid(32);
    const Vector3 size = grid.NodePoint(grid.Global().Upper);
    const Vector3 centre = 0.5 * size;
    const double radius = 0.42 * size[0], width = isUneven ? 2.0 : 1.0;
    const FractionField fractions = FractionsOfShapes(grid, { MakeSphere(1, centre, radius) });
    const auto linear = [](const Vector3& x) { return 2.0 + 0.03 * x[0] - 0.02 * x[1] + 0.01 * x[2]; };
    for (MeshMaker make : AllMakers())
    {
      SCOPED_TRACE(std::string(isUneven ? "uneven " : "even ") + (make == MakeHexMesh ? "hexes" : "tets"));
      StateCase c{ grid, fractions,
        [&](const CartesianGrid& g, const Index3& p, int, double* v)
        {
          v[0] = linear(CentreOf(g, p));
          v[1] = 3.0;
          v[2] = linear(CentreOf(g, p));
          v[3] = 7.0;
        } };
      c.Quantities = { { StateKind::PerVolume, 2, -1 }, { StateKind::PerMass, 2, -1 } };
      c.Make = make;
      const StateOutcome outcome = TransferAlone(c);
      double worstLinear = 0.0, worstConstant = 0.0, worstFactor = 0.0;
      Index inside = 0;
      const std::array<double, 2>& factors = outcome.Factors[1];
      for (const auto& entry : outcome.Elements)
      {
        const ElementOutcome& e = entry.second;
        worstFactor = std::max({ worstFactor, factors[0] * 3.0 - e.Values[1], e.Values[1] - factors[1] * 3.0 });
        worstConstant = std::max(worstConstant, std::fabs(e.Values[3] - 7.0));
        if (IsInside(e, centre, radius - 6.0 * width))
        {
          ++inside;
          worstLinear = std::max({ worstLinear, std::fabs(e.Values[0] - linear(e.Mean)),
            std::fabs(e.Values[2] - linear(e.Mean)) });
        }
      }
      std::printf("%s: linear %g in %lld inside, constants %g, per volume %g, factors %.12g %.12g\n", make == MakeHexMesh ? "hexes" : "tets", worstLinear,
        static_cast<long long>(inside), worstConstant, worstFactor, factors[0] - 1.0, factors[1] - 1.0);
      EXPECT_GT(inside, 100);
      EXPECT_LT(worstLinear, 1e-12);
      EXPECT_LT(worstConstant, 1e-13 * 7.0);
      EXPECT_LT(worstFactor, 1e-13 * 3.0);
    }
  }
}

namespace
{

struct Errors
{
  double All = 0.0, Inside = 0.0, Most = 0.0;
};

/// Of density and velocity on a ball in n^3 cells.
std::array<Errors, 2> MeasureErrors(int n, int order, MeshMaker make)
{
  std::array<std::vector<double>, 3> x;
  for (auto& axis : x)
  {
    for (int i = 0; i <= n; ++i)
    {
      axis.push_back(-0.5 + static_cast<double>(i) / n);
    }
  }
  const CartesianGrid grid(x);
  const FractionField fractions =
    FractionsOfShapes(grid, { MakeSphere(1, { { 0.01, 0.02, -0.01 } }, 0.37) });
  const auto density = [](const Vector3& p) { return 1.0 + 0.5 * p[0] + 0.3 * p[1] * p[1]; };
  const auto velocity = [](const Vector3& p) { return std::sin(2.0 * p[0]) + p[2] + 0.3; };
  StateCase c{ grid, fractions,
    [&](const CartesianGrid& g, const Index3& p, int, double* v)
    {
      v[0] = density(CentreOf(g, p));
      v[1] = velocity(CentreOf(g, p));
    } };
  c.Quantities = { { StateKind::PerVolume, 1, -1 }, { StateKind::PerMass, 1, -1 } };
  c.Density = 0;
  c.Order = order;
  c.Make = make;
  const StateOutcome outcome = TransferAlone(c);
  EXPECT_EQ(FindTotalsProblem(c, outcome), "");
  std::array<Errors, 2> errors;
  std::array<double, 2> volumes{};
  for (const auto& entry : outcome.Elements)
  {
    const ElementOutcome& e = entry.second;
    const double radius = Norm(e.Centroid - Vector3{ { 0.01, 0.02, -0.01 } });
    const bool isInside = radius < 0.37 - 6.0 / n;
    volumes[0] += e.Volume;
    volumes[1] += isInside ? e.Volume : 0.0;
    const std::array<double, 2> truth{ { density(e.Centroid), velocity(e.Centroid) } };
    for (int q = 0; q < 2; ++q)
    {
      const double error = std::fabs(e.Values[q] - truth[q]);
      errors[q].All += e.Volume * error;
      errors[q].Inside += isInside ? e.Volume * error : 0.0;
      errors[q].Most = std::max(errors[q].Most, error);
    }
  }
  for (Errors& error : errors)
  {
    error.All /= volumes[0];
    error.Inside /= volumes[1] > 0.0 ? volumes[1] : 1.0;
  }
  return errors;
}

} // namespace

TEST(TransferState, OrderOnABall)
{
  for (MeshMaker make : AllMakers())
  {
    for (int order : { 1, 2 })
    {
      for (int n : { 16, 24, 32, 40, 64 })
      {
        const std::array<Errors, 2> errors = MeasureErrors(n, order, make);
        std::printf("%s order %d, %d cells: density %.3g inside %.3g most %.3g, velocity %.3g inside %.3g most %.3g\n",
          make == MakeHexMesh ? "hexes" : "tets", order, n, errors[0].All, errors[0].Inside, errors[0].Most, errors[1].All,
          errors[1].Inside, errors[1].Most);
      }
    }
  }
}
