/// Order of convergence of transferred state: errors of smooth fields at the centroids of elements.
#include "MeshCases.h"
#include "State/SmoothState.h"

#include "Base/Vector3.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const Vector3 Middle{ { 0.51, 0.52, 0.49 } };
constexpr double Radius = 0.36;

struct OrderCase
{
  Elements Kind;
  bool IsInBlock; ///< a block 8 times as dense surrounds the ball
};

std::string NameOf(const OrderCase& c)
{
  const char* names[] = { "Hexes", "Lattice", "Cells" };
  return std::string(names[static_cast<int>(c.Kind)]) + (c.IsInBlock ? "_in_block" : "");
}

void PrintTo(const OrderCase& c, std::ostream* out)
{
  *out << NameOf(c);
}

int MaterialAt(const Vector3& x, bool isInBlock)
{
  return Norm(x - Middle) < Radius ? 1 : (isInBlock ? 2 : 0);
}

FractionField MakeFractions(const CartesianGrid& grid, bool isInBlock)
{
  std::vector<Shape> shapes{ MakeSphere(1, Middle, Radius) };
  if (isInBlock)
  {
    shapes.push_back(MakeBox(2, { { 0.5, 0.5, 0.5 } }, { { 2.0, 2.0, 2.0 } }));
  }
  return FractionsOfShapes(grid, shapes);
}

/// Returns whether a point is far from the interface and from the sides of the domain, where
/// neighbours for slopes are missing.
bool IsInside(const Vector3& x, double farFromInterface)
{
  const double rim = 2.0 / 32.0;
  const auto within = [rim](double c) { return c > rim && c < 1.0 - rim; };
  return std::fabs(Norm(x - Middle) - Radius) > farFromInterface &&
    std::all_of(x.begin(), x.end(), within);
}

/// Errors weighted by volume: of all elements, and of elements inside.
struct Errors
{
  double All = 0.0, Inside = 0.0, LargestInside = 0.0;
};
using ComponentErrors = std::array<Errors, SmoothComponents>;

ComponentErrors CompareWithField(const Mesh& mesh, const MeasuredShapes& shapes,
  const TransferredState& state, const StateFunction& function, double farFromInterface)
{
  ComponentErrors errors;
  double volume = 0.0, inside = 0.0;
  for (std::size_t e = 0; e < shapes.Volumes.size(); ++e)
  {
    double truth[SmoothComponents];
    function(shapes.Centroids[e], mesh.Material[e], truth);
    const bool isInside = IsInside(shapes.Centroids[e], farFromInterface);
    volume += shapes.Volumes[e];
    inside += isInside ? shapes.Volumes[e] : 0.0;
    int c = 0;
    for (const Buffer<double>& values : state.Values)
    {
      const std::size_t components = values.size() / shapes.Volumes.size();
      for (std::size_t i = 0; i < components; ++i, ++c)
      {
        const double error = std::fabs(values[components * e + i] - truth[c]);
        errors[c].All += shapes.Volumes[e] * error;
        errors[c].Inside += isInside ? shapes.Volumes[e] * error : 0.0;
        errors[c].LargestInside = std::max(errors[c].LargestInside, isInside ? error : 0.0);
      }
    }
  }
  EXPECT_GT(inside, 0.0);
  for (Errors& error : errors)
  {
    error.All /= volume;
    error.Inside /= inside;
  }
  return errors;
}

ComponentErrors MeasureErrors(
  const OrderCase& c, int n, int order, const StateFunction& function, double farFromInterface)
{
  const CartesianGrid grid = MakeUnitCube(n);
  const FractionField fractions = MakeFractions(grid, c.IsInBlock);
  const CellMeans means(
    grid, fractions, function, [&](const Vector3& x) { return MaterialAt(x, c.IsInBlock); });
  const Mesh mesh = MakeMesh(grid, fractions, c.Kind);
  Runtime runtime;
  TransferRequest request{ grid, fractions, means, ListSmoothQuantities() };
  request.Density = 0;
  request.Order = order;
  return CompareWithField(mesh, MeasureElements(mesh, grid), TransferState(mesh, request, runtime),
    function, farFromInterface);
}

class TransferOrder : public ::testing::TestWithParam<OrderCase>
{
};

} // namespace

TEST_P(TransferOrder, OfSmoothFields)
{
  const char* names[SmoothComponents] = { "density", "velocity x", "velocity y", "velocity z",
    "energy", "temperature", "strain", "pressure" };
  const std::array<int, 3> cells{ { 16, 32, 64 } };
  for (int order : { 1, 2 })
  {
    std::array<ComponentErrors, 3> errors;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      errors[i] =
        MeasureErrors(this->GetParam(), cells[i], order, EvaluateSmoothState, 0.5 * Radius);
    }
    std::printf("| %s, order %d | all: 16^3, 32^3, 64^3 | ratios | inside: | ratios |\n"
                "|---|---|---|---|---|\n",
      NameOf(this->GetParam()).c_str(), order);
    for (int c = 0; c < SmoothComponents; ++c)
    {
      const Errors &coarse = errors[0][c], &middle = errors[1][c], &fine = errors[2][c];
      std::printf("| %s | %.2g, %.2g, %.2g | %.2f, %.2f | %.2g, %.2g, %.2g | %.2f, %.2f |\n",
        names[c], coarse.All, middle.All, fine.All, coarse.All / middle.All, middle.All / fine.All,
        coarse.Inside, middle.Inside, fine.Inside, coarse.Inside / middle.Inside,
        middle.Inside / fine.Inside);
      if (order == 2)
      {
        EXPECT_GE(coarse.All, 2.5 * middle.All) << names[c];
        EXPECT_GE(middle.All, 2.5 * fine.All) << names[c];
        EXPECT_GE(middle.Inside, 3.5 * fine.Inside) << names[c];
      }
    }
  }
}

TEST_P(TransferOrder, LinearFieldsAreMet)
{
  const auto linear = [](const Vector3& x, int material, double* values)
  {
    // Quantities per mass are linear by volume if the density is constant.
    values[0] = material == 2 ? 8.0 : 1.0;
    for (int c = 1; c < SmoothComponents; ++c)
    {
      values[c] = 0.3 * c + (c - 3.0) * x[0] + 2.0 * x[1] - 0.7 * c * x[2] + 0.5 * material;
    }
  };
  const ComponentErrors errors = MeasureErrors(this->GetParam(), 32, 2, linear, 7.0 / 32.0);
  double largest = 0.0;
  for (const Errors& error : errors)
  {
    largest = std::max(largest, error.LargestInside);
  }
  std::printf(
    "%s: error of linear fields inside %.2g\n", NameOf(this->GetParam()).c_str(), largest);
  EXPECT_LT(largest, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Meshes, TransferOrder,
  ::testing::Values(OrderCase{ Elements::Hexes, false }, OrderCase{ Elements::Lattice, false },
    OrderCase{ Elements::Cells, false }, OrderCase{ Elements::Hexes, true },
    OrderCase{ Elements::Lattice, true }),
  [](const ::testing::TestParamInfo<OrderCase>& info) { return NameOf(info.param); });
