/**
 * StateArrays: arrays of the input whose values the elements of the mesh carry, piecewise constant: each element
 * has the values of one cell (Transfer/StateCells.h), from whichever rank reads that cell.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/CellDivision.h"
#include "Fractions/FractionField.h"
#include "InputLevels.h"
#include "Mesh/Mesh.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;

namespace vfm
{

/// What the values of an array are; the same on all ranks.
struct StateLayout
{
  int Type = 0; ///< VTK_DOUBLE and the like
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one a component, "" where it has none
};

class StateArrays
{
public:
  /// Collective. names: distinct arrays of any numeric type and number of components. Throws InputError, on all ranks
  /// alike, when a block has none, blocks disagree on type or components, or the mesh itself has an array of that name.
  /// input must outlive this. Component names: those of the lowest rank's first block of the coarsest level.
  StateArrays(const InputLevels& input, const std::vector<std::string>& names, Ranks& ranks);

  /// Collective: an array of each name, layout as in the input, a tuple an element, in the order of the elements.
  /// mesh: of this rank's owned cells, grid and fractions those it was made of, on some level of the input or beyond. An element
  /// has the values of the finest cell of the input around the middle of its cell of the grid. division: of the cells of that level
  /// into those of the grid.
  /// owners: the cells of level 0 that the ranks mesh. Ghost cells give nothing, blanked cells what their arrays hold. Ranks
  /// send each other what their local boxes need; nothing is sent without names.
  std::vector<vtkSmartPointer<vtkDataArray>> Carry(const Mesh& mesh, const CartesianGrid& grid,
    const FractionField& fractions, int level, const CellDivision& division,
    const std::vector<BlockPlace>& owners, Runtime& runtime) const;

private:
  /// Calls visit for every block of this rank with the number of each array.
  void VisitArrays(const std::function<void(const InputBlock&, std::size_t)>& visit) const;

  const InputLevels& Input;
  std::vector<std::string> Names;
  std::vector<StateLayout> Layouts; // of each name
};

} // namespace vfm
