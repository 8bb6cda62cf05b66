/**
 * SparseCells: the materials in a box of cells, in the form that is sent to another rank. A cell
 * filled by one material or by void is a label. Any other cell has a list of all nonzero values,
 * even invalid ones: the receiver checks them, as a rank that reads the arrays does.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

struct SparseCells
{
  IndexBox Box;                   ///< box in global indices
  std::vector<int> Entry;         ///< each cell, x fastest: label >= 0, or ~(index of its list)
  std::vector<Index> Offset{ 0 }; ///< first item of each list, and the end
  std::vector<int> Material;      ///< materials of the items of all lists
  std::vector<double> Value;      ///< fractions of the items as read

  Index CellId(const Index3& cell) const { return IndexInBox(this->Box, cell); }
  /// Appends the next cell; items: its materials and fractions, { Material, Value }, by material.
  template <class Item>
  void AddCell(const std::vector<Item>& items);
  bool IsListed(Index cell) const { return this->Entry[cell] < 0; }
  /// Returns the fraction of a material in a cell of the box.
  double Fraction(Index cell, int material) const;
};

template <class Item>
void SparseCells::AddCell(const std::vector<Item>& items)
{
  if (items.empty() || (items.size() == 1 && items[0].Value == 1.0))
  {
    this->Entry.push_back(items.empty() ? 0 : items[0].Material);
    return;
  }
  this->Entry.push_back(static_cast<int>(~(static_cast<Index>(this->Offset.size()) - 1)));
  for (const Item& item : items)
  {
    this->Material.push_back(item.Material);
    this->Value.push_back(item.Value);
  }
  this->Offset.push_back(static_cast<Index>(this->Material.size()));
}

/// Packs any number of boxes into one message.
Bytes PackCells(const std::vector<SparseCells>& boxes);
std::vector<SparseCells> UnpackCells(const Bytes& bytes);

} // namespace vfm
