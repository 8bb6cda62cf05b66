#include "Input/InputBlocks.h"

#include "Base/Runtime.h"
#include "Input/BlockChecks.h"
#include "Input/FindNeighbours.h"
#include "Input/MakePartition.h"
#include "Input/NodeCoordinates.h"
#include "Ranks/Agreement.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

double FindSmallestWidth(const std::vector<InputBlock>& blocks, int axis)
{
  double least = std::numeric_limits<double>::infinity();
  for (const InputBlock& block : blocks)
  {
    const std::vector<double>& x = block.Coordinates[axis];
    for (std::size_t i = 1; i < x.size(); ++i)
    {
      least = std::min(least, x[i] - x[i - 1]);
    }
  }
  return least;
}

/// Collective. Returns the node coordinates of all blocks along an axis; close ones are merged.
std::vector<double> MergeCoordinates(const std::vector<InputBlock>& blocks, int axis, Ranks& ranks)
{
  const double width = -ranks.Max(-FindSmallestWidth(blocks, axis));
  std::vector<double> mine;
  for (const InputBlock& block : blocks)
  {
    mine.insert(mine.end(), block.Coordinates[axis].begin(), block.Coordinates[axis].end());
  }
  return MergeClose(UnionOverRanks(ranks, std::move(mine)), width);
}

/// Sets Box of the block along an axis. Returns false if another block has nodes between its nodes.
bool PlaceBlock(InputBlock& block, int axis, const std::vector<double>& global)
{
  const std::vector<double>& x = block.Coordinates[axis];
  block.Box.Lower[axis] = FindNode(global, x.front());
  block.Box.Upper[axis] = FindNode(global, x.back());
  return block.Box.Size(axis) + 1 == static_cast<Index>(x.size());
}

[[noreturn]] void RejectPlace(const InputBlock& block, int axis, const std::vector<double>& global)
{
  const std::vector<double>& x = block.Coordinates[axis];
  std::size_t i = 0; // first node that follows a node of another block
  while (
    i + 1 < x.size() && FindNode(global, x[i]) == block.Box.Lower[axis] + static_cast<Index>(i))
  {
    ++i;
  }
  std::ostringstream text;
  text << block.Name << " does not fit the other blocks along " << AxisNames[axis] << " near "
       << x[i] << ": another block has nodes between its own. All blocks must lie on one grid "
       << "with the same spacing, or be levels of a refined one (AMR).";
  throw InputError(text.str());
}

/// Collective. Finds the positions of this rank's blocks in the common grid.
InputBlocks PlaceOwnBlocks(std::vector<InputBlock> blocks, Ranks& ranks)
{
  InputBlocks input;
  input.Blocks = std::move(blocks);
  for (int axis = 0; axis < 3; ++axis)
  {
    input.Coordinates[axis] = MergeCoordinates(input.Blocks, axis, ranks);
  }
  CheckIds(input);
  const CartesianGrid grid(input.Coordinates); // throws if lengths are out of range
  WorkTogether(ranks,
    [&input]
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        for (InputBlock& block : input.Blocks)
        {
          if (!PlaceBlock(block, axis, input.Coordinates[axis]))
          {
            RejectPlace(block, axis, input.Coordinates[axis]);
          }
        }
      }
    });
  return input;
}

/// Returns the places of this rank's block and of its neighbours' blocks, ordered by rank.
std::vector<BlockPlace> FindPlacesAround(
  const IndexBox& box, const std::array<int, 6>& faces, Ranks& ranks)
{
  RankBox mine{ ranks.Rank(), {}, {} };
  for (int a = 0; a < 3; ++a)
  {
    mine.Lower[a] = static_cast<double>(box.Lower[a]);
    mine.Upper[a] = static_cast<double>(box.Upper[a]);
  }
  std::vector<BlockPlace> places{ { box, mine.Rank, -1 } };
  for (const RankBox& other : FindNeighbours(mine, faces, ranks, GhostLayers))
  {
    BlockPlace place{ {}, other.Rank, -1 };
    for (int a = 0; a < 3; ++a)
    {
      place.Box.Lower[a] = static_cast<Index>(other.Lower[a]);
      place.Box.Upper[a] = static_cast<Index>(other.Upper[a]);
    }
    places.push_back(place);
  }
  std::sort(places.begin(), places.end(),
    [](const BlockPlace& a, const BlockPlace& b) { return a.Rank < b.Rank; });
  return places;
}

/// Checks that the neighbours hold all ghost cells; places must not overlap.
void CheckGhostCells(const InputBlocks& input, int rank)
{
  const IndexBox local = Grow(input.Blocks[0].Box, GhostLayers, input.Global());
  Index missing = local.NumberOfCells();
  for (const BlockPlace& place : input.Places)
  {
    missing -= Intersect(place.Box, local).NumberOfCells();
  }
  if (missing > 0)
  {
    throw InputError("The face neighbours of rank " + std::to_string(rank) + " do not lead to " +
      std::to_string(missing) +
      " of the cells around its box. Every side of a box that is not on the side of the "
      "whole grid needs the rank across it.");
  }
}

/// Returns whether a box ends on the plane of points where another begins.
bool IsShared(const IndexBox& box, int axis, const IndexBox& other)
{
  return other.Lower[axis] == box.Upper[axis] - 1 &&
    std::max(box.Size(axis), other.Size(axis)) > 1 && Intersect(box, other).NumberOfCells() > 0;
}

/// Collective. Removes the plane of points that adjacent blocks share from the lower block.
void DropSharedPlanes(InputBlocks& input, Ranks& ranks)
{
  bool dropped = false;
  for (InputBlock& block : input.Blocks)
  {
    const IndexBox whole = block.Box;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::any_of(input.Places.begin(), input.Places.end(),
            [&](const BlockPlace& place) { return IsShared(whole, axis, place.Box); }))
      {
        --block.Kept.Upper[axis];
        --block.Box.Upper[axis];
        block.Coordinates[axis].pop_back();
        dropped = true;
      }
    }
  }
  if (ranks.Any(dropped))
  {
    input.Blocks.erase(std::remove_if(input.Blocks.begin(), input.Blocks.end(),
                         [](const InputBlock& block) { return block.Box.NumberOfCells() == 0; }),
      input.Blocks.end());
    FindPlaces({ &input, 1 }, ranks);
  }
}

} // namespace

std::string NameBlock(int number, int rank, bool isAlone)
{
  const std::string name = number < 0 ? "The input" : "Block " + std::to_string(number);
  return isAlone ? name : name + " of rank " + std::to_string(rank);
}

void CheckCoordinates(const InputBlock& block)
{
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = block.Coordinates[a];
    if (x.size() < 2)
    {
      throw InputError(block.Name + " is flat: it has no cells along " + AxisNames[a] +
        ". Volume fractions on a 3D grid of cells are needed.");
    }
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      if (!std::isfinite(x[i]) || (i > 0 && !(x[i] > x[i - 1])))
      {
        std::ostringstream text;
        text << block.Name << ": the " << AxisNames[a]
             << " coordinates do not increase or are not finite at node " << i << " (" << x[i]
             << ").";
        if (i > 0 && x[i] == x[i - 1])
        {
          text << " Nodes " << i - 1 << " and " << i
               << " are equal. If the origin is far away, move it to the grid: coordinates are "
                  "rounded to 16 digits.";
        }
        throw InputError(text.str());
      }
    }
  }
}

void KeepAllCells(InputBlock& block)
{
  for (int a = 0; a < 3; ++a)
  {
    block.Dimensions[a] = static_cast<Index>(block.Coordinates[a].size()) - 1;
  }
  block.Kept = { {}, block.Dimensions };
}

void FinishBlock(InputBlock& block, int number, const Ranks& ranks)
{
  block.Number = number;
  block.Name = NameBlock(number, ranks.Rank(), ranks.Count() == 1);
  CheckCoordinates(block);
  KeepAllCells(block);
}

bool FitOneGrid(std::vector<InputBlock> blocks, Ranks& ranks)
{
  bool fit = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> global = MergeCoordinates(blocks, axis, ranks);
    for (InputBlock& block : blocks)
    {
      fit = PlaceBlock(block, axis, global) && fit;
    }
  }
  return !ranks.Any(!fit);
}

InputBlocks FindInputBlocks(CollectedBlocks collected, Ranks& ranks)
{
  InputBlocks input = PlaceOwnBlocks(std::move(collected.Blocks), ranks);
  FindPlaces({ &input, 1 }, ranks);
  if (collected.Reading.ArePoints)
  {
    DropSharedPlanes(input, ranks);
  }
  CheckOverlaps({ &input, 1 }, ranks);
  CheckGaps(input, ranks);
  return input;
}

InputBlocks FindNeighbourBlocks(
  std::vector<InputBlock> blocks, const std::array<int, 6>& faces, Ranks& ranks)
{
  InputBlocks input = PlaceOwnBlocks(std::move(blocks), ranks);
  WorkTogether(ranks,
    [&]
    {
      if (input.Blocks.size() != 1)
      {
        throw InputError("Rank " + std::to_string(ranks.Rank()) + " has " +
          std::to_string(input.Blocks.size()) +
          " blocks. With face neighbours every rank must have one.");
      }
    });
  input.Places = FindPlacesAround(input.Blocks[0].Box, faces, ranks);
  WorkTogether(ranks,
    [&]
    {
      CheckOverlaps(input.Places, ranks.Count() == 1);
      CheckGhostCells(input, ranks.Rank());
    });
  return input;
}

} // namespace vfm
