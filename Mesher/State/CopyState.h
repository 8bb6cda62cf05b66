/**
 * CopyState: each element takes the values of one cell, unchanged (Transfer/StateCells.h), from whichever rank reads that cell.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/CellDivision.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"
#include "State/StateArrays.h"
#include "State/TransferredArray.h"

namespace vfm
{

/// The grid that a mesh was made of.
struct MeshedGrid
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  int Level;             ///< of the input, or beyond, before its cells were divided
  CellDivision Division; ///< of the cells of that level into those of the grid
};

/// Collective: an array of each state, its type and components as in the input, a tuple an element, in the order of the elements.
/// mesh: of this rank's owned cells. An element has the values of the finest cell of the input around the middle of its cell of the grid.
/// owners: the cells of level 0 that the ranks mesh. Ghost cells give nothing, blanked cells what their arrays hold. Ranks
/// send each other what their local boxes need; nothing is sent without states.
std::vector<TransferredArray> CopyState(const InputLevels& input,
  const std::vector<StateArray>& states, const Mesh& mesh, const MeshedGrid& meshed,
  const std::vector<BlockPlace>& owners, Runtime& runtime);

} // namespace vfm
