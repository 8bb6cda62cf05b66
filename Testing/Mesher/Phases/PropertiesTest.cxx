/// All guarantees of a mesh (CheckCase) for fields, methods, options and ranks.
#include "Properties.h"

#include "RandomDraw.h"
#include "Sweep.h"

#include "Labels/LabelCondition.h"
#include "Labels/SmoothLabels.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace vfm
{
namespace testing
{

FuzzCase CaseOf(const Kind& kind, const CartesianGrid& grid, FractionField field, int halvings)
{
  FuzzCase c{ "", "", grid, std::move(field), {}, kind.Make, {}, true };
  c.Options.Method = kind.Method;
  c.Options.Levels.Refinements = halvings;
  c.Options.Levels.FineInterfaces = kind.FineInterfaces;
  return c;
}

Input CaseOfShape(const Kind& kind, const MeshCase& shape, int halvings)
{
  return { CaseOf(kind, shape.Grid, shape.Fractions, halvings) };
}

void PrintTo(const Group& group, std::ostream* out)
{
  *out << group.Name;
}

} // namespace testing
} // namespace vfm

namespace
{

// Random labels

struct LabelsCase
{
  int Materials, Lowest; // lowest label 0: with void
  bool MeshVoid;
};

void AddRandomLabels(std::vector<Group>& groups)
{
  for (const LabelsCase& labels : { LabelsCase{ 1, 0, false }, { 1, 0, true }, { 2, 0, false },
         { 2, 1, false }, { 5, 0, false }, { 5, 1, false }, { 5, 0, true } })
  {
    groups.push_back({ "RandomLabels_Hexes_" + std::to_string(labels.Materials) + "_" +
        std::to_string(labels.Lowest) + (labels.MeshVoid ? "_void" : ""),
      20,
      [=](unsigned seed) -> Input
      {
        const Index n = 3 + seed % 7;
        const CartesianGrid grid = MakeUnitGrid(n, n + seed % 3, n + seed % 2);
        FuzzCase c =
          CaseOf(Hexes, grid, MakeRandomLabels(grid, labels.Materials, labels.Lowest, seed));
        c.Options.MeshVoid = labels.MeshVoid;
        return { c };
      },
      { 0.30 } });
  }
  for (const Kind& kind : { Cells, Lattice, Filled })
  {
    for (int materials = 1; materials <= 5 && (kind.Method != TetMethod::TetGen || HasTetGen());
         ++materials)
    {
      groups.push_back(
        { std::string("RandomLabels_") + kind.Name + "_" + std::to_string(materials), 10,
          [=](unsigned seed) -> Input
          {
            const bool isFilled = kind.Method == TetMethod::TetGen;
            const Index n = isFilled ? 2 + seed % 5 : 3 + seed % 7;
            const CartesianGrid grid = MakeUnitGrid(n, n + seed % 3, n + seed / 2 % 2);
            FuzzCase c =
              CaseOf(kind, grid, MakeRandomLabels(grid, materials, seed % 2 == 0 ? 0 : 1, seed));
            c.Options.MeshVoid = seed / 2 % 2 == 1;
            return { c };
          } });
    }
  }
}

/// Each accepted star of two labels, in a grid of very different widths with a border that
/// continues it: the mesh is valid before smoothing.
void AddStars(std::vector<Group>& groups)
{
  std::vector<int> regions;
  for (int region = 1; region < 255; ++region)
  {
    if (RegionNormalsTable[region].ViolatedAxes() == 0)
    {
      regions.push_back(region);
    }
  }
  Bounds limits;
  limits.NoFlips = true;
  groups.push_back({ "AcceptedStars", static_cast<unsigned>(regions.size()),
    [regions](unsigned at) -> Input
    {
      const std::array<std::vector<double>, 3> coordinates{ { { 0.0, 1.0, 8.0, 9.0, 1000.0 },
        { 0.0, 50.0, 51.0, 58.0, 59.0 }, { 0.0, 1.0, 2.0, 3.0, 4.0 } } };
      const CartesianGrid grid(coordinates);
      const auto labelOf = [&](const Index3& p)
      {
        const int c = static_cast<int>((p[0] > 1) | (p[1] > 1) << 1 | (p[2] > 1) << 2);
        return 1 + (regions[at] >> c & 1);
      };
      FuzzCase c = CaseOf(Hexes, grid, MakeLabels(grid, 2, labelOf));
      c.Options.Smoothing = SmoothingMethod::Off;
      return { c };
    },
    limits, false });
}

/// Three layers along the interfaces of random labels, even and thin; the last seed on ranks.
void AddLayers(std::vector<Group>& groups)
{
  groups.push_back({ "Layers", 7,
    [](unsigned seed) -> Input
    {
      const CartesianGrid grid = MakeUnitGrid(8);
      Input input{ CaseOf(Hexes, grid, MakeRandomLabels(grid, 3, 0, seed)) };
      input.Case.Layers = 3;
      input.Case.FirstLayer = seed % 2 == 0 ? 0.1 : 0.0;
      for (int ranks : { 2, 3, 8 })
      {
        if (seed == 6)
        {
          input.Ranks.push_back(CutBox(grid.Global(), ranks));
        }
      }
      return input;
    },
    {}, false });
}

// Ranks

Cuts CutInSlabs(const IndexBox& box)
{
  return { CutBox(box, 3, 0), CutBox(box, 4, 2) };
}

Cuts CutInBlocks(const IndexBox& box)
{
  return { CutBox(box, 2), CutBox(box, 8) };
}

Cuts CutInBoth(const IndexBox& box)
{
  return { CutBox(box, 2), CutBox(box, 3, 0), CutBox(box, 4, 2), CutBox(box, 8) };
}

Cuts CutInMany(const IndexBox& box)
{
  return { CutBox(box, 2), CutBox(box, 3, 0), CutBox(box, 4, 2), CutBox(box, 8), CutBox(box, 33) };
}

/// Returns partitions with empty ranks, cut along all axes or one, and slabs thinner than the ghost
/// layers.
Cuts CutOddly(const IndexBox& box)
{
  Cuts cuts{ WithEmptyRank(CutBox(box, 2)), CutBox(box, 14, 1) };
  for (int axis = 0; axis < 3; ++axis)
  {
    cuts[0].push_back(box);
    cuts[0].back().Lower[axis] = box.Upper[axis];
  }
  return cuts;
}

/// Returns a shape by its name, or noise of n cells.
MeshCase ShapeOf(const std::string& name, const Index3& n, int materials)
{
  MeshCase shape = name == "12 grains" ? MakePolycrystalCase(12, 14)
                                       : MakeMeshCase(name == "noise" ? "sphere 8" : name);
  if (name == "noise")
  {
    shape.Grid = MakeUnitGrid(n[0], n[1], n[2]);
    shape.Fractions = MakeRandomLabels(shape.Grid, materials, 0, 5);
  }
  return shape;
}

void AddRanks(std::vector<Group>& groups)
{
  struct RankCase
  {
    const char* Shape;
    Cuts (*Cut)(const IndexBox&);
    bool MeshVoid = false;
  };
  for (const Kind& kind : Kinds)
  {
    for (const RankCase& ranks : { RankCase{ "sphere 8", CutOddly }, { "sphere 16", CutInMany },
           { "ball of 3 sectors", CutInBoth }, { "12 grains", CutInBoth },
           { "half sphere", CutInBoth }, { "noise", CutInSlabs }, { "noise", CutInBlocks, true } })
    {
      groups.push_back(
        { std::string("Ranks_") + kind.Name + "_" + ranks.Shape + (ranks.MeshVoid ? "_void" : ""),
          1,
          [=](unsigned) -> Input
          {
            Input input = CaseOfShape(kind, ShapeOf(ranks.Shape, { { 9, 8, 10 } }, 4));
            input.Case.Options.MeshVoid = ranks.MeshVoid;
            input.Ranks = ranks.Cut(input.Case.Grid.Global());
            return input;
          },
          {}, false });
    }
  }
  groups.push_back({ "Ranks_StairStepAndSmoothingOff", 6,
    [](unsigned at) -> Input
    {
      Input input = CaseOfShape(Kinds[at / 2], MakeMeshCase("sphere 8"));
      input.Case.Options.StairStep = at % 2 == 0;
      input.Case.Options.Smoothing =
        at % 2 == 0 ? SmoothingMethod::QuadricSurface : SmoothingMethod::Off;
      input.Ranks = { CutBox(input.Case.Grid.Global(), 4) };
      return input;
    },
    {}, false });
  for (const char* name : { "sphere 16", "12 grains", "noise" })
  {
    groups.push_back({ std::string("Ranks_TetGen_") + name, HasTetGen() ? 1u : 0u,
      [=](unsigned) -> Input
      {
        Input input = CaseOfShape(Filled, ShapeOf(name, { { 7, 8, 6 } }, 3));
        const IndexBox& box = input.Case.Grid.Global();
        input.Ranks = { CutBox(box, 1), CutBox(box, 2), CutBox(box, 4) };
        return input;
      },
      {}, false });
  }
}

// Smoothed labels: meshes follow their cells

constexpr Index CubeCells = 8; // of random fields, per axis
constexpr int Passes[] = { 0, 1, 3, 10 };

/// Returns a random label in each 2 x 2 x 2 block, another one in 5 % of the cells.
FractionField MakeNoisyBlocks(const CartesianGrid& grid, int materials, unsigned seed)
{
  RandomDraw draw(seed);
  std::vector<int> blocks;
  for (Index b = 0; b < CubeCells * CubeCells * CubeCells / 8; ++b)
  {
    blocks.push_back(draw.Whole(0, materials));
  }
  return MakeLabels(grid, materials,
    [&](const Index3& p)
    {
      const Index block = ((p[2] / 2) * CubeCells / 2 + p[1] / 2) * CubeCells / 2 + p[0] / 2;
      return draw.Chance(0.05) ? draw.Whole(0, materials) : blocks[block];
    });
}

FractionField MakeRandomFractions(const CartesianGrid& grid, int materials, unsigned seed)
{
  RandomDraw draw(seed);
  FractionField field(grid, materials);
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      std::vector<FractionField::Part> parts;
      double sum = draw.Between(0.0, 1.0); // void
      for (int m = 1; m <= materials; ++m)
      {
        parts.push_back({ m, draw.Between(0.0, 1.0) });
        sum += parts.back().Fraction;
      }
      std::for_each(parts.begin(), parts.end(), [&](auto& part) { part.Fraction /= sum; });
      field.SetParts(grid.Linear(p), parts);
    });
  return field;
}

FractionField Smooth(const CartesianGrid& grid, int passes, FractionField field)
{
  Runtime runtime;
  if (passes > 0)
  {
    SmoothLabels(grid, passes, Partition(grid, runtime.Group()), runtime, field);
  }
  return field;
}

/// Two plates with a gap, or one plate if their labels are equal.
struct Gap
{
  double Width, Slope; // cells; rise per cell
  int Upper;           // label of the upper plate; the lower one has 1
};

FractionField MakePlates(const CartesianGrid& grid, const Gap& gap)
{
  const double middle = gap.Width == 2.0 ? 8.0 : 8.5; // symmetric about cells
  return MakeLabels(grid, 2,
    [&](const Index3& p)
    {
      const double height = p[2] + 0.5 - middle - gap.Slope * (p[0] - 7.5);
      const bool isInside = p[0] > 1 && p[0] < 14 && p[1] > 1 && p[1] < 14 &&
        std::abs(height) > gap.Width / 2 && std::abs(height) < 4.5;
      return !isInside ? 0 : height > 0.0 ? gap.Upper : 1;
    });
}

using MakeField = FractionField (*)(const CartesianGrid&, int materials, unsigned seed);

FractionField MakeAllLabels(const CartesianGrid& grid, int materials, unsigned seed)
{
  return MakeRandomLabels(grid, materials, 0, seed);
}

void AddSmoothed(std::vector<Group>& groups)
{
  struct Field
  {
    const char* Name;
    MakeField Make;
    int Halvings;
  };
  for (const Field& field :
    { Field{ "Labels", MakeAllLabels, 0 }, { "NoisyBlocks", MakeNoisyBlocks, 0 },
      { "Fractions", MakeRandomFractions, 0 }, { "NoisyBlocks_levels", MakeNoisyBlocks, 1 } })
  {
    for (int passes : Passes)
    {
      groups.push_back({ std::string("Smoothed_") + field.Name + "_" + std::to_string(passes), 4,
        [=](unsigned seed) -> Input
        {
          const CartesianGrid grid = MakeUnitGrid(CubeCells);
          FractionField labels = field.Make(grid, 2 + static_cast<int>(seed % 4), seed);
          FuzzCase c =
            CaseOf(Lattice, grid, Smooth(grid, passes, std::move(labels)), field.Halvings);
          c.Options.MeshVoid = seed % 4 == 3;
          return { c, { CutBaseBox(grid, field.Halvings, 3) } };
        } });
    }
  }
  Bounds limits;
  limits.NoLocked = true;
  for (const Kind& kind : Kinds)
  {
    groups.push_back({ std::string("Plates_") + kind.Name, 16,
      [=](unsigned at) -> Input
      {
        const Gap gaps[] = { { 1.0, 0.0, 2 }, { 1.0, 0.0, 1 }, { 1.3, 0.3, 2 }, { 2.0, 0.0, 2 } };
        const CartesianGrid grid = MakeUnitGrid(16);
        return { CaseOf(kind, grid, Smooth(grid, Passes[at % 4], MakePlates(grid, gaps[at / 4]))) };
      },
      limits, false });
  }
}

std::vector<Group> ListGroups()
{
  std::vector<Group> groups;
  AddRandomLabels(groups);
  AddStars(groups);
  AddLayers(groups);
  AddRanks(groups);
  AddLevels(groups);
  AddLevelRanks(groups);
  AddSmoothed(groups);
  AddPeriods(groups);
  return groups;
}

std::vector<unsigned> ListCases(const Group& group)
{
  std::vector<unsigned> all(group.Seeds);
  std::iota(all.begin(), all.end(), 0u);
  return group.IsSweep ? ListSeeds(group.Seeds, group.Part, group.Parts) : all;
}

class Properties : public ::testing::TestWithParam<Group>
{
};

} // namespace

TEST_P(Properties, Hold)
{
  const Group& group = this->GetParam();
  double jacobian = 1.0, angle = 180.0;
  Index transitions = 0, added = 0, elements = 0;
  for (unsigned seed : ListCases(group))
  {
    SCOPED_TRACE("case " + std::to_string(seed));
    const Input input = group.Make(seed);
    const FuzzResult result = CheckCase(input.Case, input.Ranks);
    EXPECT_EQ(result.Problem, "");
    EXPECT_TRUE(result.Elements > 0 || (group.IsSweep && input.Ranks.empty()));
    EXPECT_TRUE(result.Report.FlippedCells == 0 || !group.Limits.NoFlips);
    EXPECT_TRUE(result.Locked == 0 || !group.Limits.NoLocked) << result.Locked;
    Index families = 0;
    for (const MeshReport::Level& level : result.Report.Levels)
    {
      families += level.Families;
      added += level.AddedForValidity;
    }
    EXPECT_TRUE(families > 0 || !group.Limits.HasLevels);
    EXPECT_TRUE(!group.Limits.HasTransitions ||
      (result.Report.TransitionCells > 0 && result.Report.Levels[0].Cells > 0));
    if (result.Elements > 0)
    {
      jacobian = std::min(jacobian, result.ScaledJacobian);
      angle = std::min(angle, result.Report.MinimumDihedralAngle);
      transitions += result.Report.TransitionCells;
      elements += result.Elements;
    }
  }
  std::printf("%s: %lld elements, %lld in transitions, scaled Jacobian %.3f, dihedral angle %.1f, "
              "%lld families added for validity\n",
    group.Name.c_str(), static_cast<long long>(elements), static_cast<long long>(transitions),
    jacobian, angle, static_cast<long long>(added));
  EXPECT_GE(jacobian, group.Limits.Jacobian);
  EXPECT_GE(angle, group.Limits.Angle);
  EXPECT_TRUE(transitions > group.Limits.Transitions || !IsWholeSweep());
  EXPECT_TRUE(added > 0 || !group.Limits.AddsFamilies || !IsWholeSweep());
  EXPECT_TRUE(added == 0 || !group.Limits.AddsNoFamilies) << added;
}

INSTANTIATE_TEST_SUITE_P(Of, Properties, ::testing::ValuesIn(ListGroups()),
  [](const ::testing::TestParamInfo<Group>& info)
  {
    std::string name = info.param.Name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });
