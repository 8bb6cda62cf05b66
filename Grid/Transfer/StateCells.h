/**
 * The cell of the grid from which an element takes its state (velocity, density, temperature).
 *
 * The rule. It is the cell that holds the element's centroid, the mean of its corners (between two cells the
 * upper one), if the element's material fills at least half of it. Else it is, of that cell and its 26 neighbours in
 * the domain, the one with the greatest fraction of the element's material; of equal ones that whose centre is nearest
 * to the centroid; of those still equal the one with the lowest index. Void counts as a material: what the others leave.
 * So an element beside an interface takes the state of its own material and not what lies across. An element of a coarser
 * cell of a refined grid, where none of those 27 is half full, asks all cells of that one, too: its material may be farther away.
 *
 * Where smoothing has carried a centroid over more than StateReach cells along an axis, as it may across the thin cells
 * of a graded grid, the rule goes by the cell that many from those the element was made of (CellsOfElement; of TetGen's
 * tets, which have none, from the rank's cells). So ghost layers suffice, and ranks change nothing.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace vfm
{

/// Cells along each axis from the one that an element was made of to the farthest whose neighbours are asked.
constexpr int StateReach = GhostLayers - 1;

/// Of each element the place of its cell in grid.Local(), which has GhostLayers or more. mesh: of the owned cells, its materials
/// by their number. The same cells on any number of ranks and threads.
std::vector<Index> FindStateCells(
  const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

} // namespace vfm
