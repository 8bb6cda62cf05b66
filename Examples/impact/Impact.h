/**
 * Impact: a ball strikes a plate at an angle and breaks, after the demonstration of Sculptor (Owen
 * et al., SAND report 2010, figure 18): apart, in contact, breaking, fragments. Geometry, materials
 * and speed are this example's own.
 *
 * What is modelled: a ball of brittle aluminium and a plate of hard steel, elastic-plastic with an
 * equation of state and failure (MaterialPoints.h), on a uniform grid with open boundaries; they
 * touch with friction (Solver.h). The plate is free at its edges. Hugoniots and elastic constants
 * are rounded handbook values of aluminium 2024 and of steel; yield stresses, failure strains,
 * spall stresses and melt energies are of the right size, fitted to no experiment. The ball is weak
 * along the faces of a Voronoi diagram with grains of a millimetre, chosen so that its pieces are
 * large enough for this grid.
 *
 * What is not: strain rate, heat conduction, melting or vapour beyond the loss of strength,
 * gravity, contact of a body with itself (pieces of one body that meet again share one velocity,
 * but rubble does not pull). Cracks are as wide as two or three cells, and films that stretch to
 * less than a cell tear where the points run out; so how many pieces there are depends on the cell
 * size. Good for looking at meshes of fragments, not for predicting one.
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
  /// Collective. Throws std::invalid_argument on all ranks when the ranks are too many.
  Impact(MPI_Comm communicator, const Options& options);

  /// Collective: all steps. Every sink takes the start, each output step and the end. Rank 0 prints
  /// a line for each.
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
