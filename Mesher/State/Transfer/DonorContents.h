/**
 * DonorContents: fills donors with the contents of their cells, and of nearby cells whose material
 * has no donor.
 */
#pragma once

#include "Base/WideSum.h"
#include "State/Transfer/FarContents.h"
#include "State/Transfer/MismatchCells.h"
#include "State/Transfer/StateColumns.h"

namespace vfm
{

/// Distances, in cells, over which a cell without a donor gives its contents. Material next to a
/// fragment is always given (RimReach). Unresolved material and regions without elements are given
/// if TransferRequest::GiveUnmeshed (GivingReach).
constexpr int RimReach = 1, GivingReach = 3;

/// Access to the contents of cells, for all steps of a transfer. The arguments of the constructor
/// must outlive it.
class StateSource
{
public:
  StateSource(const TransferRequest& request, const StateColumns& columns,
    const std::vector<unsigned char>& isMeshed) :
    Request(request), Columns(columns), IsMeshed(isMeshed)
  {
  }
  /// Reads the values of all columns for a material in a cell that contains it.
  void Read(const Index3& cell, int material, double* values) const;
  /// Returns whether totals include a material: void is included only if it is meshed.
  bool Counts(int material) const { return material > 0 || this->IsMeshed[0]; }

  const TransferRequest& Request;
  const StateColumns& Columns;
  const std::vector<unsigned char>& IsMeshed; ///< one flag per material
};

/// Totals per material. They do not depend on the order of additions or on ranks.
class MaterialSums
{
public:
  MaterialSums(int materials, const StateColumns& columns);
  /// Adds the contents of a volume with these values.
  void Add(int material, double volume, const double* values);
  /// Returns the totals of each material over all ranks.
  /// @pre Collective.
  std::vector<StateTotals> Finish(Ranks& ranks);

private:
  const StateColumns& Columns;
  int Width;
  std::vector<WideSum> Sums;
  std::vector<double> Contents;
};

/// Values of all columns, per donor, and zeros up to StateColumns::Width().
class DonorValues
{
public:
  DonorValues(int donors, const StateColumns& columns) :
    Width(columns.Width()), Values(static_cast<std::size_t>(donors) * columns.Width(), 0.0)
  {
  }
  double* Of(int donor)
  {
    return this->Values.data() + static_cast<std::size_t>(donor) * this->Width;
  }
  const double* Of(int donor) const
  {
    return this->Values.data() + static_cast<std::size_t>(donor) * this->Width;
  }

private:
  int Width;
  std::vector<double> Values;
};

/// Fills the volumes and values of the owned donors from the owned cells.
/// @param donors  all donors that exist, copies too, with overlaps
/// @param input  gets the contents of all owned cells
/// @param unmeshed  gets the contents of owned cells that no donor or whole element takes
/// @param far  gets those that become particles instead
/// @return values of all donors; only owned ones are set
/// @pre Collective.
DonorValues FillDonors(const StateSource& source, const WholeElements& whole,
  const Partition& partition, DonorTable& donors, MaterialSums& input, MaterialSums& unmeshed,
  FarContents& far);

} // namespace vfm
