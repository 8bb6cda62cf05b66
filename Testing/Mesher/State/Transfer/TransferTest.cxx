/// State transferred to meshes: totals, bounds, constants, linear fields, order.
#include "State/StateCases.h"

#include "Base/Vector3.h"
#include "Base/WideSum.h"
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

/// Sets the quantities of MakeCodeQuantities, typical state of a simulation.
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
  v[13] = jump - x[0];
}

std::vector<MeshMaker> AllMakers()
{
  return { MakeHexMesh, MakeTetMesh };
}

} // namespace

TEST(StateSums, NoOrderAndNoSizeMatters)
{
  std::mt19937 random(3);
  std::vector<double> values{ 1e300, -1e300, 1e-300, 5e-324, -0.0, 1.0, -3.0 };
  for (int i = 0; i < 2000; ++i)
  {
    const double value =
      std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 80) - 60);
    values.push_back(random() % 2 == 0 ? value : -value);
  }
  long double expected = 0.0L;
  for (std::size_t i = 5; i < values.size(); ++i)
  {
    expected += values[i];
  }
  std::vector<double> sums;
  for (int turn = 0; turn < 3; ++turn)
  {
    std::shuffle(values.begin(), values.end(), random);
    WideSum sum;
    std::for_each(values.begin(), values.end(), [&sum](double value) { sum.Add(value); });
    sums.push_back(sum.Value());
  }
  EXPECT_EQ(sums[0], sums[1]);
  EXPECT_EQ(sums[0], sums[2]);
  EXPECT_NEAR(sums[0], expected, 1e-15 * std::fabs(expected));
  WideSum small;
  small.Add(1e300);
  small.Add(-3e-310);
  small.Add(-1e300);
  EXPECT_EQ(small.Value(), -3e-310);
  small.Add(HUGE_VAL);
  EXPECT_TRUE(std::isnan(small.Value()));
}

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
      for (std::size_t m = 1; m < outcome.Factors.size(); ++m)
      {
        EXPECT_NEAR(outcome.Factors[m][0], 1.0, 1e-5) << m;
        EXPECT_NEAR(outcome.Factors[m][1], 1.0, 1e-5) << m;
        EXPECT_EQ(outcome.Unmeshed[m][0], 0.0) << m;
      }
    }
  }
}

TEST(TransferState, TotalsStayInTetsOfTetGen)
{
  if (!HasTetGen())
  {
    GTEST_SKIP() << "built without TetGen";
  }
  const MeshCase shape = MakeMeshCase("sphere 8");
  StateCase c{ shape.Grid, shape.Fractions, FillSmooth };
  c.Quantities = MakeCodeQuantities();
  c.Density = 0;
  c.Make = MakeTetMesh;
  c.Options.Method = TetMethod::TetGen;
  for (int ranks : { 1, 2, 3 })
  {
    EXPECT_EQ(FindTotalsProblem(c, TransferOnRanks(c, CutBox(shape.Grid.Global(), ranks))), "")
      << ranks << " ranks";
  }
}

namespace
{

/// Returns whether an element lies in a ball, so deep that no interface is near.
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
    const auto linear = [](const Vector3& x)
    { return 2.0 + 0.03 * x[0] - 0.02 * x[1] + 0.01 * x[2]; };
    for (MeshMaker make : AllMakers())
    {
      SCOPED_TRACE(
        std::string(isUneven ? "uneven " : "even ") + (make == MakeHexMesh ? "hexes" : "tets"));
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
        worstFactor =
          std::max({ worstFactor, factors[0] * 3.0 - e.Values[1], e.Values[1] - factors[1] * 3.0 });
        worstConstant = std::max(worstConstant, std::fabs(e.Values[3] - 7.0));
        if (IsInside(e, centre, radius - 6.0 * width))
        {
          ++inside;
          worstLinear = std::max({ worstLinear, std::fabs(e.Values[0] - linear(e.Mean)),
            std::fabs(e.Values[2] - linear(e.Mean)) });
        }
      }
      std::printf(
        "%s: linear %g in %lld inside, constants %g, per volume %g, factors %.12g %.12g\n",
        make == MakeHexMesh ? "hexes" : "tets", worstLinear, static_cast<long long>(inside),
        worstConstant, worstFactor, factors[0] - 1.0, factors[1] - 1.0);
      EXPECT_GT(inside, 100);
      EXPECT_LT(worstLinear, 1e-12);
      EXPECT_LT(worstConstant, 1e-13 * 7.0);
      EXPECT_LT(worstFactor, 1e-13 * 3.0);
    }
  }
}

namespace
{

/// Density 2; the velocity depends on the half of the domain.
const std::vector<StateQuantity> SideQuantities{ { StateKind::PerVolume, 1, -1 },
  { StateKind::PerMass, 1, -1 } };

void FillSides(const CartesianGrid& grid, const Index3& p, int, double* v)
{
  v[0] = 2.0;
  v[1] = 2 * p[0] < grid.Global().Upper[0] ? 3.0 : -5.0;
}

StateCase MakeSideCase(const CartesianGrid& grid, const FractionField& fractions)
{
  StateCase c{ grid, fractions, FillSides };
  c.Quantities = SideQuantities;
  c.Density = 0;
  return c;
}

} // namespace

/// Inner and outer sides each have another volume in the mesh than in the cells; the totals agree.
TEST(TransferState, HollowBodiesStayAsDenseAsTheyAre)
{
  const CartesianGrid grid = MakeUnitGrid(24);
  const Vector3 middle{ { 12.1, 12.0, 11.8 } };
  const FractionField fractions = FractionsOfShapes(grid,
    { MakeFunctionShape(1,
      [&middle](const Vector3& x)
      {
        const Vector3 d = x - middle;
        const double side = std::max({ std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2]) });
        return std::max(side - 10.4, 4.7 - Norm(d));
      }) });
  for (MeshMaker make : AllMakers())
  {
    StateCase c{ grid, fractions,
      [](const CartesianGrid&, const Index3& p, int, double* v)
      {
        v[0] = 3.0;
        v[1] = static_cast<double>(p[0] % 3);
      } };
    c.Quantities = { { StateKind::PerVolume, 1, -1 }, { StateKind::PerMass, 1, -1 } };
    c.Density = 0;
    c.Make = make;
    const StateOutcome outcome = TransferAlone(c);
    EXPECT_EQ(FindTotalsProblem(c, outcome), "");
    double worst = 0.0;
    for (const auto& entry : outcome.Elements)
    {
      worst = std::max(worst, std::fabs(entry.second.Values[0] / 3.0 - 1.0));
    }
    std::printf("%s: densities off by %.2g, factors by %.2g %.2g\n",
      make == MakeHexMesh ? "hexes" : "tets", worst, outcome.Factors[1][0] - 1.0,
      outcome.Factors[1][1] - 1.0);
    EXPECT_LT(worst, 1e-6);
  }
}

/// Models a region of void that was removed: contents flow through the whole bar.
TEST(TransferState, ALongBarIsFilledFromItsEnd)
{
  const CartesianGrid grid = MakeUnitGrid(120, 5, 5);
  const auto fill = [&grid](double length)
  {
    return FractionsOfShapes(
      grid, { MakeBox(1, { { 4.0 + 0.5 * length, 2.5, 2.5 } }, { { length, 3.0, 3.0 } }) });
  };
  const FractionField meshed = fill(112.0), held = fill(8.0);
  class Values : public StateCellValues
  {
    void Read(const Index3&, int, double* values) const override { values[0] = 2.0; }
  };
  Runtime alone;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(grid, meshed, MeshOptions(), alone, report);
  const Values values;
  const TransferredState state = TransferState(
    mesh, { grid, held, values, { { StateKind::PerVolume, 1, -1 } }, 0, 2, true }, alone);
  EXPECT_NEAR(state.Factors[1][0], 8.0 / 112.0, 1e-6);
  for (double density : state.Values[0])
  {
    EXPECT_NEAR(density, 2.0 * state.Factors[1][0], 1e-9);
  }
}

TEST(TransferState, FragmentsKeepTheirOwn)
{
  const CartesianGrid grid = MakeUnitGrid(20, 10, 10);
  const FractionField fractions = FractionsOfShapes(grid,
    { MakeSphere(1, { { 6.0, 5.0, 5.0 } }, 3.4), MakeSphere(1, { { 13.8, 5.2, 5.0 } }, 3.4) });
  const StateCase c = MakeSideCase(grid, fractions);
  const StateOutcome outcome = TransferAlone(c);
  EXPECT_EQ(FindTotalsProblem(c, outcome), "");
  std::map<int, std::array<double, 2>> fragments; // mass, momentum
  for (const auto& entry : outcome.Elements)
  {
    std::array<double, 2>& sums = fragments[entry.second.Fragment];
    sums[0] += entry.second.Mass;
    sums[1] += entry.second.Mass * entry.second.Values[1];
  }
  ASSERT_EQ(fragments.size(), 2u);
  for (const auto& fragment : fragments)
  {
    const double velocity = fragment.second[1] / fragment.second[0];
    EXPECT_TRUE(std::fabs(velocity - 3.0) < 1e-13 || std::fabs(velocity + 5.0) < 1e-13) << velocity;
  }
}

TEST(TransferState, SprayIsGivenOrCounted)
{
  const CartesianGrid grid = MakeUnitGrid(16);
  FractionField fractions =
    FractionsOfShapes(grid, { MakeSphere(1, { { 6.0, 8.0, 8.0 } }, 3.5) }, 2);
  fractions.SetParts(grid.Linear({ { 11, 8, 8 } }), { { 1, 0.2 } }); // two cells from the ball
  fractions.SetParts(grid.Linear({ { 15, 8, 8 } }), { { 1, 0.1 }, { 2, 0.2 } });
  StateCase c = MakeSideCase(grid, fractions);
  for (bool give : { true, false })
  {
    c.GiveUnmeshed = give;
    const StateOutcome outcome = TransferAlone(c);
    EXPECT_EQ(FindTotalsProblem(c, outcome), "");
    const double left = give ? 0.1 : 0.1 + 0.2;
    EXPECT_NEAR(outcome.Unmeshed[1][0], left, 1e-15);
    EXPECT_NEAR(outcome.Unmeshed[1][1], 2.0 * left, 1e-15);
    EXPECT_NEAR(outcome.Unmeshed[1][3], -5.0 * 2.0 * left, 1e-14);
    EXPECT_NEAR(outcome.Unmeshed[2][0], 0.2, 1e-15); // a material without elements
  }
}

TEST(TransferState, InputIsWhatCellsHold)
{
  const CartesianGrid grid = MakeUnevenGrid(8);
  const FractionField fractions = MakePatchyFractions(grid, 2, 3);
  StateCase c{ grid, fractions,
    [](const CartesianGrid&, const Index3& p, int material, double* v)
    {
      v[0] = 1.0 + static_cast<double>(p[0]);
      v[1] = static_cast<double>(p[1]) - 2.0 * material;
    } };
  c.Quantities = SideQuantities;
  c.Density = 0;
  c.Options.MeshVoid = true;
  const StateOutcome outcome = TransferAlone(c);
  EXPECT_EQ(FindTotalsProblem(c, outcome), "");
  long double volume = 0.0L, mass = 0.0L, momentum = 0.0L;
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      const long double part = grid.CellVolume(p) * fractions.Fraction(grid.Linear(p), 1);
      volume += part;
      mass += part * (1 + p[0]);
      momentum += part * (1 + p[0]) * (p[1] - 2);
    });
  EXPECT_NEAR(outcome.Input[1][0], volume, 1e-13 * volume);
  EXPECT_NEAR(outcome.Input[1][1], mass, 1e-13 * mass);
  EXPECT_NEAR(outcome.Input[1][3], momentum, 1e-13 * std::fabs(momentum));
}

TEST(TransferState, NoMassAndNoNumbersDoNoHarm)
{
  const MeshCase shape = MakeMeshCase("sphere 8");
  for (double density : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    StateCase c = MakeSideCase(shape.Grid, shape.Fractions);
    c.Function = [density](const CartesianGrid& grid, const Index3& p, int material, double* v)
    {
      FillSides(grid, p, material, v);
      v[0] = (p[2] & 1) == 0 ? density : 0.0;
    };
    const StateOutcome outcome = TransferAlone(c);
    for (const auto& entry : outcome.Elements)
    {
      const ElementOutcome& e = entry.second;
      if (density == 0.0)
      {
        EXPECT_EQ(e.Values[0], 0.0);
        EXPECT_TRUE(e.Values[1] > -5.0 - 1e-14 && e.Values[1] < 3.0 + 1e-14) << e.Values[1];
      }
    }
    EXPECT_EQ(std::isfinite(outcome.Input[1][1]), std::isfinite(density));
  }
}

namespace
{

struct Errors
{
  double All = 0.0, Inside = 0.0, Most = 0.0;
};

/// Returns the errors of density and velocity on a ball in n^3 cells.
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

TEST(TransferState, SecondOrderOnABall)
{
  for (MeshMaker make : AllMakers())
  {
    std::array<Errors, 2> coarser{};
    for (int n : { 16, 32, 64 })
    {
      const std::array<Errors, 2> errors = MeasureErrors(n, 2, make);
      for (int q = 0; q < 2; ++q)
      {
        std::printf("%s, %d cells, %s: L1 %.3g, inside %.3g, largest %.3g\n",
          make == MakeHexMesh ? "hexes" : "tets", n, q == 0 ? "density" : "velocity", errors[q].All,
          errors[q].Inside, errors[q].Most);
        EXPECT_TRUE(n == 16 || coarser[q].All > 3.5 * errors[q].All);
        EXPECT_TRUE(
          n < 64 || coarser[q].Inside > 3.5 * errors[q].Inside || errors[q].Inside < 1e-16);
      }
      coarser = errors;
    }
  }
}
