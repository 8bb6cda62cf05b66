/**
 * StateCells: finds the cell of the grid from which an element takes its state, such as velocity,
 * density and temperature.
 *
 * Rule. The cell is the one that contains the element's centroid, the mean of its corners, if the
 * element's material fills at least half of it. Between two cells, the upper one counts. Otherwise,
 * this cell and its 26 neighbours in the domain are compared, and the cell with the largest
 * fraction of the element's material is taken. Ties go to the cell whose centre is nearest to the
 * centroid, then to the lowest index. Void counts as a material. So an element next to an interface
 * takes the state of its own material, not of the other side. If an element of a coarser cell of a
 * refined grid finds no cell that is half full, it also compares all finest cells of this cell,
 * because its material may be farther away.
 *
 * Smoothing may move a centroid by more than StateReach cells along an axis, across the thin cells
 * of a graded grid. Then the nearest cell at this distance from the cells that the element was made
 * of (CellsOfElement) replaces the cell of the centroid. TetGen's tets have no such cells; for
 * them, the distance is measured from the owned cells. So ghost layers suffice, and the number of
 * ranks does not change the result.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Fractions/FractionField.h"

#include <vector>

namespace vfm
{

/// Largest distance, in cells along each axis, of the cell of the centroid from the cells that an
/// element was made of.
constexpr int StateReach = GhostLayers - 1;

/// Returns the cell of each element, as an index in grid.Local() (IndexInBox). The result does not
/// depend on the number of ranks and threads.
/// @param mesh  elements owned by this rank; materials have the numbers of the fractions
/// @param grid  grid with at least GhostLayers layers of ghost cells
/// @param fractions  fractions in grid.Local(), ghost cells too
std::vector<Index> FindStateCells(
  const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime);

} // namespace vfm
