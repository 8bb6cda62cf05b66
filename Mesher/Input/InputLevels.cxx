#include "Input/InputLevels.h"

#include "Base/Runtime.h"
#include "Fractions/RefineCells.h"
#include "Input/BlockChecks.h"
#include "Input/NodeCoordinates.h"
#include "Octree/OctreeKeys.h"
#include "Ranks/Agreement.h"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double LevelTolerance = 0.01; // tolerance of log2 of a ratio of widths
constexpr int MaximumLevels = 30;

double MeanWidth(const InputBlock& block, int axis)
{
  const std::vector<double>& x = block.Coordinates[axis];
  return (x.back() - x.front()) / static_cast<double>(x.size() - 1);
}

/// Collective. Returns the largest mean cell widths.
Vector3 FindCoarsestWidths(const std::vector<InputBlock>& blocks, Ranks& ranks)
{
  Vector3 widths{ { 0.0, 0.0, 0.0 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const InputBlock& block : blocks)
    {
      widths[axis] = std::max(widths[axis], MeanWidth(block, axis));
    }
    widths[axis] = ranks.Max(widths[axis]);
  }
  return widths;
}

double LevelAlong(const InputBlock& block, int axis, const Vector3& coarsest)
{
  return std::log2(coarsest[axis] / MeanWidth(block, axis));
}

int FindLevel(const InputBlock& block, const Vector3& coarsest)
{
  const int level = static_cast<int>(std::lround(LevelAlong(block, 0, coarsest)));
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(std::fabs(LevelAlong(block, axis, coarsest) - level) < LevelTolerance) ||
      level > MaximumLevels)
    {
      std::ostringstream text;
      text
        << block.Name << " has cells of mean width " << MeanWidth(block, axis) << " along "
        << AxisNames[axis] << ", where the widest of the input are " << coarsest[axis]
        << ". Levels of a refined grid (AMR) must differ by the factor 2, 4, 8 and so on, the same "
           "along x, y and z.";
      throw InputError(text.str());
    }
  }
  return level;
}

/// A node of level 0 in a block.
struct BaseNode
{
  Index At;
  Index Level; ///< level of the block
  double X;

  bool operator<(const BaseNode& other) const
  {
    return At != other.At    ? At < other.At
      : Level != other.Level ? Level < other.Level
                             : X < other.X;
  }
  bool operator==(const BaseNode& other) const
  {
    return At == other.At && Level == other.Level && X == other.X;
  }
};

/// Collective. Finds the nodes of level 0 along one axis.
/// @param levels levels of the blocks
std::vector<double> FindBaseNodes(const std::vector<InputBlock>& blocks,
  const std::vector<int>& levels, int axis, double coarsest, Ranks& ranks)
{
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const InputBlock& block : blocks)
  {
    lower = std::min(lower, block.Coordinates[axis].front());
    upper = std::max(upper, block.Coordinates[axis].back());
  }
  lower = -ranks.Max(-lower);
  upper = ranks.Max(upper);
  const double count = std::max(std::round((upper - lower) / coarsest), 1.0);
  const double width = (upper - lower) / count;
  std::vector<BaseNode> nodes;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (double x : blocks[b].Coordinates[axis])
    {
      const double at = std::ldexp((x - lower) / width, levels[b]);
      const Index node = std::llround(at), step = Index(1) << levels[b];
      if (node % step == 0)
      {
        nodes.push_back({ node / step, levels[b], x });
      }
    }
  }
  std::vector<double> x;
  for (const BaseNode& node : UnionOverRanks(ranks, std::move(nodes)))
  {
    if (node.At == static_cast<Index>(x.size()))
    {
      x.push_back(node.X);
    }
  }
  if (static_cast<double>(x.size()) != count + 1.0)
  {
    std::ostringstream text;
    text << "The blocks leave a gap along " << AxisNames[axis] << " after "
         << (x.empty() ? lower : x.back()) << ": no block has the next node of level 0, " << width
         << " farther. Levels of a refined grid "
            "(AMR) must lie on one grid, and together fill a box.";
    throw InputError(text.str());
  }
  return x;
}

Index FindNearest(const std::vector<double>& sorted, double x)
{
  const Index above = std::lower_bound(sorted.begin(), sorted.end(), x) - sorted.begin();
  if (above == static_cast<Index>(sorted.size()))
  {
    return above - 1;
  }
  return above > 0 && x - sorted[above - 1] < sorted[above] - x ? above - 1 : above;
}

void PlaceOnLevel(InputBlock& block, int level, const InputBlocks& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>&x = block.Coordinates[axis], &all = grid.Coordinates[axis];
    const double width = MeanWidth(block, axis);
    const Index first = FindNearest(all, x.front());
    block.Box.Lower[axis] = first;
    block.Box.Upper[axis] = first + static_cast<Index>(x.size()) - 1;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      const std::size_t node = first + i;
      if (node >= all.size() || std::fabs(x[i] - all[node]) > MatchTolerance * width)
      {
        std::ostringstream text;
        text << block.Name << " does not fit the other blocks along " << AxisNames[axis] << " near "
             << x[i] << ": its cells have the size of level " << level
             << " of a refined grid (AMR), but the nearest node of that level is at "
             << all[FindNearest(all, x[i])] << ".";
        throw InputError(text.str());
      }
    }
  }
}

/// Collective. Makes the grids of all levels, without blocks.
InputLevels MakeLevels(const std::vector<InputBlock>& blocks, const std::vector<int>& levels,
  const Vector3& coarsest, Ranks& ranks)
{
  const int mine = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
  const int finest = static_cast<int>(ranks.Max(mine));
  InputLevels input;
  input.Levels.resize(finest + 1);
  for (int axis = 0; axis < 3; ++axis)
  {
    input.Levels[0].Coordinates[axis] = FindBaseNodes(blocks, levels, axis, coarsest[axis], ranks);
  }
  const CartesianGrid base(input.Levels[0].Coordinates);
  const OctreeKeys lattice(base, finest); // throws when there are too many nodes
  for (int level = 1; level <= finest; ++level)
  {
    input.Levels[level].Coordinates = HalveWidths(input.Levels[level - 1].Coordinates);
  }
  CheckIds(input.Levels.back());
  return input;
}

/// Marks that can be changed, by the arrays of their blocks.
using MarkCopies = std::map<const BlockArrays*, std::shared_ptr<std::vector<unsigned char>>>;

/// Returns marks of a block that can be changed; blocks of one set of arrays share them.
std::shared_ptr<std::vector<unsigned char>> FindCopy(const InputBlock& block, MarkCopies& copies)
{
  auto& copy = copies[block.Arrays.get()];
  if (!copy)
  {
    copy = block.Marks
      ? std::make_shared<std::vector<unsigned char>>(*block.Marks)
      : std::make_shared<std::vector<unsigned char>>(block.Arrays->NumberOfTuples(), 0);
  }
  return copy;
}

void Hide(const IndexBox& box, InputBlock& block, MarkCopies& copies)
{
  const auto marks = FindCopy(block, copies);
  block.Marks = marks;
  ForRows(box,
    [&](Index j, Index k)
    {
      unsigned char* row = marks->data() + block.CellId({ { box.Lower[0], j, k } });
      std::fill_n(row, box.Size(0), CellMark::Hidden);
    });
}

/// Marks the cells of a block that the blocks of finer levels cover as hidden.
void MarkBlock(const InputLevels& input, int level, InputBlock& block, MarkCopies& copies)
{
  for (int finer = level + 1; finer <= input.Finest(); ++finer)
  {
    for (const BlockPlace& place : input.Levels[finer].Places)
    {
      const IndexBox box = Intersect(ChangeLevel(place.Box, level - finer), block.Box);
      if (box.NumberOfCells() > 0)
      {
        Hide(box, block, copies);
      }
    }
  }
}

/// Marks the cells of this rank's blocks that finer blocks cover as hidden.
void MarkCovered(InputLevels& input)
{
  MarkCopies copies;
  for (int level = 0; level < input.Finest(); ++level)
  {
    for (InputBlock& block : input.Levels[level].Blocks)
    {
      MarkBlock(input, level, block, copies);
    }
  }
}

/// Collective. Sorts the blocks of several levels.
InputLevels SortByLevels(std::vector<InputBlock> blocks, const Vector3& coarsest, Ranks& ranks)
{
  std::vector<int> levels;
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlock& block : blocks)
      {
        levels.push_back(FindLevel(block, coarsest));
      }
    });
  InputLevels input = MakeLevels(blocks, levels, coarsest, ranks);
  WorkTogether(ranks,
    [&]
    {
      for (std::size_t b = 0; b < blocks.size(); ++b)
      {
        PlaceOnLevel(blocks[b], levels[b], input.Levels[levels[b]]);
        input.Levels[levels[b]].Blocks.push_back(std::move(blocks[b]));
      }
    });
  FindPlaces(input.Levels, ranks);
  CheckOverlaps(input.Levels, ranks);
  MarkCovered(input);
  return input;
}

void RejectPoints(const InputReading& reading, const std::string& why)
{
  if (reading.ArePoints)
  {
    throw InputError(why + ": arrays of point data cannot be meshed, cell data are needed.");
  }
}

std::string TextOf(const InputLevels& input, int level, const Index3& cell)
{
  std::ostringstream text;
  text << vfm::TextOf(cell) << " of level " << level << " at (";
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis > 0 ? ", " : "") << input.Levels[level].Coordinates[axis][cell[axis]];
  }
  return text.str() + ")";
}

} // namespace

std::vector<BlockPlace> ChangeLevel(std::vector<BlockPlace> places, int levels)
{
  for (BlockPlace& place : places)
  {
    place.Box = ChangeLevel(place.Box, levels);
  }
  return places;
}

LevelCover::LevelCover(const InputLevels& input, int level, const IndexBox& box) :
  Box(box), Covered(box.NumberOfCells(), false)
{
  for (int finer = level; finer <= input.Finest(); ++finer)
  {
    for (const BlockPlace& place : input.Levels[finer].Places)
    {
      this->Add(ChangeLevel(place.Box, level - finer));
    }
  }
}

LevelCover::LevelCover(const InputLevels& input, int level, const CartesianGrid& grid) :
  Box(grid.Local()), Covered(Box.NumberOfCells(), false)
{
  const Index3& domain = grid.Domain().Lower;
  IndexBox shifts{ {}, { { 1, 1, 1 } } }; // periods from the first copy
  for (int a = 0; a < 3; ++a)
  {
    const Index period = grid.Period(a);
    shifts.Lower[a] = period > 0 ? -((domain[a] + period - 1) / period) : 0;
    shifts.Upper[a] = 1 - shifts.Lower[a];
  }
  for (int finer = level; finer <= input.Finest(); ++finer)
  {
    for (const BlockPlace& place : input.Levels[finer].Places)
    {
      const IndexBox box = Moved(ChangeLevel(place.Box, level - finer), domain);
      ForCells(
        shifts, [&](const Index3& shift) { this->Add(Moved(box, grid.CellsInPeriods(shift))); });
    }
  }
}

void LevelCover::Add(const IndexBox& box)
{
  ForCells(Intersect(box, this->Box),
    [this](const Index3& cell) { this->Covered[IndexInBox(this->Box, cell)] = true; });
}

InputLevels FindInputLevels(CollectedBlocks collected, Ranks& ranks)
{
  std::vector<InputBlock>& blocks = collected.Blocks;
  const InputReading reading = collected.Reading;
  const Vector3 coarsest = FindCoarsestWidths(blocks, ranks);
  bool differ = false;
  for (const InputBlock& block : blocks)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      differ = differ || LevelAlong(block, axis, coarsest) > LevelTolerance;
    }
  }
  InputLevels input;
  if (ranks.Any(differ) && !FitOneGrid(blocks, ranks))
  {
    RejectPoints(
      reading, "The input has several levels (AMR), whose points are not centres of nested cells");
    input = SortByLevels(std::move(blocks), coarsest, ranks);
  }
  else
  {
    input.Levels.push_back(FindInputBlocks(std::move(collected), ranks));
  }
  input.Reading = reading;
  return input;
}

InputLevels FindNeighbourLevels(
  CollectedBlocks collected, const std::array<int, 6>& faces, Ranks& ranks)
{
  RejectPoints(collected.Reading, "Face neighbours require boxes of cells");
  InputLevels input;
  input.Levels.push_back(FindNeighbourBlocks(std::move(collected.Blocks), faces, ranks));
  input.Reading = collected.Reading;
  return input;
}

InputLevels FindLevels(
  CollectedBlocks collected, const std::optional<std::array<int, 6>>& faces, Ranks& ranks)
{
  const Index count = SumOverRanks(faces ? 1 : 0, ranks);
  if (count > 0 && count < ranks.Count())
  {
    throw InputError("Only " + std::to_string(count) + " of " + std::to_string(ranks.Count()) +
      " ranks name their face neighbours. All ranks must, or no rank.");
  }
  return faces ? FindNeighbourLevels(std::move(collected), *faces, ranks)
               : FindInputLevels(std::move(collected), ranks);
}

void CheckCover(const InputLevels& input, const IndexBox& box)
{
  if (input.Finest() == 0 || box.NumberOfCells() == 0)
  {
    return;
  }
  const LevelCover base(input, 0, box);
  ForCells(box,
    [&](const Index3& cell)
    {
      if (!base.Has(cell))
      {
        throw InputError("The blocks leave a gap: " + TextOf(input, 0, cell) +
          " is in no block. All levels together must fill a box.");
      }
    });
  for (int level = 0; level < input.Finest(); ++level)
  {
    const LevelCover finer(input, level + 1, ChangeLevel(box, level + 1));
    ForCells(ChangeLevel(box, level),
      [&](const Index3& cell)
      {
        int covered = 0;
        for (int c = 0; c < 8; ++c)
        {
          covered += finer.Has(ChildOfCell(cell, c));
        }
        if (covered > 0 && covered < 8)
        {
          throw InputError("Finer blocks cover only a part of " + TextOf(input, level, cell) +
            ". Blocks of a refined grid (AMR) must cover whole cells of the level before, and "
            "leave no gap.");
        }
      });
  }
}

} // namespace vfm
