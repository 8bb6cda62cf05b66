/// Volume fractions from level sets: planes exactly, curved bodies to 1e-4 of their volume.
#include "Fractions/LevelSetCell.h"

#include "Base/Vector3.h"
#include "Fractions/Plic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

using namespace vfm;

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

using Function = std::function<double(const Vector3&)>;
using Nodes = std::array<std::vector<double>, 3>;

/// Returns the nodes of n equal cells in [-1, 1], or of cells that widen.
Nodes MakeNodes(int n, double widening = 0.0)
{
  Nodes nodes;
  for (std::vector<double>& x : nodes)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double s = static_cast<double>(i) / n;
      x.push_back(2.0 * (s + widening * s * (s - 1.0)) - 1.0);
    }
  }
  return nodes;
}

StencilValues ValuesAround(const Function& f, const Nodes& nodes, const Index3& cell)
{
  const StencilPlaces places = PlacesAround(nodes, cell);
  StencilValues values{};
  for (int s = 0; s < StencilCells; ++s)
  {
    const std::array<int, 3> at{ { s % 5, s / 5 % 5, s / 25 } };
    bool isInside = true;
    Vector3 centre{};
    for (int a = 0; a < 3; ++a)
    {
      const Index i = cell[a] + at[a] - LevelSetLayers;
      isInside = isInside && i >= 0 && i + 1 < static_cast<Index>(nodes[a].size());
      centre[a] = places.Centres[a][at[a]];
    }
    values[s] = isInside ? f(centre) : NotKnown;
  }
  FillUnknown(places, values);
  return values;
}

/// Returns the volume of each material in [-1, 1]^3.
std::vector<double> VolumesOf(
  const std::vector<Function>& functions, const Nodes& nodes, LevelSetRule rule)
{
  std::vector<double> volumes(functions.size(), 0.0);
  const auto count = [&](int a) { return static_cast<Index>(nodes[a].size()) - 1; };
  ForCells({ {}, { { count(0), count(1), count(2) } } },
    [&](const Index3& cell)
    {
      std::vector<StencilValues> values;
      double volume = 1.0;
      for (int a = 0; a < 3; ++a)
      {
        volume *= nodes[a][cell[a] + 1] - nodes[a][cell[a]];
      }
      for (const Function& f : functions)
      {
        values.push_back(ValuesAround(f, nodes, cell));
      }
      const int only = FindOnlyMaterial(values, rule);
      const std::vector<double> fractions =
        FractionsOfFunctions(PlacesAround(nodes, cell), values, rule);
      for (std::size_t m = 0; m < functions.size(); ++m)
      {
        EXPECT_GE(fractions[m], 0.0);
        if (only >= 0)
        {
          EXPECT_NEAR(fractions[m], static_cast<int>(m) + 1 == only ? 1.0 : 0.0, 0.02);
        }
        volumes[m] +=
          volume * (only < 0 ? fractions[m] : (static_cast<int>(m) + 1 == only ? 1.0 : 0.0));
      }
      EXPECT_LE(std::accumulate(fractions.begin(), fractions.end(), 0.0), 1.0 + 1e-14);
    });
  return volumes;
}

Function Ball(const Vector3& centre, double radius)
{
  return [=](const Vector3& x) { return Norm(x - centre) - radius; };
}

Function Torus(double ring, double tube)
{
  return [=](const Vector3& x)
  {
    const double out = std::hypot(x[0], x[1]) - ring;
    return std::hypot(out, x[2]) - tube;
  };
}

Function Plane(const Vector3& n, double d)
{
  return [=](const Vector3& x) { return Dot(n, x) - d; };
}

Function Least(const Function& f, const Function& g)
{
  return [=](const Vector3& x) { return std::min(f(x), g(x)); };
}

double BallVolume(double radius)
{
  return 4.0 / 3.0 * Pi * radius * radius * radius;
}

/// Returns the common volume of two balls of one radius.
double LensVolume(double radius, double distance)
{
  const double cap = radius - 0.5 * distance;
  return 2.0 * Pi * cap * cap * (3.0 * radius - cap) / 3.0;
}

double ErrorOf(double found, double expected)
{
  return std::abs(found - expected) / expected;
}

} // namespace

TEST(LevelSetCell, PlanesAreExactInEveryCell)
{
  for (const double widening : { 0.0, 0.3 })
  {
    const Nodes nodes = MakeNodes(6, widening);
    for (const Vector3& n : { Vector3{ { 0.3, -0.5, 0.8 } }, Vector3{ { 0.0, 0.0, -2.0 } },
           Vector3{ { 1.0, 0.01, 0.0 } } })
    {
      const double d = 0.1234;
      ForCells({ {}, { { 6, 6, 6 } } },
        [&](const Index3& cell)
        {
          Vector3 ofCell{};
          double rest = d;
          for (int a = 0; a < 3; ++a)
          {
            const double width = nodes[a][cell[a] + 1] - nodes[a][cell[a]];
            ofCell[a] = n[a] * width;
            rest -= n[a] * 0.5 * (nodes[a][cell[a] + 1] + nodes[a][cell[a]]);
          }
          const std::vector<double> found = FractionsOfFunctions(PlacesAround(nodes, cell),
            { ValuesAround(Plane(n, d), nodes, cell) }, LevelSetRule::Priority);
          EXPECT_NEAR(found[0], VolumeBelowPlane(ofCell, rest), 1e-12);
        });
    }
  }
}

TEST(LevelSetCell, VolumesOfCurvedBodies)
{
  const Nodes nodes = MakeNodes(32);
  const LevelSetRule rule = LevelSetRule::Priority;
  const double radius = 0.7, ring = 0.6, tube = 0.25;
  const Vector3 off{ { 0.011, -0.023, 0.017 } };
  const double ball = ErrorOf(VolumesOf({ Ball(off, radius) }, nodes, rule)[0], BallVolume(radius));
  const double torus =
    ErrorOf(VolumesOf({ Torus(ring, tube) }, nodes, rule)[0], 2.0 * Pi * Pi * ring * tube * tube);
  const Function left = Ball({ { -0.4, 0, 0 } }, 0.5), right = Ball({ { 0.4, 0.0, 0 } }, 0.5);
  const double both = 2.0 * BallVolume(0.5) - LensVolume(0.5, 0.8);
  const double joined = ErrorOf(VolumesOf({ Least(left, right) }, nodes, rule)[0], both);
  const std::vector<double> two = VolumesOf({ left, right }, nodes, rule);
  const double first = ErrorOf(two[0], BallVolume(0.5)), second = ErrorOf(two[0] + two[1], both);
  const std::vector<double> lowest = VolumesOf({ left, right }, nodes, LevelSetRule::Lowest);
  const double halves = ErrorOf(lowest[0], 0.5 * both);
  std::printf(
    "errors of volumes in 32^3 cells: ball %.1e, torus %.1e, two balls of one array %.1e,\n"
    "first of two %.1e, both %.1e, by the lowest %.1e\n",
    ball, torus, joined, first, second, halves);
  EXPECT_LT(ball, 1e-4);
  EXPECT_LT(torus, 1e-4);
  EXPECT_LT(joined, 1e-4);
  EXPECT_LT(first, 1e-4);
  EXPECT_LT(second, 1e-4);
  EXPECT_LT(halves, 1e-4);
  EXPECT_NEAR(lowest[0], lowest[1], 1e-5);
}

/// A body of a smooth function that is no distance, and cells that widen.
TEST(LevelSetCell, OtherFunctionsAndWidths)
{
  const Function f = [](const Vector3& x)
  { return (x[0] * x[0] + x[1] * x[1] / 0.64 + x[2] * x[2] / 0.36 - 0.5) * std::exp(x[0]); };
  const double expected = BallVolume(std::sqrt(0.5)) * 0.8 * 0.6;
  for (const double widening : { 0.0, 0.2 })
  {
    EXPECT_LT(
      ErrorOf(VolumesOf({ f }, MakeNodes(32, widening), LevelSetRule::Priority)[0], expected),
      1e-4);
  }
}

/// Layers on a ball, each level set with those below, with films of 0.3 cells.
TEST(LevelSetCell, StackedFilms)
{
  const Nodes nodes = MakeNodes(32);
  const double film = 0.3 / 16.0;
  const std::vector<double> radii{ 0.5, 0.5 + film, 0.5 + 2.0 * film, 0.7 };
  std::vector<Function> functions;
  for (double radius : radii)
  {
    functions.push_back(Ball({ { 0.0, 0.003, 0.0 } }, radius));
  }
  const std::vector<double> found = VolumesOf(functions, nodes, LevelSetRule::Priority);
  for (std::size_t m = 0; m < radii.size(); ++m)
  {
    const double below = m == 0 ? 0.0 : BallVolume(radii[m - 1]);
    EXPECT_LT(ErrorOf(found[m], BallVolume(radii[m]) - below), 1e-4) << m;
  }
}

/// A plate given by one function, with a kink in its middle: its sides stay planes.
TEST(LevelSetCell, KinksDoNotMovePlanes)
{
  const Nodes nodes = MakeNodes(16);
  const Function plate = [](const Vector3& x) { return std::abs(x[2] - 0.02) - 0.237; };
  EXPECT_NEAR(VolumesOf({ plate }, nodes, LevelSetRule::Priority)[0], 4.0 * 2.0 * 0.237, 1e-12);
  const Function box = [](const Vector3& x) {
    return std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) }) - 0.5;
  };
  EXPECT_NEAR(VolumesOf({ box }, nodes, LevelSetRule::Priority)[0], 1.0, 5e-3);
}

TEST(LevelSetCell, OneCellAcross)
{
  Nodes nodes = MakeNodes(8);
  nodes[2] = { 0.0, 0.1 };
  const std::vector<double> found =
    VolumesOf({ Plane({ { 1.0, 0.0, 0.0 } }, 0.3) }, nodes, LevelSetRule::Priority);
  EXPECT_NEAR(found[0], 1.3 * 2.0 * 0.1, 1e-12);
}
