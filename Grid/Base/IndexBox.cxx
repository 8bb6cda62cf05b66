#include "Base/IndexBox.h"

namespace vfm
{

IndexBox Intersect(const IndexBox& a, const IndexBox& b)
{
  IndexBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box.Lower[axis] = std::max(a.Lower[axis], b.Lower[axis]);
    box.Upper[axis] = std::max(std::min(a.Upper[axis], b.Upper[axis]), box.Lower[axis]);
  }
  return box;
}

IndexBox Grow(const IndexBox& box, Index layers, const IndexBox& limits)
{
  IndexBox grown = box;
  for (int a = 0; box.NumberOfCells() > 0 && a < 3; ++a)
  {
    grown.Lower[a] = std::max(box.Lower[a] - layers, limits.Lower[a]);
    grown.Upper[a] = std::min(box.Upper[a] + layers, limits.Upper[a]);
  }
  return grown;
}

IndexBox Moved(const IndexBox& box, const Index3& cells)
{
  IndexBox moved = box;
  for (int a = 0; box.NumberOfCells() > 0 && a < 3; ++a)
  {
    moved.Lower[a] += cells[a];
    moved.Upper[a] += cells[a];
  }
  return moved;
}

IndexBox ChangeLevel(const IndexBox& box, int levels)
{
  IndexBox result;
  const Index factor = Index(1) << (levels < 0 ? -levels : levels);
  for (int a = 0; a < 3; ++a)
  {
    result.Lower[a] = levels < 0 ? box.Lower[a] >> -levels : box.Lower[a] * factor;
    result.Upper[a] = levels < 0 ? (box.Upper[a] + factor - 1) >> -levels : box.Upper[a] * factor;
  }
  return result;
}

IndexBox NodesOf(const IndexBox& box)
{
  return box.NumberOfCells() > 0 ? IndexBox{ box.Lower, CornerOfCell(box.Upper, 7) } : IndexBox();
}

std::string TextOf(const Index3& cell)
{
  return "cell (" + std::to_string(cell[0]) + ", " + std::to_string(cell[1]) + ", " +
    std::to_string(cell[2]) + ")";
}

} // namespace vfm
