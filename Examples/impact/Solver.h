/**
 * Solver: moves the points through a time step by the material-point method.
 *
 * Explicit MLS-MPM (Hu et al. 2018) with APIC transfers (Jiang et al. 2015) and quadratic
 * B-splines. The nodes of the background grid are the centres of the cells, so a point reaches the
 * 27 cells around it and one ghost layer suffices. Each body has a velocity of its own in each
 * cell; where both meet they exchange momentum along the normal and by Coulomb friction (after
 * Bardenhagen et al. 2000). Sums over points are integers of 64 bits: they depend neither on the
 * order of the points nor on the ranks.
 */
#pragma once

#include "PointTotals.h"

namespace impact
{

class Solver
{
public:
  /// points: those whose cell this rank owns. largestSpeed: of any point at the start, for the time
  /// step.
  Solver(const Domain& domain, std::vector<MaterialPoint> points, double largestSpeed);

  /// Collective. Throws std::overflow_error, maybe on one rank alone, when a point moves by more
  /// than a cell: the others wait for it, so that nothing is left but to abort.
  void Step();

  double GetTimeStep() const { return this->TimeStep; }
  const std::vector<MaterialPoint>& GetPoints() const { return this->Points; }
  /// Collective: of each body over all ranks, the same on any number of them.
  std::array<Totals, NumberOfBodies> TotalsInside() const;
  /// Of the points that left the grid, as they were then.
  std::array<Totals, NumberOfBodies> TotalsOutside() const;

private:
  struct Weights;
  void Scatter();
  void UpdateGrid();
  void Touch(const std::int64_t* sums, double* velocities) const;
  void Gather();

  const Domain& Grid;
  std::vector<MaterialPoint> Points;
  double TimeStep, MassQuantum, MomentumQuantum;
  std::vector<std::int64_t> Sums; // Channels a cell: mass and momentum of each body, normal
  std::vector<double> Velocities; // 3 a cell and body
  PointTotals Lost;               // of this rank
};

} // namespace impact
