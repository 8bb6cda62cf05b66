/**
 * SparseCells: the materials in the cells of a box as they are sent to another rank. A cell filled by one material
 * or by void is a label; any other has a list of the materials of which its arrays hold something, whatever the
 * number is: the receiver checks the values, so that it finds what a rank with the arrays would find.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Ranks/Ranks.h"

namespace vfm
{

struct SparseCells
{
  IndexBox Box;                   ///< global indices
  std::vector<int> Entry;         ///< of each cell, x fastest: label >= 0, or ~(index of its list)
  std::vector<Index> Offset{ 0 }; ///< lists + 1
  std::vector<int> Material;      ///< of the items of all lists
  std::vector<double> Value;      ///< their fractions as read

  Index CellId(const Index3& cell) const { return IndexInBox(this->Box, cell); }
  /// Appends the next cell; items: its materials with their fractions, { Material, Value }, in order.
  template <class Item>
  void AddCell(const std::vector<Item>& items);
  bool IsListed(Index cell) const { return this->Entry[cell] < 0; }
  /// The fraction of a material in a cell of the box.
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

/// One message of any number of boxes.
Bytes PackCells(const std::vector<SparseCells>& boxes);
std::vector<SparseCells> UnpackCells(const Bytes& bytes);

} // namespace vfm
