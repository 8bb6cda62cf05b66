/// Meshes made from blocks of cells without VTK data sets.
#include "Mesher.h"
#include "Input/NodeCoordinates.h"
#include "Levels/WideCells.h"
#include "Report/MeshData.h"
#include "Report/MeshFields.h"
#include "Shapes/ShapesFractions.h"

#include <gtest/gtest.h>

#include <map>

using namespace vfm;

namespace
{

constexpr Index Side = 12; // cells

/// Doubles that are read as plain memory, or value by value.
class Values : public BlockArray
{
public:
  Values(std::vector<double> values, bool isPlain, int components = 1) : Held(std::move(values))
  {
    this->Components = components;
    this->Tuples = static_cast<Index>(this->Held.size()) / components;
    this->Memory = isPlain ? this->Held.data() : nullptr;
  }
  double Get(Index tuple, int component) const override
  {
    return this->Held[tuple * this->Components + component];
  }
  void Copy(Index first, Index count, void* to) const override
  {
    std::copy_n(this->Held.data() + first * this->Components, count * this->Components,
      static_cast<double*>(to));
  }

private:
  const std::vector<double> Held;
};

class NamedValues : public BlockArrays
{
public:
  Index NumberOfTuples() const override { return Side * Side * Side; }
  std::shared_ptr<const BlockArray> Find(const std::string& name) const override
  {
    const auto found = this->Arrays.find(name);
    return found == this->Arrays.end() ? nullptr : found->second;
  }
  bool HoldsIds(const std::string& name) const override { return name == "ids"; }
  std::vector<std::string> Names() const override
  {
    std::vector<std::string> names;
    for (const auto& array : this->Arrays)
    {
      names.push_back(array.first);
    }
    return names;
  }

  std::map<std::string, std::shared_ptr<const BlockArray>> Arrays;
};

/// Returns unit cells with fractions of a ball and a state x, the number of each cell.
MesherInput MakeInput(bool isPlain)
{
  InputBlock block;
  block.Name = "The input";
  for (auto& x : block.Coordinates)
  {
    x = EvenNodes(0.0, 1.0, 0, static_cast<int>(Side));
  }
  KeepAllCells(block);
  const CartesianGrid grid(block.Coordinates);
  std::vector<double> fractions(Side * Side * Side, 0.0), numbers;
  const std::vector<Shape> ball{ MakeSphere(1, { { 6.0, 6.0, 6.0 } }, 4.0) };
  ForCells(grid.Global(),
    [&](const Index3& cell)
    {
      const Index at = IndexInBox(grid.Global(), cell);
      const Vector3 lower{ { double(cell[0]), double(cell[1]), double(cell[2]) } };
      ShapeFractions(
        ball, lower, lower + Vector3{ { 1.0, 1.0, 1.0 } }, DefaultShapeTolerance, &fractions[at]);
      numbers.push_back(static_cast<double>(at));
    });
  auto arrays = std::make_shared<NamedValues>();
  arrays->Arrays = { { "ball", std::make_shared<Values>(std::move(fractions), isPlain) },
    { "x", std::make_shared<Values>(std::move(numbers), isPlain) } };
  block.Arrays = arrays;
  Ranks alone;
  CollectedBlocks collected;
  collected.Blocks.push_back(std::move(block));
  MesherInput input;
  input.Levels = FindInputLevels(std::move(collected), alone);
  input.Arrays.Fractions = { "ball" };
  input.Arrays.State.Arrays = { "x" };
  return input;
}

template <class T>
std::vector<T> ListOf(const Buffer<T>& buffer)
{
  return { buffer.begin(), buffer.end() };
}

TEST(Mesher, ReadsMemoryAndValuesTheSameWay)
{
  Runtime serial;
  for (const ElementKind kind : { ElementKind::Hexes, ElementKind::Tets })
  {
    MesherOptions options;
    options.Elements = kind;
    const MesherResult plain = RunMesher(MakeInput(true), options, serial);
    const MesherResult other = RunMesher(MakeInput(false), options, serial);
    ASSERT_GT(plain.TheMesh.ElementIds.size(), 200u);
    EXPECT_EQ(ListOf(plain.TheMesh.Points), ListOf(other.TheMesh.Points));
    EXPECT_EQ(ListOf(plain.TheMesh.Elements), ListOf(other.TheMesh.Elements));
    EXPECT_EQ(ListOf(plain.State.Arrays.at(0).Values), ListOf(other.State.Arrays.at(0).Values));
  }
}

TEST(Mesher, StateIsThatOfACellOfTheElement)
{
  Runtime serial;
  const MesherInput input = MakeInput(true);
  const MesherResult result = RunMesher(input, MesherOptions(), serial);
  const TransferredArray& state = result.State.Arrays.at(0);
  EXPECT_EQ(state.Name, "x");
  ASSERT_EQ(state.Values.size(), sizeof(double) * result.TheMesh.ElementIds.size());
  const double* numbers = reinterpret_cast<const double*>(state.Values.data());
  const auto values = input.Levels.Levels[0].Blocks[0].Arrays->Find("ball");
  for (std::size_t e = 0; e < result.TheMesh.ElementIds.size(); ++e)
  {
    EXPECT_GE(values->Get(static_cast<Index>(numbers[e]), 0), 0.5);
  }
}

TEST(Mesher, MeshesOfRotatedImagesStayInTheirAxesOnRequest)
{
  Runtime serial;
  MesherOptions options;
  const MesherResult own = RunMesher(MakeInput(true), options, serial);
  MesherInput mirrored = MakeInput(true);
  mirrored.Levels.Reading.Frame =
    MakeImageFrame({ 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0 }, { { 0.0, 0.0, 5.0 } }, "A");
  const MesherResult turned = RunMesher(mirrored, options, serial);
  EXPECT_NE(ListOf(turned.TheMesh.Points), ListOf(own.TheMesh.Points));
  EXPECT_TRUE(FindField(turned.Fields, "DomainFrame"));
  options.ImageAxes = true;
  const MesherResult left = RunMesher(mirrored, options, serial);
  EXPECT_EQ(ListOf(left.TheMesh.Points), ListOf(own.TheMesh.Points));
  EXPECT_EQ(ListOf(left.TheMesh.Elements), ListOf(own.TheMesh.Elements));
  EXPECT_FALSE(FindField(left.Fields, "DomainFrame"));
}

using Axes = std::array<double, 9>;
constexpr Axes Oblique{ { 0.48, -0.6, 0.64, 0.8, 0.0, -0.6, 0.36, 0.8, 0.48 } };
constexpr Axes Mirrored{ { 0.48, -0.6, -0.64, 0.8, 0.0, 0.6, 0.36, 0.8, -0.48 } };

/// Returns A v, or A T A^T for tensors, written as sums over all components.
std::vector<double> Rotated(const Axes& a, const std::vector<double>& v)
{
  std::vector<double> result(v.size(), 0.0);
  if (v.size() == 3)
  {
    for (int i = 0; i < 9; ++i)
    {
      result[i / 3] += a[i] * v[i % 3];
    }
    return result;
  }
  const std::vector<int> places = v.size() == 6 ? std::vector<int>{ 0, 3, 5, 3, 1, 4, 5, 4, 2 }
                                                : std::vector<int>{ 0, 1, 2, 3, 4, 5, 6, 7, 8 };
  for (int n = 0; n < 81; ++n)
  {
    const int i = n % 3, j = n / 3 % 3, k = n / 9 % 3, l = n / 27;
    const bool isSecond = v.size() == 6 && i > j; // t_ji has the place of t_ij
    result[places[3 * i + j]] +=
      isSecond ? 0.0 : a[3 * i + k] * a[3 * j + l] * v[places[3 * k + l]];
  }
  return result;
}

std::shared_ptr<const BlockArray> MakeTuples(int components, const Axes* axes)
{
  std::vector<double> all;
  for (Index cell = 0; cell < Side * Side * Side; ++cell)
  {
    std::vector<double> tuple;
    for (int c = 0; c < components; ++c)
    {
      tuple.push_back(std::sin(0.3 * static_cast<double>(cell % Side) + c) +
        0.01 * c * static_cast<double>(cell / Side));
    }
    tuple = axes ? Rotated(*axes, tuple) : tuple;
    all.insert(all.end(), tuple.begin(), tuple.end());
  }
  return std::make_shared<Values>(std::move(all), true, components);
}

/// Input with vectors v and tensors of six and nine components, s and t, in an image with these
/// axes; areRotated: the arrays are in world coordinates.
MesherInput MakeTensors(const Axes& axes, bool areRotated)
{
  MesherInput input = MakeInput(true);
  InputBlock& block = input.Levels.Levels[0].Blocks[0];
  auto arrays = std::make_shared<NamedValues>();
  arrays->Arrays = { { "ball", block.Arrays->Find("ball") } };
  for (const auto& [name, components] : { std::pair("v", 3), { "s", 6 }, { "t", 9 } })
  {
    arrays->Arrays[name] = MakeTuples(components, areRotated ? &axes : nullptr);
  }
  block.Arrays = arrays;
  input.Levels.Reading.Frame = MakeImageFrame(axes, { { 1.0, 2.0, 3.0 } }, "A");
  input.Arrays.State.Arrays = { "v", "s", "t" };
  return input;
}

const double* ValuesOf(const TransferredArray& array)
{
  return reinterpret_cast<const double*>(array.Values.data());
}

/// Expects the same tuples of doubles to a tolerance.
void ExpectSameState(const MesherResult& one, const MesherResult& other)
{
  ASSERT_EQ(one.State.Arrays.size(), 3u);
  for (std::size_t a = 0; a < one.State.Arrays.size(); ++a)
  {
    const TransferredArray &mine = one.State.Arrays[a], &its = other.State.Arrays.at(a);
    ASSERT_EQ(mine.Values.size(), its.Values.size());
    ASSERT_EQ(mine.Values.size(), mine.Components * sizeof(double) * one.TheMesh.ElementIds.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < mine.Values.size() / sizeof(double); ++i)
    {
      largest = std::max(largest, std::fabs(ValuesOf(mine)[i] - ValuesOf(its)[i]));
    }
    EXPECT_LT(largest, 1e-13) << mine.Name;
  }
}

// Copied and conserved, the result is that of the same input in world coordinates.
TEST(Mesher, VectorsAndTensorsAreRotatedWithTheImageOnRequest)
{
  Runtime serial;
  for (const Axes& axes : { Oblique, Mirrored })
  {
    for (bool isConserved : { false, true })
    {
      MesherInput own = MakeTensors(axes, false), world = MakeTensors(axes, true);
      for (MesherInput* input : { &own, &world })
      {
        input->Arrays.State.IsConserved = isConserved;
        input->Arrays.State.Velocity = isConserved ? "v" : "";
      }
      own.Arrays.State.Rotated = { "v", " s", "t" };
      MesherOptions options;
      options.NodalVelocity = true;
      const MesherResult rotated = RunMesher(own, options, serial);
      const MesherResult expected = RunMesher(world, options, serial);
      ExpectSameState(rotated, expected);
      if (isConserved)
      {
        const Vector3 &momentum = rotated.State.Balance.Mesh[1].Momentum,
                      &given = expected.State.Balance.Input[1].Momentum;
        EXPECT_LT(Norm(momentum - given), 1e-12 * Norm(given));
        EXPECT_EQ(rotated.State.NodalVelocity->Values.size(),
          sizeof(double) * rotated.TheMesh.Points.size());
      }
      options.ImageAxes = true; // nothing is rotated
      MesherInput plain = own;
      plain.Arrays.State.Rotated.clear();
      ExpectSameState(RunMesher(own, options, serial), RunMesher(plain, options, serial));
    }
  }
}

TEST(Mesher, ReportsTheMesh)
{
  Runtime serial;
  const MesherResult result = RunMesher(MakeInput(true), MesherOptions(), serial);
  const auto find = [](const FieldArrays& fields, const std::string& name)
  {
    return std::find_if(fields.begin(), fields.end(),
      [&name](const FieldArray& field) { return field.Name == name; });
  };
  EXPECT_EQ(std::get<std::vector<std::string>>(find(result.Fields, "MaterialNames")->Values),
    (std::vector<std::string>{ "ball" }));
  EXPECT_EQ(std::get<std::vector<double>>(find(result.Fields, "DomainBounds")->Values),
    (std::vector<double>{ 0, 12, 0, 12, 0, 12 }));
  EXPECT_EQ(std::get<std::vector<Index>>(find(result.MaterialFields, "Elements")->Values),
    (std::vector<Index>{ static_cast<Index>(result.TheMesh.ElementIds.size()) }));
}

/// Of 301 cells that contain the material, one is filled most by it.
TEST(Mesher, WarnsOfInexactVolumes)
{
  MesherInput input = MakeInput(true);
  std::vector<double> fractions(Side * Side * Side, 0.0);
  fractions[0] = 0.6;
  std::fill(fractions.begin() + 200, fractions.begin() + 500, 0.4);
  auto arrays = std::make_shared<NamedValues>();
  arrays->Arrays = { { "dust", std::make_shared<Values>(std::move(fractions), true) } };
  input.Levels.Levels[0].Blocks[0].Arrays = arrays;
  input.Arrays.Fractions = { "dust" };
  input.Arrays.State.Arrays.clear();
  std::vector<std::string> warnings;
  input.Warn = [&warnings](const std::string& text) { warnings.push_back(text); };
  Runtime serial;
  MesherOptions options;
  RunMesher(input, options, serial);
  EXPECT_TRUE(warnings.empty()); // by default, the dust is a thin part
  options.ThinParts = false;
  RunMesher(input, options, serial);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1 material misses its volume by more than 1 %: 'dust' (id 1) by -"),
    std::string::npos)
    << warnings[0];
  EXPECT_NE(warnings[0].find("MinimumRegionCells"), std::string::npos);
  options.ConserveVolume = false;
  RunMesher(input, options, serial);
  EXPECT_EQ(warnings.size(), 1u);
}

/// The message names the materials with the largest missing volumes, at most twenty.
TEST(Mesher, InexactVolumesAreSorted)
{
  MeshReport report;
  Materials table;
  for (int m = 0; m <= 25; ++m)
  {
    table.Names.push_back("m" + std::to_string(m));
    table.Labels.push_back(10 * m);
    report.TargetVolume.push_back(100.0);
    report.MeshVolume.push_back(m < 3 ? 100.5 : 100.0 + m);
    report.Materials.push_back({ 1, 7 });
    report.LostCells.push_back(m);
    report.GainedCells.push_back(2 * m);
  }
  report.MeshVolume[4] = 0.0; // has no element
  const std::string text = DescribeInexactMaterials(report, table, true);
  EXPECT_EQ(text.find("22 materials miss their volumes by more than 1 %: 'm25' (id 250) by +25 % "
                      "(fragments: 7, cells lost: 25, gained: 50), 'm24' (id 240)"),
    0u)
    << text;
  EXPECT_NE(text.find("'m6' (id 60) by +6 % (fragments: 7, cells lost: 6, gained: 12) and 2 more"),
    std::string::npos)
    << text;
  EXPECT_EQ(text.find("'m5'"), std::string::npos);
  EXPECT_NE(text.find("LabelSmoothing"), std::string::npos);
  EXPECT_EQ(
    DescribeInexactMaterials(report, table, false).find("LabelSmoothing"), std::string::npos);
}

/// The message names the materials with the largest displaced volumes.
TEST(Mesher, DisplacedVolumesAreSorted)
{
  MeshReport report;
  Materials table;
  for (int m = 0; m <= 5; ++m)
  {
    table.Names.push_back("m" + std::to_string(m));
    table.Labels.push_back(10 * m);
    report.TargetVolume.push_back(m == 2 ? 1000.0 : 100.0);
    report.MeshVolume.push_back(m == 3 ? 0.0 : report.TargetVolume[m]);
  }
  EXPECT_EQ(DescribeDisplacedMaterials(report, table, {}, false), ""); // not measured
  report.DisplacedVolume = { 1.0, 0.0496, 0.0504, 1.0, 0.456, 0.996 };
  const std::string text = DescribeDisplacedMaterials(report, table, {}, false);
  EXPECT_NE(text.find("Finer cells in the input"), std::string::npos);
  WideReport wide;
  wide.Widths = { 2.0, 2.0, 2.0 };
  const std::string ofWide = DescribeDisplacedMaterials(report, table, wide, false);
  EXPECT_EQ(ofWide.find("2 materials have more than 10 % of their volumes in another place than in "
                        "the input: 'm5' (id 50) 100 %, 'm4' (id 40) 46 %. "),
    0u)
    << ofWide;
  EXPECT_NE(ofWide.find("A smaller CellWidth"), std::string::npos);
  wide.MaterialWidths = { 2.0, 2.0, 2.0, 1.0, 2.0, 2.0 };
  EXPECT_NE(DescribeDisplacedMaterials(report, table, wide, false).find(". Smaller MaterialWidths"),
    std::string::npos);
  EXPECT_EQ(text.find("3 materials have more than 5 % of their volumes in another place than in "
                      "the input: 'm5' (id 50) 100 %, 'm2' (id 20) 5 %, 'm4' (id 40) 46 %. "),
    0u)
    << text;
  EXPECT_NE(text.find("Particles"), std::string::npos);
  EXPECT_EQ(
    DescribeDisplacedMaterials(report, table, {}, true).find("Particles"), std::string::npos);
  report.DisplacedVolume = { 1.0, 0.06, 0.0496, 1.0, 0.0, 0.0 };
  EXPECT_EQ(DescribeDisplacedMaterials(report, table, {}, false)
              .find("1 material has more than 5 % of its volume in another place than in the "
                    "input: 'm1' (id 10) 6 %. "),
    0u);
  report.DisplacedVolume = { 1.0, 0.0, 0.05, 1.0, 0.0, 0.0 };
  EXPECT_EQ(DescribeDisplacedMaterials(report, table, {}, false), "");
}

void ExpectError(const MesherInput& input, const std::string& text)
{
  Runtime serial;
  try
  {
    RunMesher(input, MesherOptions(), serial);
    FAIL() << "no error: " << text;
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(error.what(), text);
  }
}

TEST(Mesher, WrongNames)
{
  MesherInput input = MakeInput(true);
  input.Arrays.Fractions = { "cube" };
  ExpectError(input, "The input has no numeric cell array 'cube'. Its cell arrays: 'ball', 'x'.");
  input = MakeInput(true);
  input.Arrays.State.Arrays = { "MaterialId" };
  ExpectError(input,
    "The state array 'MaterialId' has the name of an array that the mesh itself may have: rename "
    "it, or leave it out.");
}

TEST(Mesher, WrongRotatedArrays)
{
  for (bool isConserved : { false, true })
  {
    MesherInput input = MakeInput(true);
    input.Arrays.State.IsConserved = isConserved;
    input.Arrays.State.Rotated = { "x" };
    ExpectError(input,
      "The rotated array 'x' has 1 component: a vector has 3, a symmetric tensor 6 (xx, yy, zz, "
      "xy, yz, xz), a tensor 9.");
    input.Arrays.State.Rotated = { "y" };
    ExpectError(input, "The rotated array 'y' is not a selected state array.");
  }
}

TEST(Mesher, WarnsOfAnEmptyMesh)
{
  Runtime serial;
  MesherInput input = MakeInput(true);
  std::vector<std::string> warnings;
  input.Warn = [&warnings](const std::string& text) { warnings.push_back(text); };
  MesherOptions options;
  options.MinimumRegionCells = static_cast<int>(Side * Side * Side);
  const MesherResult result = RunMesher(input, options, serial);
  EXPECT_TRUE(result.TheMesh.ElementIds.empty());
  EXPECT_EQ(warnings,
    (std::vector<std::string>{
      "The mesh is empty: no cell is filled by its materials to the iso value." }));
}

} // namespace
