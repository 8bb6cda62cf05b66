/**
 * VolumeFractions: computes the volume fraction and the state of each body in each cell.
 *
 * Each point covers an axis-aligned box of its current volume and contributes the exact overlap to
 * each cell. For rubble that has expanded, the box grows but the volume of material in it does not,
 * so that the fraction falls below 1. Where the material has rotated or sheared, boxes overlap or
 * leave gaps, and the sum in a full cell differs from 1 by a few percent. Two steps correct this:
 * - The excess above 1 moves to neighbours with free volume. The volume is conserved.
 * - A cell above 0.8 is filled if its six neighbours also exceed 0.8. This adds the volume of gaps.
 * Any excess that remains is clipped. The sum is therefore 1 inside a body and never exceeds 1,
 * except for rounding.
 *
 * The state of a body consists of means weighted by mass of all quantities of its points except the
 * velocity gradient. It moves with the volume, so that mass always has some volume. The specific
 * energy is the internal energy plus the kinetic energy that the mean velocity does not contain.
 * The ratio is the volume over the volume at rest, without the void in rubble.
 */
#pragma once

#include "Domain.h"
#include "Fields.h"

namespace impact
{

class VolumeFractions
{
public:
  VolumeFractions(const Domain& domain, bool withState);

  /// Computes the fields.
  /// @return fields whose arrays belong to this object and are valid until the next call
  /// @pre Collective
  const Fields& Compute(const std::vector<MaterialPoint>& points, std::int64_t step, double time);

private:
  void Cover(const std::vector<MaterialPoint>& points);
  void Read();
  void SpreadExcess();
  void FillGaps();
  void Write();
  void WriteMeans(std::int64_t cell, std::int64_t place);
  void WriteStates(int body, std::int64_t cell, std::int64_t place);
  const double* Contents(std::int64_t cell, int body) const;
  double Volume(std::int64_t cell, int body) const { return *this->Contents(cell, body); }
  double Total(std::int64_t cell) const;
  template <class Visit>
  void ForEachNeighbour(std::int64_t cell, Visit&& visit) const;

  const Domain& Grid;
  const bool WithState;
  // Numbers of sums over points per body and cell: all, and those that move with the volume. The
  // volume itself is the first.
  const int Channels, Moved;
  Fields Result;
  std::vector<std::int64_t> Sums; // Channels values per body and cell, ghosts included
  std::vector<double> Flowing;    // Moved values per body and cell; volumes over the cell volume
  std::vector<double> Outflow;    // excess over the free volume of all neighbours, at most 1
  std::vector<double> Ball, Plate, Velocity, Density, Damage;
  std::vector<std::vector<double>> States; // all states of the ball, then of the plate
};

} // namespace impact
