/**
 * Solver: advances the points by a time step with the material-point method.
 *
 * The method is explicit MLS-MPM (Hu et al. 2018) with APIC transfers (Jiang et al. 2015) and
 * quadratic B-splines. The nodes of the background grid are the cell centres. A point therefore
 * contributes to the 27 cells around it, and one ghost layer is enough. Each body has its own
 * velocity in each cell. Where both bodies meet, they exchange momentum along the normal and by
 * Coulomb friction (after Bardenhagen et al. 2000). Sums over points are 64-bit integers and do not
 * depend on the order of the points or the number of ranks.
 */
#pragma once

#include "PointTotals.h"

namespace impact
{

class Solver
{
public:
  /// @param[in] points  points in the cells that this rank owns
  /// @param[in] largestSpeed  maximum initial speed of all points, km/s; limits the time step
  Solver(const Domain& domain, std::vector<MaterialPoint> points, double largestSpeed);

  /// Advances all points by one time step.
  /// @throws std::overflow_error  if a point moves by more than a cell; possibly on only one rank.
  ///   The other ranks then wait in MPI calls, and the caller must abort.
  /// @pre Collective
  void Step();

  double GetTimeStep() const { return this->TimeStep; }
  const std::vector<MaterialPoint>& GetPoints() const { return this->Points; }
  /// Returns the totals of each body over all ranks; they do not depend on the number of ranks.
  /// @pre Collective
  std::array<Totals, NumberOfBodies> TotalsInside() const;
  /// Returns the totals of the points that left the grid, in their state at that time.
  /// @pre Collective
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
  std::vector<std::int64_t> Sums; // Channels per cell: mass and momentum of each body, normal
  std::vector<double> Velocities; // 3 components per cell and body
  PointTotals Lost;               // totals of points that left the grid on this rank
};

} // namespace impact
