/**
 * StateColumns: the components of all quantities of a transfer, as columns, and the bases that they
 * are multiplied with.
 *
 * A value is per volume, per mass, or per mass times a weight such as heat capacity. Its conserved
 * content is a product along a chain: volume x density x heat capacity x temperature. Fluxes and
 * reconstruction transfer volume first, then values per volume, then values per these. Each new
 * value is a mean, weighted by the contents transferred before it, so it stays within bounds.
 */
#pragma once

#include "State/Transfer/TransferState.h"

namespace vfm
{

/// Columns of a transfer. Does not change after construction, so threads may share it.
class StateColumns
{
public:
  /// @param density  TransferRequest::Density
  StateColumns(const std::vector<StateQuantity>& quantities, int density);

  /// Returns the number of columns: all components of the quantities. Without a density, there is
  /// one more column with the value 1, so that mass is the volume of material in cells.
  int Count() const { return static_cast<int>(this->Bases.size()); }
  /// Returns the length of lists with one number per column: Count(), rounded up to whole SIMD
  /// registers.
  int Width() const { return (this->Count() + 3) / 4 * 4; }
  /// Returns the number of components of all quantities.
  int CountOfQuantities() const { return this->QuantityCount; }
  /// Returns the base of a column, the column whose content it is multiplied with; -1 for volume.
  int Base(int column) const { return this->Bases[column]; }
  /// Returns all columns, each after its base.
  const std::vector<int>& Order() const { return this->Sequence; }
  /// Returns whether a column is the weight of a quantity. Such columns are constant in a cell, so
  /// products have at most two slopes.
  bool IsConstant(int column) const { return this->Constant[column]; }
  /// Returns the column of density.
  int Density() const { return this->DensityColumn; }

  /// Computes the conserved content of each column in a volume with these values.
  void FindContents(double volume, const double* values, double* contents) const;

  /// Adds another volume to a volume. The values become means, weighted by the contents of their
  /// bases; if these are 0, as without mass, by volume.
  void Mix(double& volume, double* values, double otherVolume, const double* others) const;

private:
  std::vector<int> Bases, Sequence;
  std::vector<unsigned char> Constant;
  int QuantityCount = 0, DensityColumn = 0;
};

} // namespace vfm
