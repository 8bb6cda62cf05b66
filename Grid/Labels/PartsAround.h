/**
 * PartsAround: counts the parts of a set of cells, and of the rest, in the 27 cells around a cell.
 *
 * Cells of the set are joined by faces, cells of the rest also by edges and corners. A cell is
 * simple if both counts are 1: it can leave the set, or join it, without changing the number of
 * parts, tunnels or cavities of either. (G. Bertrand, G. Malandain, A new characterization of
 * three-dimensional simple points, Pattern Recognition Letters 15, 1994.)
 */
#pragma once

#include <cstdint>

namespace vfm
{

/// Set of the 27 cells around a cell: bit n for the cell at StepAround(n).
using CellsAround = std::uint32_t;

/// Counts the parts of the set that touch the middle cell by a face, joined within the 18 cells
/// that share a face or an edge with it. Whether the middle cell is in the set does not count.
int CountPartsOfSet(CellsAround set);

/// Counts the parts of the rest within the 26 cells.
int CountPartsOfRest(CellsAround set);

} // namespace vfm
