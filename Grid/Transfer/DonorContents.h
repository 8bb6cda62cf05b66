/**
 * What donors hold at first: the contents of their cells, and of cells near them whose material has no donor of its own.
 */
#pragma once

#include "Base/WideSum.h"
#include "Transfer/MismatchCells.h"
#include "Transfer/StateColumns.h"

namespace vfm
{

/// Cells from one that gives to what takes: material around a piece of the mesh, always; sprays and regions without a mesh, if asked for.
constexpr int RimReach = 1, GivingReach = 3;

/// What the cells hold, as all steps want it.
class StateSource
{
public:
  StateSource(const TransferRequest& request, const StateColumns& columns,
    const std::vector<unsigned char>& isMeshed) :
    Request(request), Columns(columns), IsMeshed(isMeshed)
  {
  }
  /// The values of all columns in a cell that holds some of a material.
  void Read(const Index3& cell, int material, double* values) const;
  /// Whether totals speak of a material: void only where it is meshed.
  bool Counts(int material) const { return material > 0 || this->IsMeshed[0]; }

  const TransferRequest& Request;
  const StateColumns& Columns;
  const std::vector<unsigned char>& IsMeshed; ///< by material
};

/// Totals by material.
class MaterialSums
{
public:
  MaterialSums(int materials, const StateColumns& columns);
  void Add(int material, double volume, const double* values);
  /// Over all ranks, of each material. Collective.
  std::vector<StateTotals> Finish(Ranks& ranks);

private:
  const StateColumns& Columns;
  int Width;
  std::vector<WideSum> Sums;
  std::vector<double> Contents;
};

/// The values of all donors, by donor.
class DonorValues
{
public:
  DonorValues(int donors, const StateColumns& columns) :
    Width(columns.Count()), Values(static_cast<std::size_t>(donors) * columns.Count(), 0.0)
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

/// Fills the volumes and values of owned donors. input, unmeshed: get all that owned cells hold, and what no donor takes of it. Collective.
DonorValues FillDonors(const StateSource& source, const WholeElements& whole,
  const Partition& partition, DonorTable& donors, MaterialSums& input, MaterialSums& unmeshed);

} // namespace vfm
