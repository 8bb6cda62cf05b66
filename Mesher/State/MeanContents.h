/**
 * MeanContents: the state of each material in cells that replace several cells, as means weighted
 * by volume or mass of the material, so that sums are conserved.
 */
#pragma once

#include "State/InputContents.h"

namespace vfm
{

/// Sums over the cells that one cell replaces, by material. They depend on the order of the calls.
class ContentSums
{
public:
  /// Adds a material of a cell, or of a part of it.
  /// @param volume volume of the material
  /// @param values as InputContents reads them
  void Add(const InputContents& contents, int material, double volume, const double* values);

  bool IsEmpty() const { return this->Items.empty(); }

private:
  friend class MeanContents;

  struct Item
  {
    int Material;
    double Volume = 0.0;
    std::vector<double> Weights;         // sum of weights, by column
    std::vector<double> Weighted, Plain; // sums of values times weights, and times volumes
  };

  std::vector<Item> Items;
};

/// Stores the means of cells by number.
class MeanContents
{
public:
  /// Returns the number of the cell: 0, 1, ..
  int Store(const ContentSums& sums);

  /// Reads the values of a material in the cell with a number; zeros if the cell lacks
  /// the material.
  void Read(int number, int material, int columns, double* values) const;

private:
  /// A material in a cell.
  struct Part
  {
    int Material;
    std::size_t First; // index of its first column in Values
  };

  std::vector<std::size_t> Offsets{ 0 }; // index of each number in Parts, and the end
  std::vector<Part> Parts;
  std::vector<double> Values;
};

} // namespace vfm
