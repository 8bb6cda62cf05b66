#include "LabelInput.h"

#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"

#include <random>

namespace vfm
{
namespace testing
{

std::vector<int> RandomLabels(const Index3& cells, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<int> labels(cells[0] * cells[1] * cells[2]);
  std::generate(labels.begin(), labels.end(), [&random] { return static_cast<int>(random() % 3); });
  return labels;
}

MesherInput MakeLabelInput(const LabelGrid& grid, const std::vector<int>& labels, Ranks& ranks)
{
  InputBlock block;
  block.Name = "The input";
  const Index3& n = grid.Cells;
  const Index first = ranks.Rank() * n[2] / ranks.Count();
  const Index last = (ranks.Rank() + 1) * n[2] / ranks.Count();
  for (int a = 0; a < 3; ++a)
  {
    const Index begin = a == 2 ? first : 0, end = a == 2 ? last : n[a];
    for (Index i = begin; i <= end; ++i)
    {
      block.Coordinates[a].push_back(grid.Origin + grid.Width * static_cast<double>(i));
    }
  }
  KeepAllCells(block);
  const Index layer = n[0] * n[1];
  std::vector<int> own(labels.begin() + layer * first, labels.begin() + layer * last);
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
