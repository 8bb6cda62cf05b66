#include "Labels.h"

namespace vfm
{

int MaterialOfParts(FractionField::Range parts, double isoValue)
{
  int best = 0;
  double largest = 0.0, empty = 0.0;
  for (const FractionField::Part& part : parts)
  {
    if (part.Material == 0)
    {
      empty = part.Fraction;
    }
    else if (part.Fraction > largest)
    {
      largest = part.Fraction;
      best = part.Material;
    }
  }
  return empty > 1.0 - isoValue ? 0 : best;
}

LabelArray AssignMaterials(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue)
{
  LabelArray labels(grid.NumberOfEntries());
  const IndexBox& box = grid.Local();
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      for (Index cell = first; cell < first + box.Size(0); ++cell)
      {
        labels[cell] = fractions.IsMixed(cell) ? MaterialOfParts(fractions.Parts(cell), isoValue)
                                               : fractions.Label(cell);
      }
    }
  }
  grid.SetMirrored(labels);
  return labels;
}

std::vector<Index> FindMixedNodes(const CartesianGrid& grid, const LabelArray& labels)
{
  std::vector<Index> mixed;
  const IndexBox& box = grid.Local();
  const Index n = box.Size(0) + 2;
  const Index y = grid.Stride(1), z = grid.Stride(2);
  std::vector<unsigned char> differs(n); // of the four cells of a column along x
  for (Index k = box.Lower[2]; k <= box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j <= box.Upper[1]; ++j)
    {
      const Index first = grid.Linear({ { box.Lower[0] - 1, j, k } });
      const int* row = labels.data() + first;
      int any = 0;
      for (Index i = 0; i < n; ++i)
      {
        const int d = (row[i] ^ row[i - y]) | (row[i] ^ row[i - z]) | (row[i] ^ row[i - y - z]);
        differs[i] = d != 0;
        any |= d | (row[i] ^ row[0]);
      }
      for (Index i = 1; any && i < n; ++i)
      {
        if (differs[i] || differs[i - 1] || row[i] != row[i - 1])
        {
          mixed.push_back(first + i);
        }
      }
    }
  }
  return mixed;
}

} // namespace vfm
