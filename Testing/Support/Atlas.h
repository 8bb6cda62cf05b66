/**
 * A labelled image like a parcellation of a brain, and how well a mesh of it keeps its labels.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Mesh/MeshReport.h"

namespace vfm
{
namespace testing
{

/// n^3 unit cells. A warped ball of void around it holds about as many labels as asked for, by
/// their kinds: 45 % are cells of a weighted Voronoi diagram (small ones lie nested in large ones)
/// with rough sides, 30 % are rough blobs of 9 to 600 cells, 25 % are single cells to chains of 8,
/// half of them on interfaces. Every label has a cell. The same on any machine.
FractionField MakeAtlas(const CartesianGrid& grid, int labels, unsigned seed);

/// What became of the labels of one class of sizes, of [Smallest, Largest] cells.
struct AtlasClass
{
  Index Smallest, Largest;
  int Labels = 0;
  int Lost = 0;            ///< of them, without an element
  double WorstError = 0.0; ///< of a label's volume, relative to its cells, of those with elements
  double MeanError = 0.0;  ///< of their sizes
  int Above1 = 0, Above20 = 0; ///< off by more than 1 and 20 percent, the lost ones included
};

/// labels: as they were drawn, unit cells.
std::vector<AtlasClass> MeasureAtlas(
  const CartesianGrid& grid, const FractionField& labels, const MeshReport& report);

/// The classes as a table.
std::string FormatAtlas(const std::vector<AtlasClass>& classes);

} // namespace testing
} // namespace vfm
