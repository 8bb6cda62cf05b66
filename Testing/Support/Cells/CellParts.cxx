#include "Cells/CellParts.h"

#include <cstdlib>

namespace vfm
{
namespace testing
{

int CountCellParts(const CartesianGrid& grid, Joins joins, const std::function<bool(Index)>& isIn)
{
  std::vector<unsigned char> seen(grid.NumberOfEntries(), 0);
  int count = 0;
  ForCells(grid.Global(),
    [&](const Index3& first)
    {
      std::vector<Index3> open;
      const auto visit = [&](const Index3& p)
      {
        if (grid.InDomain(p) && !seen[grid.Linear(p)] && isIn(grid.Linear(p)))
        {
          seen[grid.Linear(p)] = 1;
          open.push_back(p);
        }
      };
      visit(first);
      count += !open.empty();
      while (!open.empty())
      {
        const Index3 p = open.back();
        open.pop_back();
        for (int n = 0; n < 27; ++n)
        {
          const Index3 s = StepAround(n);
          if (joins != Joins::Faces || std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]) == 1)
          {
            visit(CellAround(p, n));
          }
        }
      }
    });
  return count;
}

} // namespace testing
} // namespace vfm
