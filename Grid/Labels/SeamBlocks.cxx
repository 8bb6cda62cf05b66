#include "Labels/SeamBlocks.h"

namespace vfm
{

IndexBox BlockOfCell(const CartesianGrid& grid, const Index3& cell)
{
  IndexBox block = BoxOfCell(cell);
  const int below = grid.FlatSeams(block.Lower), above = grid.FlatSeams(block.Upper);
  for (int a = 0; a < 3; ++a)
  {
    block.Lower[a] -= below >> a & 1;
    block.Upper[a] += above >> a & 1;
  }
  return block;
}

int FindGluedAxes(const CartesianGrid& grid, const LabelArray& labels, const IndexBox& block)
{
  int axes = 0;
  for (int a = 0; a < 3; ++a)
  {
    bool isGlued = block.Size(a) > 1;
    IndexBox lower = block;
    lower.Upper[a] = isGlued ? block.Lower[a] + 1 : block.Lower[a];
    ForCells(lower,
      [&](const Index3& cell)
      {
        const Index at = grid.Linear(cell);
        isGlued = isGlued && labels[at] == labels[at + grid.Stride(a)];
      });
    axes |= isGlued << a;
  }
  return axes;
}

IndexBox PartOfBlock(const IndexBox& block, int axes, const Index3& cell)
{
  IndexBox part = BoxOfCell(cell);
  for (int a = 0; a < 3; ++a)
  {
    if (axes >> a & 1)
    {
      part.Lower[a] = block.Lower[a];
      part.Upper[a] = block.Upper[a];
    }
  }
  return part;
}

} // namespace vfm
