/**
 * Indices (i,j,k) of cells and nodes, and boxes of cells.
 *
 * Corners of a cell and cells of a node are numbered by bits, x first: c = cx + 2 cy + 4 cz.
 */
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vfm
{

using Index = std::int64_t;
using Index3 = std::array<Index, 3>;
using Vector3 = std::array<double, 3>;

/// Cells with Lower <= (i,j,k) < Upper.
struct IndexBox
{
  Index3 Lower{ { 0, 0, 0 } };
  Index3 Upper{ { 0, 0, 0 } };

  Index Size(int axis) const { return this->Upper[axis] - this->Lower[axis]; }
  Index NumberOfCells() const { return this->Size(0) * this->Size(1) * this->Size(2); }
  bool operator==(const IndexBox& other) const
  {
    return this->Lower == other.Lower && this->Upper == other.Upper;
  }
  bool Contains(const Index3& c) const
  {
    for (int a = 0; a < 3; ++a)
    {
      if (c[a] < this->Lower[a] || c[a] >= this->Upper[a])
      {
        return false;
      }
    }
    return true;
  }
  /// Whether one of the cells has the node as a corner.
  bool Touches(const Index3& node) const
  {
    bool touches = this->NumberOfCells() > 0;
    for (int a = 0; a < 3; ++a)
    {
      touches = touches && node[a] >= this->Lower[a] && node[a] <= this->Upper[a];
    }
    return touches;
  }
  /// The cell of the box that a cell is or, from beside the box, the nearest; not of a box without cells.
  Index3 Nearest(const Index3& cell) const
  {
    Index3 nearest;
    for (int a = 0; a < 3; ++a)
    {
      nearest[a] = std::min(std::max(cell[a], this->Lower[a]), this->Upper[a] - 1);
    }
    return nearest;
  }
};

/// Calls body(j, k) for the rows along x of a box with cells, y fastest.
template <class Body>
void ForRows(const IndexBox& box, const Body& body)
{
  for (Index k = box.Lower[2]; box.Size(0) > 0 && k < box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
    {
      body(j, k);
    }
  }
}

/// Calls body(position) for the cells of a box, x fastest.
template <class Body>
void ForCells(const IndexBox& box, const Body& body)
{
  Index3 p;
  for (p[2] = box.Lower[2]; p[2] < box.Upper[2]; ++p[2])
  {
    for (p[1] = box.Lower[1]; p[1] < box.Upper[1]; ++p[1])
    {
      for (p[0] = box.Lower[0]; p[0] < box.Upper[0]; ++p[0])
      {
        body(static_cast<const Index3&>(p));
      }
    }
  }
}

/// The cells that both boxes hold; a box without cells where there is none.
IndexBox Intersect(const IndexBox& a, const IndexBox& b);

/// The box and that many layers of cells around it, cut at the limits. A box without cells gets none.
IndexBox Grow(const IndexBox& box, Index layers, const IndexBox& limits);

/// The cells of a box, halved so many times; negative: the larger cells of which it holds a part.
IndexBox ChangeLevel(const IndexBox& box, int levels);

/// The nodes of the cells of a box, each by the cell above it.
IndexBox NodesOf(const IndexBox& box);

/// For messages.
std::string TextOf(const Index3& cell);

/// The index of a cell in arrays over the cells of a box, x fastest, and the cell with an index.
inline Index IndexInBox(const IndexBox& box, const Index3& cell)
{
  return ((cell[2] - box.Lower[2]) * box.Size(1) + cell[1] - box.Lower[1]) * box.Size(0) + cell[0] -
    box.Lower[0];
}
inline Index3 CellInBox(const IndexBox& box, Index index)
{
  const Index nx = box.Size(0), ny = box.Size(1);
  return { { index % nx + box.Lower[0], index / nx % ny + box.Lower[1],
    index / (nx * ny) + box.Lower[2] } };
}

/// The node at corner c of a cell.
inline Index3 CornerOfCell(const Index3& cell, int c)
{
  return { { cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2 & 1) } };
}
/// Cell c of the star of a node.
inline Index3 CellOfStar(const Index3& node, int c)
{
  return CornerOfCell({ { node[0] - 1, node[1] - 1, node[2] - 1 } }, c);
}
/// The box of one cell.
inline IndexBox BoxOfCell(const Index3& cell)
{
  return { cell, CornerOfCell(cell, 7) };
}
/// The steps 0..26 from a cell to those around it, x fastest; 13 to itself.
inline Index3 StepAround(int n)
{
  return { { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 } };
}
inline Index3 CellAround(const Index3& cell, int n)
{
  const Index3 step = StepAround(n);
  return { { cell[0] + step[0], cell[1] + step[1], cell[2] + step[2] } };
}
/// Half c of a cell along each axis: bit a set on the + side of axis a.
inline Index3 ChildOfCell(const Index3& cell, int c)
{
  return CornerOfCell({ { 2 * cell[0], 2 * cell[1], 2 * cell[2] } }, c);
}
/// The cell that a cell is a half of; of a level of octants the family of a cell.
inline Index3 ParentOfCell(const Index3& cell)
{
  return { { cell[0] >> 1, cell[1] >> 1, cell[2] >> 1 } };
}

} // namespace vfm
