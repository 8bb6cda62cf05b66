/**
 * VolumeFractions: from points to what a cell holds of each body.
 *
 * Each point covers an axis-aligned box with its current volume; a cell gets the exact overlap. The
 * box of rubble that has come apart grows, but the volume of material in it does not: its fraction
 * falls below 1. Where the material has turned or sheared, boxes overlap or leave gaps, so that the
 * sum in a full cell is a few percent off 1. Two steps mend that: what is above 1 flows to
 * neighbours with room (the volume is conserved), then cells that hold more than .8, as do their
 * six neighbours, are filled (it is not: the gain is that of the gaps). What is still above 1 is
 * cut. So the sum is 1 inside a body, and 1 to rounding at most.
 *
 * The state of a body, all that its points carry but their velocity gradients, are means by mass.
 * It flows along with the volume, so that no mass is without some. Specific energy is internal
 * energy and what kinetic energy the mean velocity lacks; the ratio is volume over that at rest,
 * without the void in rubble.
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

  /// Collective. The fields point into this object and stay until the next call.
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
  const int Channels,
    Moved; // of a body in a cell: those of its points, and those that flow, its volume first
  Fields Result;
  std::vector<std::int64_t> Sums; // Channels a body and cell, ghosts included
  std::vector<double> Flowing;    // Moved a body and cell; volumes over that of the cell
  std::vector<double> Outflow;    // of the excess, over the room of the receiver
  std::vector<double> Ball, Plate, Velocity, Density, Damage;
  std::vector<std::vector<double>> States; // of the first body, of the second
};

} // namespace impact
