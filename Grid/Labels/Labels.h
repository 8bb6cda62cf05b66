/**
 * One label a cell: the material it is meshed as, 0 void. The array has the shape of CartesianGrid's
 * cells, its outer layer mirrored.
 */
#pragma once

#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

using LabelArray = PagedArray<int>;

/// The labels of all cells of the local box; of a pure one its own.
LabelArray AssignMaterials(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue);

/// Whether elements are made of a label; of -1, which stands for none, never.
inline bool IsMeshed(int label, bool meshVoid)
{
  return label > 0 || (label == 0 && meshVoid);
}

/// The eight labels around a node.
inline std::array<int, 8> StarOfNode(
  const CartesianGrid& grid, const LabelArray& labels, Index node)
{
  std::array<int, 8> star;
  const Index first = grid.CellOfNode(node, 0), i = labels.InRow(first);
  for (int c = 0; c < 8; c += 2)
  {
    const LabelArray::RowView row = labels.Row(first + grid.CornerOffset(c));
    star[c] = row[i];
    star[c + 1] = row[i + 1];
  }
  return star;
}

/// The nodes of the local box with more than one label around them, ascending.
std::vector<Index> FindMixedNodes(const CartesianGrid& grid, const LabelArray& labels);

} // namespace vfm
