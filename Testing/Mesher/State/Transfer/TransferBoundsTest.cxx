/// The state of elements stays within the values of nearby cells of their material, for any field.
#include "State/StateCases.h"

#include "Base/Vector3.h"
#include "RandomDraw.h"
#include "RankFields.h"
#include "Shapes/ShapesScenes.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Materials = 3;
constexpr int Columns = 14; // columns of MakeCodeQuantities

/// A random field with random values in its cells; values of different
/// materials differ by up to 1e6.
struct RandomState
{
  explicit RandomState(unsigned seed) : Random(seed), Grid(MakeGrid()), Fractions(MakeFractions())
  {
    this->Values.resize(Columns * (Materials + 1) * this->Grid.Global().NumberOfCells());
    const double jump = this->Random.Chance(0.5) ? 1e6 : 1e-6;
    std::size_t i = 0;
    for (double& value : this->Values)
    {
      const std::size_t column = i % Columns, material = i / Columns % (Materials + 1);
      const bool isZero = column == 0 && this->Random.Chance(0.01);
      value = isZero ? 0.0 : this->Random.Between(0.1, 1.1) * (material == 2 ? jump : 1.0);
      value *=
        ((column > 0 && column < 4) || column == 13) && this->Random.Chance(0.5) ? -1.0 : 1.0;
      ++i;
    }
  }

  CartesianGrid MakeGrid()
  {
    const int n = this->Random.Whole(5, 9);
    return this->Random.Chance(0.5) ? MakeUnitGrid(n, n + 1, 6) : MakeUnevenGrid(n);
  }

  FractionField MakeFractions()
  {
    const double kind = this->Random.Between(0.0, 1.0);
    const unsigned seed = this->Random.Seed();
    if (kind < 0.3)
    {
      return MakeRandomLabels(this->Grid, Materials, 0, seed);
    }
    if (kind < 0.6)
    {
      return MakePatchyFractions(this->Grid, Materials, seed);
    }
    std::vector<Shape> shapes;
    const Vector3 upper = this->Grid.NodePoint(this->Grid.Global().Upper);
    for (int m = 1; m <= Materials; ++m)
    {
      for (int i = 0; i < 2; ++i)
      {
        const Vector3 at = this->Random.Vector(0.0, 1.0);
        shapes.push_back(
          MakeSphere(m, Scaled(at, upper), this->Random.Between(0.1, 0.5) * upper[0]));
      }
    }
    return FractionsOfShapes(this->Grid, shapes, Materials, 1e-2);
  }

  const double* Of(const Index3& cell, int material) const
  {
    return this->Values.data() + Columns * ((Materials + 1) * this->Grid.CellKey(cell) + material);
  }

  RandomDraw Random;
  CartesianGrid Grid;
  FractionField Fractions;
  std::vector<double> Values;
};

StateCase MakeCase(RandomState& state)
{
  StateCase c{ state.Grid, state.Fractions,
    [&state](const CartesianGrid&, const Index3& cell, int material, double* values)
    {
      std::copy_n(state.Of(cell, material), Columns, values);
      const double fraction = state.Fractions.Fraction(state.Grid.Linear(cell), material);
      values[Columns - 1] /= fraction > 0.0 ? fraction : 1.0; // sums, however small the fraction
    } };
  c.Quantities = MakeCodeQuantities();
  c.Density = 0;
  c.Make = state.Random.Chance(0.5) ? MakeHexMesh : MakeTetMesh;
  c.Options.Method = state.Random.Chance(0.5) ? TetMethod::Cells : TetMethod::Lattice;
  c.Options.MeshVoid = state.Random.Chance(0.3);
  c.Options.StairStep = state.Random.Chance(0.1);
  c.Options.Smoothing =
    state.Random.Chance(0.3) ? SmoothingMethod::Off : SmoothingMethod::QuadricSurface;
  c.Order = state.Random.Chance(0.2) ? 1 : 2;
  c.GiveUnmeshed = state.Random.Chance(0.5);
  // Conserving volumes takes most of the time.
  c.Options.ConserveVolume = state.Random.Chance(0.25);
  return c;
}

/// Smallest and largest value of a material in cells near a box.
struct Range
{
  double Least = 1e300, Most = -1e300;
  void Add(double value)
  {
    this->Least = std::min(this->Least, value);
    this->Most = std::max(this->Most, value);
  }
  /// Returns how far a value lies outside, relative to the largest value.
  double Excess(double value) const
  {
    const double outside = std::max(this->Least - value, value - this->Most);
    return outside / std::max(std::fabs(this->Least), std::fabs(this->Most));
  }
};

std::vector<Range> FindRanges(const RandomState& state, const ElementOutcome& element, int reach)
{
  const IndexBox cells = Grow(Intersect({ state.Grid.CellAt(element.Lower),
                                          CornerOfCell(state.Grid.CellAt(element.Upper), 7) },
                                state.Grid.Global()),
    reach, state.Grid.Global());
  std::vector<Range> ranges(Columns);
  ForCells(cells,
    [&](const Index3& p)
    {
      if (state.Fractions.Fraction(state.Grid.Linear(p), element.Material) > 0.0)
      {
        const double* values = state.Of(p, element.Material);
        for (int c = 0; c < Columns; ++c)
        {
          ranges[c].Add(values[c]);
        }
      }
    });
  return ranges;
}

std::string CheckSeed(unsigned seed)
{
  RandomState state(seed);
  const StateCase c = MakeCase(state);
  const StateOutcome outcome = TransferAlone(c);
  std::string problem = FindTotalsProblem(c, outcome);
  double worst = 0.0, worstDensity = 0.0;
  for (const auto& entry : outcome.Elements)
  {
    const ElementOutcome& e = entry.second;
    const std::vector<Range> ranges = FindRanges(state, e, c.GiveUnmeshed ? 5 : 4);
    if (ranges[0].Most < ranges[0].Least)
    {
      continue; // no cell has this label
    }
    const std::array<double, 2>& factors = outcome.Factors[e.Material];
    for (int q = 0; q < Columns; ++q)
    {
      const double value = e.Values[q];
      if (!std::isfinite(value))
      {
        return problem + "not finite";
      }
      if (q == 0)
      {
        worstDensity =
          std::max({ worstDensity, (factors[0] * ranges[0].Least - value) / ranges[0].Most,
            value / (factors[1] * ranges[0].Most) - 1.0 });
      }
      else if (q < 7)
      {
        worst = std::max(worst, ranges[q].Excess(value));
      }
    }
  }
  if (worst > 1e-12 || worstDensity > 1e-11) // volumes of thin elements are rounded
  {
    problem +=
      "outside by " + std::to_string(worst) + ", densities by " + std::to_string(worstDensity);
    std::printf(
      "seed %u %s: %g %g\n", seed, c.Make == MakeHexMesh ? "hex" : "tet", worst, worstDensity);
  }
  return problem;
}

} // namespace

TEST(TransferBounds, SomeRandomFields)
{
  for (unsigned seed : ListSeeds(24))
  {
    EXPECT_EQ(CheckSeed(seed), "") << "seed " << seed;
  }
}

class TransferSweep : public ::testing::TestWithParam<unsigned>
{
};

TEST_P(TransferSweep, RandomFieldsStayWithinBounds)
{
  for (unsigned seed : ListSeeds(1000, this->GetParam(), 4))
  {
    EXPECT_EQ(CheckSeed(seed), "") << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, TransferSweep, ::testing::Range(0U, 4U));
