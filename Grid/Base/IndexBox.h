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

/// Box of the cells with Lower <= (i,j,k) < Upper.
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
  /// Returns whether the node is a corner of a cell of the box.
  bool Touches(const Index3& node) const
  {
    bool touches = this->NumberOfCells() > 0;
    for (int a = 0; a < 3; ++a)
    {
      touches = touches && node[a] >= this->Lower[a] && node[a] <= this->Upper[a];
    }
    return touches;
  }
  /// Returns the cell of the box nearest to a cell.
  /// @pre The box has cells.
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

/// Calls body(j, k) for the rows along x of a box, y fastest; never for a box without cells.
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

/// Returns the common cells of two boxes; a box without cells if there are none.
IndexBox Intersect(const IndexBox& a, const IndexBox& b);

/// Returns the box with `layers` layers of cells around it, clipped to `limits`. A box without
/// cells is returned unchanged.
IndexBox Grow(const IndexBox& box, Index layers, const IndexBox& limits);

/// Returns the box moved by some cells along each axis. A box without cells is returned unchanged.
IndexBox Moved(const IndexBox& box, const Index3& cells);

/// Returns the box on a grid whose cells are halved `levels` times. If `levels` is negative, the
/// cells are doubled -levels times; the result holds every larger cell that overlaps the box.
IndexBox ChangeLevel(const IndexBox& box, int levels);

/// Returns the nodes of the cells of a box, as a box of node indices.
IndexBox NodesOf(const IndexBox& box);

/// Returns "cell (i, j, k)" for messages.
std::string TextOf(const Index3& cell);

/// IndexInBox returns the index of a cell in arrays over the cells of a box, x fastest. CellInBox
/// returns the cell of an index.
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

/// Returns the node at corner c of a cell.
inline Index3 CornerOfCell(const Index3& cell, int c)
{
  return { { cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2 & 1) } };
}
/// Returns cell c of the star of a node.
inline Index3 CellOfStar(const Index3& node, int c)
{
  return CornerOfCell({ { node[0] - 1, node[1] - 1, node[2] - 1 } }, c);
}
/// Returns the box of one cell.
inline IndexBox BoxOfCell(const Index3& cell)
{
  return { cell, CornerOfCell(cell, 7) };
}
/// Returns step n, 0 to 26, from a cell to the cells around it, x fastest. Step 13 is zero.
inline Index3 StepAround(int n)
{
  return { { n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 } };
}
/// Returns the cell at step n from a cell.
inline Index3 CellAround(const Index3& cell, int n)
{
  const Index3 step = StepAround(n);
  return { { cell[0] + step[0], cell[1] + step[1], cell[2] + step[2] } };
}
/// Returns child c of a cell halved along each axis. Bit a of c is set on the + side of axis a.
inline Index3 ChildOfCell(const Index3& cell, int c)
{
  return CornerOfCell({ { 2 * cell[0], 2 * cell[1], 2 * cell[2] } }, c);
}
/// Returns the parent of a cell; for a level of octants the family of a cell.
inline Index3 ParentOfCell(const Index3& cell)
{
  return { { cell[0] >> 1, cell[1] >> 1, cell[2] >> 1 } };
}

} // namespace vfm
