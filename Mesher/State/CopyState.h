/**
 * CopyState: copies the values of one cell to each element (State/Transfer/StateCells.h), also from
 * cells that other ranks read.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Fractions/CellDivision.h"
#include "Fractions/FractionField.h"
#include "State/StateArrays.h"
#include "State/TransferredArray.h"

namespace vfm
{

/// The grid that a mesh was made on.
struct MeshedGrid
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  int Level; ///< level of the grid before its cells were divided, numbered as in the input
  CellDivision Division; ///< division of the cells of that level into the cells of the grid
  /// Nodes of the finest level of the input if the cells of the grid replace its cells; else null.
  const std::array<std::vector<double>, 3>* InputNodes = nullptr;
};

/// Returns the cell of other nodes, from the lowest, at the centre of a cell.
Index3 CellAtCentre(
  const CartesianGrid& grid, const Index3& cell, const std::array<std::vector<double>, 3>& nodes);

/// Copies state arrays to the elements of a mesh.
/// An element gets the values of the finest cell of the input at the centre of its cell of the
/// grid. Ghost cells of the input are not used; blanked cells have the values of their arrays.
/// @param mesh elements owned by this rank
/// @param owners cells of level 0 that each rank meshes
/// @return one array per state, with one tuple per element; type and components as in the input
/// @pre Collective
/// @note Without states, nothing is sent.
std::vector<TransferredArray> CopyState(const InputLevels& input,
  const std::vector<StateArray>& states, const Mesh& mesh, const MeshedGrid& meshed,
  const std::vector<BlockPlace>& owners, Runtime& runtime);

/// Copies state arrays of cells: each tuple is that of the finest cell of the input at the centre
/// of a cell.
/// @param cells  cells of a level that this rank meshes, from the lowest of the domain
/// @pre Collective
std::vector<TransferredArray> CopyCells(const InputLevels& input,
  const std::vector<StateArray>& states, const std::vector<Index3>& cells, int level,
  const std::vector<BlockPlace>& owners, Ranks& ranks);

} // namespace vfm
