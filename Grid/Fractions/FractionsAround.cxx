#include "Fractions/FractionsAround.h"

namespace vfm
{
namespace
{

/// Calls body(first) for the nine rows of three cells around a cell, with their first cells.
template <class Body>
void ForRowsAround(const CartesianGrid& grid, Index cell, const Body& body)
{
  for (int row = 0; row < 9; ++row)
  {
    body(cell - 1 + (row % 3 - 1) * grid.Stride(1) + (row / 3 - 1) * grid.Stride(2));
  }
}

} // namespace

FractionsAround::FractionsAround(
  const CartesianGrid& grid, const FractionField& fractions, const std::vector<Index>& cells) :
  Offset(1, 0)
{
  PagedArray<int> numbers(grid, 0); // of the cells that are copied, from 1
  for (Index cell : cells)
  {
    ForRowsAround(grid, cell,
      [&](Index first)
      {
        for (Index n = first; n < first + 3; ++n)
        {
          numbers.Set(n, 1);
        }
      });
  }
  this->CopyParts(grid, fractions, numbers);
  this->First.reserve(9 * cells.size());
  for (Index cell : cells)
  {
    ForRowsAround(grid, cell, [&](Index first) { this->First.push_back(numbers[first] - 1); });
  }
}

/// Copies the parts of marked cells, row by row.
/// @param[in,out] numbers  1 in marked cells, which become the numbers of cells from 1
void FractionsAround::CopyParts(
  const CartesianGrid& grid, const FractionField& fractions, PagedArray<int>& numbers)
{
  const IndexBox& box = grid.Local();
  const Index count = box.Size(0) + 2;
  ForRows(IndexBox{ CellOfStar(box.Lower, 0), CornerOfCell(box.Upper, 7) },
    [&](Index j, Index k)
    {
      const Index3 start{ { box.Lower[0], j, k } };
      const Index row = grid.Linear(start) - 1, source = grid.Linear(box.Nearest(start)) - 1;
      for (Index i = 0; i < count; ++i)
      {
        if (numbers[row + i] != 0)
        {
          fractions.ForParts(source + std::min(std::max<Index>(i, 1), count - 2),
            [&](int material, double fraction) {
              this->Parts.push_back({ material, fraction });
            });
          numbers.Set(row + i, static_cast<int>(this->Offset.size()));
          this->Offset.push_back(static_cast<Index>(this->Parts.size()));
        }
      }
    });
}

} // namespace vfm
