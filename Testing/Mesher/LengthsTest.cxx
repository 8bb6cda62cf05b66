/// Lengths far from 1: a mesh does not depend on the unit of length, and grids whose lengths are
/// out of range are rejected.
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "MeshChecks.h"
#include "Phases/MeshOfCells.h"
#include "Report/Fragments/FragmentTable.h"
#include "Report/QualityDistribution.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Side = 8; // cells

enum class Field
{
  Ball,
  Noise
};

/// Returns the fraction of a ball in each cell, or noise; x fastest.
std::vector<double> MakeFractions(Field field)
{
  std::mt19937 random(7);
  std::vector<double> fractions;
  ForCells({ {}, { { Side, Side, Side } } },
    [&](const Index3& cell)
    {
      double squares = 0.0;
      for (Index i : cell)
      {
        squares += std::pow(static_cast<double>(i) - 3.4, 2);
      }
      const double ball = std::min(1.0, std::max(0.0, 3.3 - std::sqrt(squares)));
      const double noise = static_cast<double>(random() % 1024) / 1024.0;
      fractions.push_back(field == Field::Ball ? ball : noise);
    });
  return fractions;
}

/// Returns arrays of two materials that fill the grid, and of their state.
std::shared_ptr<const BlockArrays> MakeArrays(Field field)
{
  const std::vector<double> inside = MakeFractions(field);
  std::vector<double> outside, density, velocity, energy;
  std::vector<int> labels;
  for (std::size_t cell = 0; cell < inside.size(); ++cell)
  {
    const double at = static_cast<double>(cell);
    outside.push_back(1.0 - inside[cell]);
    labels.push_back(inside[cell] < 0.5 ? 2 : 1);
    density.push_back(2.0 + std::sin(0.1 * at));
    energy.push_back(3.0 + std::cos(0.2 * at));
    velocity.insert(velocity.end(), { std::sin(0.3 * at), std::cos(0.4 * at), 1.0 });
  }
  const auto tuples = static_cast<Index>(inside.size());
  auto arrays = std::make_shared<PlainArrays>(tuples);
  arrays->Store("inside", ValueType::Double, inside);
  arrays->Store("outside", ValueType::Double, outside);
  arrays->Store("labels", ValueType::Int, std::move(labels));
  arrays->Store("density", ValueType::Double, density);
  arrays->Store("energy", ValueType::Double, energy);
  const auto kept = std::make_shared<const std::vector<double>>(std::move(velocity));
  arrays->Add(
    "velocity", ValueType::Double, tuples, 3, std::shared_ptr<const void>(kept, kept->data()));
  return arrays;
}

/// Returns an input on a grid with these widths and this lower corner.
MesherInput MakeGrid(Field field, const Vector3& widths, const Vector3& origin)
{
  const IndexBox cells{ {}, { { Side, Side, Side } } };
  InputBlock block = MakeBlock(cells, origin, 1.0, MakeArrays(field));
  for (int a = 0; a < 3; ++a)
  {
    for (std::size_t i = 0; i < block.Coordinates[a].size(); ++i)
    {
      block.Coordinates[a][i] = origin[a] + static_cast<double>(i) * widths[a];
    }
  }
  CheckCoordinates(block);
  Ranks alone;
  MesherInput input = MakeInput({ std::move(block) }, alone);
  input.Arrays.Fractions = { "inside", "outside" };
  return input;
}

MesherInput MakeCubes(Field field, double width)
{
  return MakeGrid(field, { { width, width, width } }, {});
}

struct Method
{
  const char* Name;
  ElementKind Elements;
  TetMethod Tets;
};

const Method Methods[] = { { "hexes", ElementKind::Hexes, TetMethod::Lattice },
  { "Lattice", ElementKind::Tets, TetMethod::Lattice },
  { "Cells", ElementKind::Tets, TetMethod::Cells },
  { "TetGen", ElementKind::Tets, TetMethod::TetGen } };

bool IsBuilt(const Method& method)
{
  return method.Elements == ElementKind::Hexes || method.Tets != TetMethod::TetGen || HasTetGen();
}

MesherOptions OptionsOf(const Method& method)
{
  MesherOptions options;
  options.Elements = method.Elements;
  options.Method = method.Tets;
  options.ComputeQuality = true;
  return options;
}

constexpr double VolumeError = 1e-9; // relative to the volume of the domain

/// Returns the first problem of a mesh that fills the domain, or "".
/// @param width  cube root of the volume of a cell
/// @param error  largest error of volumes, relative to the domain
std::string FindProblem(const MesherResult& result, double width, double error)
{
  const Mesh& mesh = result.TheMesh;
  const double cell = width * width * width;
  if (mesh.ElementIds.empty())
  {
    return "no elements";
  }
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    if (!(SmallestCoefficient(mesh, e) / cell > 0.0))
    {
      return "element " + std::to_string(mesh.ElementIds[e]) + " is not positive";
    }
  }
  const auto cells = static_cast<double>(Side * Side * Side);
  double sum = 0.0;
  for (int material : { 1, 2 })
  {
    const double volume = MeasureVolume(mesh, material) / cell;
    sum += volume;
    if (!(std::fabs(volume - result.Report.MeshVolume[material] / cell) < error * cells))
    {
      return "reported volume is wrong";
    }
  }
  const std::string topology = FindTopologyProblem(mesh);
  return !topology.empty()                    ? topology
    : !(std::fabs(sum / cells - 1.0) < error) ? "volumes do not fill the domain"
    : !(result.Report.MinimumScaledJacobian > 0.0 && result.Report.MeanScaledJacobian <= 1.0)
    ? "scaled Jacobian"
    : "";
}

/// Makes the grid and the mesh. Returns the message of the error, or "" if the mesh is valid.
template <class MakeGridOf>
std::string TryCase(
  const Method& method, double width, const MakeGridOf& makeGrid, double error = VolumeError)
{
  try
  {
    Runtime serial;
    const MesherResult result = RunMesher(makeGrid(), OptionsOf(method), serial);
    const std::string problem = FindProblem(result, width, error);
    return problem.empty() ? "" : "invalid: " + problem;
  }
  catch (const InputError& rejected)
  {
    return rejected.what();
  }
}

TEST(Lengths, BoxesFrom1e300To1e300)
{
  for (const Method& method : Methods)
  {
    if (!IsBuilt(method))
    {
      continue;
    }
    int meshes = 0, messages = 0, least = 400, most = -400;
    for (int exponent = -300; exponent <= 300; exponent += 10)
    {
      for (Field field : { Field::Ball, Field::Noise })
      {
        const double width = std::pow(10.0, exponent) / static_cast<double>(Side);
        const std::string message = TryCase(method, width, [&] { return MakeCubes(field, width); });
        const bool isMesh = message.empty();
        EXPECT_EQ(isMesh, width >= 1e-50 && width <= 1e50) << exponent << ": " << message;
        EXPECT_EQ(message.find("The grid has cells of width ") == 0, !isMesh) << message;
        ++(isMesh ? meshes : messages);
        least = isMesh ? std::min(least, exponent) : least;
        most = isMesh ? std::max(most, exponent) : most;
      }
    }
    std::printf("%-8s %3d valid meshes, boxes of 1e%d to 1e%d; %3d messages\n", method.Name, meshes,
      least, most, messages);
  }
}

using Numbers = std::map<std::string, std::vector<double>>;

template <class Values>
void AddNumbers(const std::string& name, const Values& values, Numbers& numbers)
{
  std::vector<double>& all = numbers[name];
  for (const auto& value : values)
  {
    all.push_back(static_cast<double>(value));
  }
}

void AddFields(const std::string& name, const FieldArrays& fields, Numbers& numbers)
{
  for (const FieldArray& field : fields)
  {
    std::visit(
      [&](const auto& values)
      {
        if constexpr (!std::is_same_v<std::decay_t<decltype(values)>, std::vector<std::string>>)
        {
          AddNumbers(name + field.Name, values, numbers);
        }
      },
      field.Values);
  }
}

void AddTuples(
  const std::string& name, const std::vector<std::array<double, 3>>& rows, Numbers& numbers)
{
  for (const std::array<double, 3>& row : rows)
  {
    AddNumbers(name, row, numbers);
  }
}

void AddState(const TransferredArray& array, Numbers& numbers)
{
  const auto* values = reinterpret_cast<const double*>(array.Values.data());
  const std::size_t count = array.Values.size() / sizeof(double);
  AddNumbers("state " + array.Name, std::vector<double>(values, values + count), numbers);
}

/// Returns all numbers of a result, by name.
Numbers ListNumbers(const MesherResult& result)
{
  const Mesh& mesh = result.TheMesh;
  Numbers numbers;
  AddNumbers("points", mesh.Points, numbers);
  AddNumbers("elements", mesh.Elements, numbers);
  AddNumbers("mid points", mesh.MidPoints, numbers);
  AddNumbers("scaled Jacobians", mesh.ScaledJacobian, numbers);
  AddNumbers("fragments", mesh.Fragment, numbers);
  AddNumbers("dimension", mesh.GeometryDimension, numbers);
  AddNumbers("areas", mesh.Tables.SurfaceAreas, numbers);
  AddTuples("centroids", mesh.Tables.SurfaceCentroids, numbers);
  AddTuples("normals", mesh.Tables.SurfaceNormals, numbers);
  AddFields("", result.Fields, numbers);
  AddFields("material ", result.MaterialFields, numbers);
  for (const TransferredArray& array : result.State.Arrays)
  {
    AddState(array, numbers);
  }
  if (result.State.NodalVelocity)
  {
    AddState(*result.State.NodalVelocity, numbers);
  }
  Ranks alone;
  const MeshData view = ViewMesh(mesh, result.State, result.Fields);
  const bool hasDensity = !result.State.Arrays.empty();
  AddFields("fragment ",
    MakeFragmentTable(
      view, hasDensity ? std::vector<std::string>{ "density" } : std::vector<std::string>(), alone),
    numbers);
  for (const RatedElement& element : FindQualityDistribution(view, 5, alone).Worst)
  {
    AddNumbers("worst", element.Centroid, numbers);
  }
  return numbers;
}

/// Returns the power of the length with which numbers grow, if they are bitwise equal except for
/// the factor; else a number below -9.
int FindPower(const std::vector<double>& one, const std::vector<double>& other, int exponent)
{
  for (int power : { 0, 1, 2, 3, -1, 4 })
  {
    const auto same = [&](double a, double b) { return std::ldexp(a, power * exponent) == b; };
    if (std::equal(one.begin(), one.end(), other.begin(), other.end(), same))
    {
      return power;
    }
  }
  return -10;
}

struct Variant
{
  std::string Name;
  /// Sets options for a grid whose lengths have the factor `unit`.
  std::function<void(double unit, MesherOptions&)> Set;
  bool HasState = false;
  bool OnlyHexes = false;
  bool AreLabels = false;
};

const Variant Variants[] = { { "state", [](double, MesherOptions& o) { o.NodalVelocity = true; },
                               true },
  { "quadratic", [](double, MesherOptions& o) { o.ElementOrder = InterpolationOrder::Quadratic; } },
  { "refined",
    [](double unit, MesherOptions& o)
    {
      o.Refinement = RefinementMode::Automatic;
      o.MaximumLevel = 1;
      o.CurvaturePerCell = 0.3;
      const double low = 0.5 * unit, high = 2.5 * unit;
      o.RefinementBoxes = { { { { low, low, low } }, { { high, high, high } }, 1.0 } };
    },
    true },
  { "periodic",
    [](double, MesherOptions& o)
    {
      o.Periodic = 7;
      o.PeriodicSides = Sides::Joined;
    },
    true },
  { "layers",
    [](double unit, MesherOptions& o)
    {
      o.Layers = 3;
      o.FirstLayer = 0.1 * unit;
      o.FirstLayerUnit = ThicknessUnit::Length;
      o.SharpEdges = SharpEdgeMode::On;
    },
    false, true } };

MesherResult MakeVariant(const Method& method, const Variant& variant, Field field, double unit)
{
  MesherOptions options = OptionsOf(method);
  variant.Set(unit, options);
  MesherInput input = MakeGrid(
    field, { { unit, 1.5 * unit, 0.75 * unit } }, { { 0.3 * unit, -20.0 * unit, 7.0 * unit } });
  if (variant.HasState)
  {
    input.Arrays.State = { true, { "density", "velocity", "energy" }, { "density" }, {}, "velocity",
      "energy" };
  }
  if (variant.AreLabels)
  {
    input.Arrays.Fractions.clear();
    input.Arrays.Labels = "labels";
  }
  Runtime serial;
  return RunMesher(input, options, serial);
}

/// Powers of 2 that change the unit, 7e-49 and 1e48. Sums of state (WideSum) are rounded
/// differently by others than multiples of 32.
constexpr int Exponents[] = { -160, 160 };

TEST(Lengths, MeshesDoNotDependOnTheUnit)
{
  std::map<std::string, std::map<int, int>> powers;
  for (const Method& method : Methods)
  {
    for (const Variant& variant : Variants)
    {
      for (Field field : { Field::Ball, Field::Noise })
      {
        const bool isTetGen = method.Tets == TetMethod::TetGen;
        const bool isHexes = method.Elements == ElementKind::Hexes;
        if (!IsBuilt(method) || (variant.OnlyHexes && !isHexes) ||
          (isTetGen && (variant.Name == "quadratic" || variant.AreLabels)) ||
          (field == Field::Noise && !(isHexes && variant.HasState)))
        {
          continue;
        }
        const Numbers one = ListNumbers(MakeVariant(method, variant, field, 1.0));
        for (int exponent : Exponents)
        {
          const Numbers other =
            ListNumbers(MakeVariant(method, variant, field, std::ldexp(1.0, exponent)));
          for (const auto& [name, values] : one)
          {
            const int power = FindPower(values, other.at(name), exponent);
            EXPECT_GE(power, -1) << method.Name << " " << variant.Name << " "
                                 << (field == Field::Noise ? "noise " : "ball ") << exponent << ": "
                                 << name;
            ++powers[name][power];
          }
        }
      }
    }
  }
  for (const auto& [name, counts] : powers)
  {
    std::printf("%-24s", name.c_str());
    for (const auto& [power, count] : counts)
    {
      std::printf("  L^%d %d", power, count);
    }
    std::printf("\n");
  }
}

/// Returns an input of two levels (LabelInput.h) in another unit of length.
MesherInput MakeLevels(double unit)
{
  Ranks alone;
  return MakeLevelInput(
    { { { 6, 6, 6 } }, 2.0 * unit, 0.75 * unit }, { { { { 1, 1, 1 } }, { { 4, 4, 3 } } } }, alone);
}

TEST(Lengths, MeshesOfLevelsDoNotDependOnTheUnit)
{
  Runtime serial;
  for (const Method& method : { Methods[0], Methods[1] })
  {
    const MesherOptions options = OptionsOf(method);
    const Numbers one = ListNumbers(RunMesher(MakeLevels(1.0), options, serial));
    ASSERT_GT(one.at("points").size(), 1000u);
    for (int exponent : Exponents)
    {
      const Numbers other =
        ListNumbers(RunMesher(MakeLevels(std::ldexp(1.0, exponent)), options, serial));
      for (const auto& [name, values] : one)
      {
        EXPECT_GE(FindPower(values, other.at(name), exponent), -1) << method.Name << " " << name;
      }
    }
    for (double unit : { 1e-300, 1e-60, 1e60, 1e300, 1e307 })
    {
      try
      {
        RunMesher(MakeLevels(unit), options, serial);
        FAIL() << "no message: " << unit;
      }
      catch (const InputError& error)
      {
        EXPECT_EQ(std::string(error.what()).find("The grid has cells of width "), 0u)
          << error.what();
      }
    }
  }
}

/// Largest widths and coordinates that are accepted, and messages beyond.
struct LimitCase
{
  const char* Name;
  Vector3 Widths, Origin;
  const char* Message; ///< its begin; empty: there is a mesh
  double Error = VolumeError;
};

const LimitCase LimitCases[] = { { "ratio 1e10", { { 1e-10, 1.0, 1.0 } }, {}, "" },
  { "ratio 2e10", { { 1.0, 1.0, 5e-11 } }, {},
    "The grid has cells of width 5e-11 along z and of width 1 along x. The largest width must be "
    "at most 1e+10 times the smallest." },
  { "wide", { { 1e50, 1e50, 1e50 } }, {}, "" }, { "narrow", { { 1e-50, 1e-50, 1e-50 } }, {}, "" },
  { "wider", { { 1e50, 2e50, 1e50 } }, {},
    "The grid has cells of width 2e+50 along y. Widths, also of refined cells, must be from 1e-50 "
    "to 1e+50. Scale the coordinates" },
  { "far", { { 1.0, 1.0, 1.0 } }, { { 0.0, -1e10, 0.0 } }, "", 1e-6 },
  { "farther", { { 1.0, 1.0, 1.0 } }, { { 0.0, -2e10, 0.0 } },
    "The grid has cells of width 1 along y, where its coordinates reach 2e+10. Coordinates "
    "must be at most 1e+10 times the smallest width" },
  { "not distinct", { { 1.0, 1.0, 1.0 } }, { { 0.0, 0.0, 1e20 } },
    "The input: the z coordinates do not increase or are not finite at node 1 (1e+20). Nodes 0 and "
    "1 are equal. If the origin is far away, move it to the grid" } };

TEST(Lengths, LimitsAreReported)
{
  for (const LimitCase& c : LimitCases)
  {
    for (const Method& method : Methods)
    {
      const double width = std::cbrt(c.Widths[0] * c.Widths[1] * c.Widths[2]);
      const std::string message = IsBuilt(method)
        ? TryCase(
            method, width, [&] { return MakeGrid(Field::Ball, c.Widths, c.Origin); }, c.Error)
        : c.Message;
      EXPECT_EQ(
        message.substr(0, *c.Message ? std::string(c.Message).size() : message.size()), c.Message)
        << c.Name << " " << method.Name;
    }
  }
}

TEST(Lengths, WarnsOfRatiosAbove1000)
{
  Runtime serial;
  const std::string expected = "The widths of a cell differ by a factor of 2000. ";
  for (double ratio : { 500.0, 2000.0 })
  {
    MesherInput input = MakeGrid(Field::Ball, { { 1.0, ratio, 1.0 } }, {});
    std::string warnings;
    input.Warn = [&warnings](const std::string& text) { warnings += text + "\n"; };
    RunMesher(input, OptionsOf(Methods[0]), serial);
    EXPECT_EQ(warnings.find(expected) != std::string::npos, ratio > 1000.0) << warnings;
    EXPECT_EQ(warnings.find("The widths") != std::string::npos, ratio > 1000.0) << warnings;
  }
}

// Width 2e-50 is accepted, and halved twice it is not.
TEST(Lengths, RefinedWidthsAreReported)
{
  Runtime serial;
  for (const Method& method : { Methods[0], Methods[1] })
  {
    for (int level : { 1, 2 })
    {
      MesherOptions options = OptionsOf(method);
      options.Refinement = RefinementMode::Uniform;
      options.MaximumLevel = level;
      const MesherInput input = MakeCubes(Field::Ball, 2e-50);
      if (level == 1)
      {
        EXPECT_GT(RunMesher(input, options, serial).TheMesh.ElementIds.size(), 4000u);
        continue;
      }
      try
      {
        RunMesher(input, options, serial);
        FAIL() << "no message";
      }
      catch (const InputError& error)
      {
        EXPECT_EQ(std::string(error.what()).find("The grid has cells of width 5e-51 along x"), 0u)
          << error.what();
      }
    }
  }
}

} // namespace
