/**
 * LabelInput: images of labels as input of the mesher.
 */
#pragma once

#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "Mesher.h"

namespace vfm
{
namespace testing
{

constexpr double LabelWidth = 0.3; // of cells; coordinates are not exact

/// Returns the part of a rank of an image of labels, cut across z.
/// @param labels  of all cells, x fastest
inline MesherInput MakeLabelInput(const Index3& n, const std::vector<int>& labels, Ranks& ranks)
{
  InputBlock block;
  block.Name = "The input";
  const Index first = ranks.Rank() * n[2] / ranks.Count();
  const Index last = (ranks.Rank() + 1) * n[2] / ranks.Count();
  for (int a = 0; a < 3; ++a)
  {
    const Index begin = a == 2 ? first : 0, end = a == 2 ? last : n[a];
    for (Index i = begin; i <= end; ++i)
    {
      block.Coordinates[a].push_back(0.1 + LabelWidth * static_cast<double>(i));
    }
  }
  KeepAllCells(block);
  std::vector<int> own(labels.begin() + n[0] * n[1] * first, labels.begin() + n[0] * n[1] * last);
  auto arrays = std::make_shared<PlainArrays>(static_cast<Index>(own.size()));
  arrays->Store("labels", ValueType::Int, std::move(own));
  block.Arrays = arrays;
  CollectedBlocks collected;
  collected.Blocks.push_back(std::move(block));
  MesherInput input;
  input.Levels = FindInputLevels(std::move(collected), ranks);
  input.Arrays.Labels = "labels";
  return input;
}

} // namespace testing
} // namespace vfm
