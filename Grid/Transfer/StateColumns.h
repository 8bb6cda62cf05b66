/**
 * The components of all quantities of a transfer, one after another, and what each is multiplied with.
 *
 * A value is per volume, per mass, or per mass times a weight such as heat capacity. So what is conserved of it is a product along a
 * chain: volume x density x heat capacity x temperature. All that moves state, fluxes and reconstruction alike, moves volume, then
 * what is per volume, then what is per that: each a mean whose weights are what was moved before it. Means stay within bounds.
 */
#pragma once

#include "Transfer/TransferState.h"

namespace vfm
{

class StateColumns
{
public:
  StateColumns(const std::vector<StateQuantity>& quantities, int density);

  /// Those of the quantities, and a last one where these have no density: 1, so that mass is the volume that cells have.
  int Count() const { return static_cast<int>(this->Bases.size()); }
  int CountOfQuantities() const { return this->QuantityCount; }
  /// The column whose content a column is multiplied with; -1 volume.
  int Base(int column) const { return this->Bases[column]; }
  /// All columns, each after its base.
  const std::vector<int>& Order() const { return this->Sequence; }
  /// Whether another column's base, but not that of masses: constant in a cell, so that products have no more than two slopes.
  bool IsConstant(int column) const { return this->Constant[column]; }
  int Density() const { return this->DensityColumn; }

  /// What is conserved of each column in a volume with these values.
  void FindContents(double volume, const double* values, double* contents) const;

  /// Adds to a volume with these values another with others: means by what the values are per; where there is none of that (no mass) by
  /// volume.
  void Mix(double& volume, double* values, double otherVolume, const double* others) const;

private:
  std::vector<int> Bases, Sequence;
  std::vector<unsigned char> Constant;
  int QuantityCount = 0, DensityColumn = 0;
};

} // namespace vfm
