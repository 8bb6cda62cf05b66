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

InputBlock MakeBlock(const IndexBox& cells, const Vector3& origin, double width,
  std::shared_ptr<const BlockArrays> arrays)
{
  InputBlock block;
  block.Name = "The input";
  block.Coordinates = EvenCoordinates(origin, { { width, width, width } }, cells);
  KeepAllCells(block);
  block.Arrays = std::move(arrays);
  return block;
}

MesherInput MakeInput(std::vector<InputBlock> blocks, Ranks& ranks)
{
  CollectedBlocks collected;
  collected.Blocks = std::move(blocks);
  MesherInput input;
  input.Levels = FindInputLevels(std::move(collected), ranks);
  return input;
}

namespace
{

InputBlock MakeLabelBlock(
  const IndexBox& cells, const LabelGrid& grid, double width, std::vector<int> labels)
{
  auto arrays = std::make_shared<PlainArrays>(static_cast<Index>(labels.size()));
  arrays->Store("labels", ValueType::Int, std::move(labels));
  return MakeBlock(cells, { { grid.Origin, grid.Origin, grid.Origin } }, width, arrays);
}

MesherInput MakeLabels(std::vector<InputBlock> blocks, Ranks& ranks)
{
  MesherInput input = MakeInput(std::move(blocks), ranks);
  input.Arrays.Labels = "labels";
  return input;
}

} // namespace

MesherInput MakeLabelInput(const LabelGrid& grid, const std::vector<int>& labels, Ranks& ranks)
{
  const Index3& n = grid.Cells;
  const Index first = ranks.Rank() * n[2] / ranks.Count();
  const Index last = (ranks.Rank() + 1) * n[2] / ranks.Count();
  const Index layer = n[0] * n[1];
  std::vector<int> own(labels.begin() + layer * first, labels.begin() + layer * last);
  return MakeLabels({ MakeLabelBlock({ { { 0, 0, first } }, { { n[0], n[1], last } } }, grid,
                      grid.Width, std::move(own)) },
    ranks);
}

MesherInput MakeLevelInput(const LabelGrid& grid, const std::vector<IndexBox>& boxes, Ranks& ranks)
{
  std::vector<InputBlock> blocks;
  const auto isMine = [&](std::size_t block)
  { return static_cast<int>(block) % ranks.Count() == ranks.Rank(); };
  if (isMine(0))
  {
    const IndexBox all{ {}, grid.Cells };
    blocks.push_back(
      MakeLabelBlock(all, grid, grid.Width, std::vector<int>(all.NumberOfCells(), 1)));
  }
  for (std::size_t b = 0; b < boxes.size(); ++b)
  {
    if (isMine(b + 1))
    {
      const IndexBox cells = ChangeLevel(boxes[b], 1);
      const Index3 size{ { cells.Size(0), cells.Size(1), cells.Size(2) } };
      blocks.push_back(MakeLabelBlock(
        cells, grid, 0.5 * grid.Width, RandomLabels(size, static_cast<unsigned>(b))));
    }
  }
  return MakeLabels(std::move(blocks), ranks);
}

} // namespace testing
} // namespace vfm
