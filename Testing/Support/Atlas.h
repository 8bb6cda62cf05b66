/**
 * A labelled image similar to a parcellation of a brain, and measures of
 * how well a mesh keeps its labels.
 */
#pragma once

#include "Elements/MeshReport.h"
#include "Fractions/FractionField.h"

namespace vfm
{
namespace testing
{

/// Returns labels of n^3 unit cells, the same on any machine. A warped ball in void has `labels`
/// labels, each with at least one cell. 40 % are cells of a weighted Voronoi diagram with rough
/// sides; small ones are nested in large ones. 25 % are rough blobs of 9 to 600 cells, 10 % are
/// sheets, the rest are chains of 1 to 8 cells. Half of the blobs and chains start on interfaces.
FractionField MakeAtlas(const CartesianGrid& grid, int labels, unsigned seed);

/// Results for labels of Smallest to Largest cells.
struct AtlasClass
{
  Index Smallest, Largest;
  int Labels = 0;
  int Lost = 0;            ///< labels without an element
  double WorstError = 0.0; ///< largest volume error relative to the cells, of labels with elements
  double MeanError = 0.0;  ///< mean error of all labels; 1 for lost ones
  int Above1 = 0, Above20 = 0; ///< labels off by more than 1 % and 20 %, including lost ones
};

/// Measures a mesh of labels on unit cells. labels: before smoothing.
std::vector<AtlasClass> MeasureAtlas(
  const CartesianGrid& grid, const FractionField& labels, const MeshReport& report);

/// Returns the classes as a table.
std::string FormatAtlas(const std::vector<AtlasClass>& classes);

} // namespace testing
} // namespace vfm
