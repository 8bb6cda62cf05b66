/**
 * FractionSum: weighted sums of the fractions of cells, used for means and their labels.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// Returns the part of a material in a list in the order of materials; adds it with fraction 0 if
/// it is missing.
inline FractionField::Part& PartOf(std::vector<FractionField::Part>& parts, int material)
{
  auto at = parts.begin();
  while (at != parts.end() && at->Material < material)
  {
    ++at;
  }
  return at != parts.end() && at->Material == material ? *at : *parts.insert(at, { material, 0.0 });
}

/// Sum of fractions, void included.
class FractionSum
{
public:
  void Clear() { this->List.clear(); }
  /// Adds a share of the fractions of a cell. The sum of a material depends on the
  /// order of the calls.
  void Add(const FractionField& fractions, Index cell, double share);
  void Divide(double by);

  /// Returns the parts in the order of their materials.
  FractionField::Range Parts() const { return this->List; }
  double Fraction(int material) const;
  int Material(double isoValue) const { return MaterialOfParts(this->List, isoValue); }

private:
  std::vector<FractionField::Part> List;
};

/// Returns the mean of a box of cells, weighted by volume. For one cell it is bitwise identical to
/// the fractions of the cell.
FractionSum MeanOfCells(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& cells);

} // namespace vfm
