#include "RankFields.h"

namespace vfm
{
namespace testing
{

void CutBox(const IndexBox& box, int parts, int axis, std::vector<IndexBox>& boxes)
{
  if (parts == 1)
  {
    boxes.push_back(box);
    return;
  }
  int a = axis;
  for (int b = 0; axis < 0 && b < 3; ++b)
  {
    a = a < 0 || box.Size(b) > box.Size(a) ? b : a;
  }
  const int first = parts / 2;
  IndexBox low = box, high = box;
  low.Upper[a] = high.Lower[a] =
    box.Lower[a] + std::min(box.Size(a), (box.Size(a) * first + parts - 1) / parts);
  CutBox(low, first, axis, boxes);
  CutBox(high, parts - first, axis, boxes);
}

FractionField CopyToLocal(
  const CartesianGrid& whole, const FractionField& from, const CartesianGrid& grid)
{
  FractionField field(grid, from.NumberOfMaterials());
  const IndexBox& box = grid.Local();
  Index3 p;
  for (p[2] = box.Lower[2]; p[2] < box.Upper[2]; ++p[2])
  {
    for (p[1] = box.Lower[1]; p[1] < box.Upper[1]; ++p[1])
    {
      for (p[0] = box.Lower[0]; p[0] < box.Upper[0]; ++p[0])
      {
        const Index source = whole.Linear(p), cell = grid.Linear(p);
        if (from.IsMixed(source))
        {
          field.CopyParts(cell, from.Parts(source));
        }
        else
        {
          field.SetLabel(cell, from.Label(source));
        }
      }
    }
  }
  return field;
}

} // namespace testing
} // namespace vfm
