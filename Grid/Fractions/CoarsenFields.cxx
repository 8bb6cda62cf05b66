#include "Fractions/CoarsenFields.h"

#include "Fractions/RefineCells.h"
#include "Fractions/ResampleFields.h"

namespace vfm
{

CartesianGrid CoarsenGrid(const CartesianGrid& grid, int halvings, int ghostLayers)
{
  if (halvings == 0)
  {
    return CartesianGrid(grid, grid.Owned(), ghostLayers);
  }
  const Index factor = Index(1) << halvings;
  for (int a = 0; a < 3; ++a)
  {
    for (Index n : { grid.Domain().Lower[a], grid.Domain().Upper[a], grid.Owned().Lower[a],
           grid.Owned().Upper[a] })
    {
      if (n % factor != 0)
      {
        throw InputError("A grid of " + std::to_string(grid.Domain().Size(a)) +
          " cells along an axis, or a rank's part of it, does not consist of blocks of " +
          std::to_string(factor) + ": use fewer levels.");
      }
    }
  }
  return ChangeLevel(grid, -halvings, ghostLayers);
}

int CountCoarseGhosts(const CartesianGrid& grid, int halvings, int most)
{
  Index levels = most;
  for (int a = 0; a < 3; ++a)
  {
    const Index low = grid.Local().Lower[a], high = grid.Local().Upper[a];
    if (low > 0 || grid.Period(a) > 0)
    {
      levels = std::min(levels, (grid.Owned().Lower[a] - low) >> halvings);
    }
    if (high < grid.Global().Upper[a] || grid.Period(a) > 0)
    {
      levels = std::min(levels, (high - grid.Owned().Upper[a]) >> halvings);
    }
  }
  return static_cast<int>(levels);
}

FractionField CoarsenFractions(const CartesianGrid& grid, const FractionField& fractions,
  int halvings, const CartesianGrid& coarse, Runtime& runtime)
{
  const IndexBox& cells = coarse.Local();
  return MeanOfBlocks(
    grid, fractions, OverlapsOfBlocks(grid, halvings, coarse, cells), coarse, cells, runtime);
}

} // namespace vfm
