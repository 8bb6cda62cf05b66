/**
 * FractionSum: fractions of cells summed up, each with a share: what means of cells hold, and which label they give.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// The part of a material in a list in the order of materials, added with 0 where it has none.
inline FractionField::Part& PartOf(std::vector<FractionField::Part>& parts, int material)
{
  auto at = parts.begin();
  while (at != parts.end() && at->Material < material)
  {
    ++at;
  }
  return at != parts.end() && at->Material == material ? *at : *parts.insert(at, { material, 0.0 });
}

class FractionSum
{
public:
  void Clear() { this->List.clear(); }
  /// Adds a share of what a cell holds. Every material is summed in the order of the calls.
  void Add(const FractionField& fractions, Index cell, double share);
  void Divide(double by);

  /// In the order of their materials.
  FractionField::Range Parts() const { return this->List; }
  double Fraction(int material) const;
  int Material(double isoValue) const { return MaterialOfParts(this->List, isoValue); }

private:
  std::vector<FractionField::Part> List;
};

/// The mean of a box of cells, weighted by volumes; of one cell its own fractions, bit for bit.
FractionSum MeanOfCells(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& cells);

} // namespace vfm
