/// Cases with cells of several levels.
#include "Properties.h"

#include "Fractions/RefineCells.h"
#include "RankMeshes.h"

#include <cmath>
#include <random>

namespace vfm
{
namespace testing
{
namespace
{

/// Returns random labels in a box of cells and one label around it.
FractionField MakeRandomBlock(const CartesianGrid& grid, const IndexBox& block, unsigned seed)
{
  std::mt19937 engine(seed);
  return MakeLabels(grid, 2,
    [&](const Index3& p) { return block.Contains(p) ? static_cast<int>(engine() % 3) : 1; });
}

/// Returns random labels, or fractions in which labels can change at almost no cost.
FractionField MakeNoise(const CartesianGrid& grid, bool isTies, unsigned seed)
{
  return isTies ? MakeNearTies(grid, seed % 2 == 0 ? 0.3 : 1.0, seed)
                : MakeRandomLabels(grid, 2, 0, seed);
}

/// Blocks of labels at a distance from each other, in hexes.
Input MakeFamilyBlocks(unsigned seed)
{
  const int halvings = 1 + static_cast<int>(seed % 3 == 0);
  const Index n = halvings == 1 ? 16 : 24;
  const CartesianGrid grid = MakeUnitGrid(n, n + 4 * (seed % 3), n);
  FuzzCase c = CaseOf(Hexes, grid, MakeBlockLabels(grid, halvings, seed), halvings);
  c.Options.MeshVoid = seed % 5 == 0;
  c.Options.Levels.Families = MakeRandomFamilies(grid, halvings, .02 * (1 + seed % 4), seed);
  return { c };
}

/// Labels or near ties, across levels.
Input MakeCrossingNoise(const Kind& kind, unsigned seed)
{
  const int halvings = 1 + static_cast<int>(seed % 3 == 0);
  const Index n = 8 + 2 * (seed % 2);
  const CartesianGrid grid =
    halvings == 1 ? MakeUnitGrid(n, 8 + 2 * (seed % 3), 10) : MakeUnitGrid(8, 12, 12);
  FuzzCase c = CaseOf(kind, grid, MakeNoise(grid, seed / 2 % 2 == 1, seed), halvings);
  c.Options.MeshVoid = seed % 5 == 0;
  c.Options.Levels.Families = MakeRandomFamilies(grid, halvings, .05 * (1 + seed % 4), seed);
  return { c };
}

/// A block of noise in tetrahedra.
Input MakeFamilyTets(const Kind& kind, int halvings, unsigned seed)
{
  const Index base = halvings == 1 ? 9 : 5, factor = Index(1) << halvings;
  const CartesianGrid grid =
    MakeUnitGrid(base * factor, (base - seed % 2) * factor, (base + seed / 2 % 2) * factor);
  const Index at = seed % 3 == 0 ? 0 : 5 + seed % 7;
  const IndexBox block{ { { at, at, 3 } }, { { at + 3, at + 2, 6 } } };
  FuzzCase c = CaseOf(kind, grid, MakeRandomBlock(grid, block, seed), halvings);
  c.Options.MeshVoid = true;
  const double chances[] = { 0.02, 0.1, 0.3 };
  c.Options.Levels.Families = MakeRandomFamilies(grid, halvings, chances[seed % 3], seed);
  return { c };
}

/// Returns coordinates of n base cells. Widths are random; neighbouring widths differ by up to a
/// factor.
std::vector<double> MakeGradedAxis(Index n, double factor, double width, std::mt19937& random)
{
  std::uniform_real_distribution<double> exponent(-1.0, 1.0);
  std::vector<double> x(1, 0.0);
  for (Index i = 0; i < n; ++i)
  {
    x.push_back(x.back() + width);
    width *= std::pow(factor, exponent(random));
  }
  return x;
}

CartesianGrid MakeGradedGrid(Index n, int halvings, unsigned seed)
{
  std::mt19937 random(seed);
  const double factor = seed % 2 == 0 ? 300.0 : 7.0, aspect = seed % 4 < 2 ? 1e4 : 100.0;
  std::uniform_real_distribution<double> exponent(0.0, 1.0);
  std::array<std::vector<double>, 3> x;
  for (std::vector<double>& axis : x)
  {
    axis = MakeGradedAxis(n, factor, std::pow(aspect, exponent(random)), random);
  }
  return CartesianGrid(HalveWidths(x, halvings));
}

/// More cells are refined where transitions of stretched hexes cannot be untangled.
Input MakeStretched(const Kind& kind, unsigned seed)
{
  const int halvings = 1 + static_cast<int>(seed % 3 == 0);
  const CartesianGrid grid = MakeGradedGrid(halvings == 1 ? 8 : 6, halvings, seed);
  FuzzCase c = CaseOf(kind, grid, MakeBlockLabels(grid, halvings, seed), halvings);
  c.Options.MeshVoid = true;
  c.Options.Levels.Families = MakeRandomFamilies(grid, halvings, .02 * (1 + seed % 4), seed);
  return { c };
}

/// Cells of 1 : 1.8 : 2.7, which grow.
Input MakeGrowing(unsigned at)
{
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    double place = -1.0, width = 0.3 + 0.25 * a;
    for (int i = 0; i <= 24; ++i, place += width, width *= 1.03)
    {
      x[a].push_back(place);
    }
  }
  const CartesianGrid grid(x);
  const IndexBox block{ { { 10, 11, 9 } }, { { 13, 13, 12 } } };
  FuzzCase c = CaseOf(Kinds[1 + at], grid, MakeRandomBlock(grid, block, 5), 2);
  c.Options.MeshVoid = true;
  c.Options.Levels.Families = MakeRandomFamilies(grid, 2, 0.1, 5);
  return { c };
}

struct LevelRanks
{
  Kind Elements;
  std::string Shape; ///< name of a case, "blocks", or noise: "labels" or "ties"
  int Halvings, Ranks, Axis;
  Index3 Base = {}; ///< number of base cells of noise
  unsigned Seed = 0;
  bool MeshVoid = true;
};

/// Three ranks become four, one of them without cells.
Input MakeLevelRanks(const LevelRanks& c)
{
  const bool isNoise = c.Shape == "labels" || c.Shape == "ties", isBlocks = c.Shape == "blocks";
  const bool crosses = !c.Elements.FineInterfaces;
  const CartesianGrid cube = isNoise
    ? MakeUnitGrid(c.Base[0] << c.Halvings, c.Base[1] << c.Halvings, c.Base[2] << c.Halvings)
    : MakeUnitGrid(24, 16, 32);
  Input input = isNoise
    ? Input{ CaseOf(c.Elements, cube, MakeNoise(cube, c.Shape == "ties", c.Seed), c.Halvings) }
    : isBlocks ? Input{ CaseOf(c.Elements, cube, MakeBlockLabels(cube, c.Halvings, 3), c.Halvings) }
               : CaseOfShape(c.Elements, MakeMeshCase(c.Shape), c.Halvings);
  const CartesianGrid& grid = input.Case.Grid;
  MeshOptions& options = input.Case.Options;
  options.MeshVoid = c.MeshVoid;
  if (isNoise || isBlocks)
  {
    options.Levels.Families = isNoise
      ? MakeRandomFamilies(grid, c.Halvings, c.Halvings == 3 ? .05 : .1, c.Seed + 4)
      : MakeRandomFamilies(grid, c.Halvings, .02, 7);
  }
  else if (crosses)
  {
    options.Levels.Families = RefineBelow(grid, c.Halvings, .5);
  }
  const std::vector<IndexBox> boxes = CutBaseBox(grid, c.Halvings, c.Ranks, c.Axis);
  input.Ranks = { c.Ranks == 3 ? WithEmptyRank(boxes) : boxes };
  return input;
}

std::vector<LevelRanks> ListLevelRanks()
{
  std::vector<LevelRanks> cases{ { Hexes, "ball and plate", 1, 2, -1 },
    { Hexes, "ball and plate", 2, 8, -1 }, { Hexes, "ball and plate", 3, 4, -1 },
    { Hexes, "half sphere", 1, 3, 0 }, { Hexes, "blocks", 1, 8, -1 }, { Hexes, "blocks", 2, 4, 2 },
    { Hexes, "blocks", 3, 3, -1 }, { Crossing, "ball and plate", 1, 2, -1 },
    { Crossing, "ball and plate", 2, 8, -1 }, { Crossing, "half sphere", 1, 3, 0 },
    // along one axis with three or more ranks, each has one or two base cells
    { Crossing, "labels", 1, 8, -1, { { 4, 4, 5 } }, 3 },
    { Crossing, "labels", 1, 5, 2, { { 3, 4, 5 } }, 7 },
    { Crossing, "labels", 2, 4, 2, { { 3, 2, 4 } }, 3 },
    { Crossing, "ties", 1, 3, 0, { { 5, 4, 4 } }, 5 },
    { Crossing, "ties", 2, 2, -1, { { 3, 3, 4 } }, 5 },
    { Crossing, "ties", 2, 4, 2, { { 3, 2, 4 } }, 9 },
    { Crossing, "ties", 2, 8, -1, { { 3, 3, 2 } }, 11 },
    { Crossing, "ties", 3, 3, 2, { { 3, 2, 3 } }, 3 },
    { Crossing, "ties", 3, 2, 2, { { 2, 2, 3 } }, 4 } };
  for (std::size_t i = 0, count = cases.size(); i < count; ++i)
  {
    if (!cases[i].Elements.FineInterfaces)
    {
      cases.push_back(cases[i]);
      cases.back().Elements = CrossingTets;
    }
  }
  for (const Kind& kind : { Cells, Lattice })
  {
    for (const std::array<int, 2>& c : { std::array<int, 2>{ { 1, 2 } }, { { 1, 8 } }, { { 2, 2 } },
           { { 2, 3 } }, { { 2, 8 } }, { { 3, 3 } } })
    {
      cases.push_back({ kind, "blocks", c[0], c[1], -1, {}, 0, c[1] != 2 });
    }
    cases.push_back({ kind, "sphere 16", 1, 8, -1, {}, 0, false });
    cases.push_back({ kind, "sphere 16", 1, 3, -1 });
  }
  if (HasTetGen())
  {
    cases.push_back({ Filled, "half sphere", 2, 4, -1 });
  }
  return cases;
}

} // namespace

void AddLevels(std::vector<Group>& groups)
{
  for (unsigned part = 0; part < 5; ++part)
  {
    const std::string name = std::to_string(part);
    groups.push_back({ "Families_Hexes_" + name, 50, MakeFamilyBlocks, { 0.51 }, true, part, 5 });
    // One case, seed 15 in part 1, is far below all others by chance: 0.37 to 0.40, as the last
    // bits of sums of volumes are. The next ones are above 0.45.
    Bounds crossing{ part == 1 ? 0.36 : 0.39 };
    crossing.Transitions = 200;
    groups.push_back({ "Families_Crossing_" + name, 50,
      [](unsigned seed) { return MakeCrossingNoise(Crossing, seed); }, crossing, true, part, 5 });
    groups.push_back({ "Families_CrossingTets_" + name, 50,
      [](unsigned seed) { return MakeCrossingNoise(CrossingTets, seed); }, { -1.0, 15.0 }, true,
      part, 5 });
  }
  for (const Kind& kind : { Cells, Lattice })
  {
    for (int halvings : { 1, 2 })
    {
      groups.push_back({ std::string("Families_") + kind.Name + "_" + std::to_string(halvings),
        halvings == 1 ? 6u : 3u,
        [=](unsigned seed) { return MakeFamilyTets(kind, halvings, seed); }, { -1.0, 25.0 } });
    }
  }
  Bounds stretched;
  stretched.AddsFamilies = true;
  Bounds stretchedTets;
  stretchedTets.AddsNoFamilies = true;
  for (const Kind& kind : { Hexes, Crossing, Cells, Lattice, CrossingTets })
  {
    const bool isTets = kind.Make == MakeTetMesh;
    groups.push_back({ std::string("StretchedFamilies_") + kind.Name, 4,
      [=](unsigned seed) { return MakeStretched(kind, seed); },
      isTets ? stretchedTets : stretched });
  }
  groups.push_back({ "GrowingCells", 2, MakeGrowing, {}, false });
}

void AddLevelRanks(std::vector<Group>& groups)
{
  for (const LevelRanks& c : ListLevelRanks())
  {
    groups.push_back({ std::string("LevelRanks_") + c.Elements.Name + "_" + c.Shape + "_" +
        std::to_string(c.Halvings) + "_" + std::to_string(c.Ranks) + "_" + std::to_string(c.Seed),
      1, [c](unsigned) { return MakeLevelRanks(c); }, {}, false });
  }
}

} // namespace testing
} // namespace vfm
