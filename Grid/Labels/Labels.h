/**
 * Labels: one label per cell, the material that it is meshed as; 0 is void. The array has the shape
 * of the cells of CartesianGrid; its outer layer mirrors the cells inside.
 */
#pragma once

#include "Base/Partition.h"
#include "Fractions/FractionField.h"

namespace vfm
{

using LabelArray = PagedArray<int>;

/// Returns the labels of all cells of the local box (MaterialOfCell).
LabelArray AssignMaterials(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue);

/// Returns whether elements are made of a label; false for -1, which means that there is no label.
inline bool IsMeshed(int label, bool meshVoid)
{
  return label > 0 || (label == 0 && meshVoid);
}

/// Returns the eight labels around a node.
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

inline bool IsMixedStar(const std::array<int, 8>& star)
{
  return std::any_of(star.begin(), star.end(), [&](int label) { return label != star[0]; });
}

/// Returns the nodes of the local box with more than one label around them, ascending.
std::vector<Index> FindMixedNodes(const CartesianGrid& grid, const LabelArray& labels);

} // namespace vfm
