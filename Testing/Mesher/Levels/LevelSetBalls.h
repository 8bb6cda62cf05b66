/**
 * LevelSetBalls: blocks with level sets of a ball and of a film around it.
 */
#pragma once

#include "../Input/BlockPieces.h"
#include "Input/FindNeighbours.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "RankFields.h"

#include <cmath>
#include <functional>

namespace vfm::testing
{

constexpr Index CellsOfBalls = 20;
constexpr double WidthOfBalls = 2.0 / CellsOfBalls;

inline double Distance(const Index3& cell, double radius)
{
  double sum = 0.0;
  for (Index i : cell)
  {
    const double x = -1.0 + WidthOfBalls * (static_cast<double>(i) + 0.5);
    sum += x * x;
  }
  return std::sqrt(sum) - radius;
}

/// Returns a block of cells of [-1, 1]^3 with level sets of balls that wrap each other.
/// @param scale  factor of all values
/// @param film  outer radius of the film
inline InputBlock MakeBlock(const IndexBox& box, int number, double scale, double film)
{
  InputBlock block;
  block.Number = number;
  block.Name = NameBlock(number, 0, true);
  for (int a = 0; a < 3; ++a)
  {
    block.Coordinates[a] =
      EvenNodes(-1.0, WidthOfBalls, static_cast<int>(box.Lower[a]), static_cast<int>(box.Upper[a]));
  }
  KeepAllCells(block);
  const auto arrays = std::make_shared<PlainArrays>(box.NumberOfCells());
  for (const auto& [name, radius] : { std::pair("ball", 0.6), { "film", film } })
  {
    Buffer<double> values(box.NumberOfCells());
    ForCells(box,
      [&](const Index3& cell) { values[IndexInBox(box, cell)] = scale * Distance(cell, radius); });
    arrays->Store(name, ValueType::Double, std::move(values));
  }
  block.Arrays = arrays;
  return block;
}

inline InputLevels MakeInput(
  const std::vector<IndexBox>& boxes, Ranks& ranks, double scale = 1.0, double film = 0.63)
{
  CollectedBlocks collected;
  for (const IndexBox& box : boxes)
  {
    collected.Blocks.push_back(
      MakeBlock(box, static_cast<int>(collected.Blocks.size()), scale, film));
  }
  return FindInputLevels(std::move(collected), ranks);
}

inline const IndexBox All{ {}, { { CellsOfBalls, CellsOfBalls, CellsOfBalls } } };

inline std::string ErrorOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

} // namespace vfm::testing
