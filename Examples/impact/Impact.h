/**
 * Impact: a ball strikes a plate at an angle and breaks, after the demonstration of Sculptor (Owen
 * et al., SAND report 2010, figure 18). The phases are the same: apart, in contact, breaking,
 * fragments. Geometry, materials and speed differ from the report.
 *
 * The model: a ball of brittle aluminium and a plate of hard steel on a uniform grid with open
 * boundaries. Both are elastic-plastic, with an equation of state and failure (MaterialPoints.h),
 * and touch with friction (Solver.h). The plate is free at its edges. Hugoniots and elastic
 * constants are rounded handbook values of aluminium 2024 and of steel. Yield stresses, failure
 * strains, spall stresses and melt energies have realistic magnitudes but are not fitted to any
 * experiment. The ball is weak along the faces of a Voronoi diagram. Its grains of 1 mm are chosen
 * so that the pieces are large enough for this grid.
 *
 * The model ignores strain rate, heat conduction and gravity. It includes the loss of strength of
 * melting material, but neither melting nor vapour otherwise. There is no contact of a body with
 * itself: pieces of one body that meet again share one velocity, although rubble transmits no
 * tension. Cracks are two or three cells wide, and a film thinner than a cell tears where it has no
 * points. The number of pieces therefore depends on the cell size. The example shows meshes of
 * fragments; it does not predict fragments.
 */
#pragma once

#include "History.h"
#include "Options.h"
#include "Solver.h"
#include "VolumeFractions.h"

namespace impact
{

class Impact
{
public:
  /// Creates the material points in their initial state.
  /// @throws std::invalid_argument  if the grid is too small for the number of ranks, on all ranks
  /// @pre Collective
  Impact(MPI_Comm communicator, const Options& options);

  /// Runs all steps. Each sink receives the initial state, each output step and the final state;
  /// rank 0 prints one line for each of them.
  /// @pre Collective
  void Run(const std::vector<Sink*>& sinks);

  const Domain& GetDomain() const { return this->Grid; }

private:
  void Report(std::int64_t step, double seconds) const;

  Domain Grid;
  Solver Motion;
  VolumeFractions Output;
  History Table;
  std::int64_t Steps, Every;
};

} // namespace impact
