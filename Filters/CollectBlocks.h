/**
 * CollectBlocks: finds the blocks of a VTK data object.
 *
 * Supported data: vtkImageData, vtkUniformGrid, vtkRectilinearGrid, vtkUnstructuredGrid and
 * vtkStructuredGrid with the cells of a Cartesian grid (RecogniseGrid), and composite data sets of
 * these. Extents may restart at 0 in each block. If point arrays of images are selected, each point
 * is the centre of a cell: the grid begins half a spacing before the image, and has one cell more
 * along each axis.
 *
 * Ghost cells (vtkGhostType, DUPLICATECELL) are dropped. In images and rectilinear grids they may
 * only form layers on the sides of a block. Blanked cells (HIDDENCELL) stay and are void.
 */
#pragma once

#include "ChosenArray.h"
#include "Input/InputBlocks.h"
#include "State/StateChoice.h"

#include "vtkDataObject.h"

class vtkDataArray;

namespace vfm
{

/// A data object that is not composite.
struct InputPart
{
  vtkDataObject* Data;
  int Number;       ///< number in a composite data set; -1: not in a composite data set
  std::string Name; ///< name in messages
  bool IsPiece;     ///< piece of an input on several ranks; it may be flat or empty

  /// Returns whether the part has points. A part without points has no cells, and may lack all
  /// other properties on a rank without data.
  bool HasPoints() const;
};

/// Returns the values of an array vtkGhostType, or null for null.
std::shared_ptr<std::vector<unsigned char>> MarksOf(vtkDataArray* ghostTypes);

/// Returns the parts of an input on this rank.
/// @param input null: no parts
/// @param isAlone whether there is only one rank
std::vector<InputPart> FindParts(vtkDataObject* input, int rank, bool isAlone);

/// Lists the arrays of materials, state and user-selected cells.
ArraysToRead ListArrays(
  std::vector<ChosenArray> materials, const StateChoice& state, const MesherOptions& options);

/// Finds the blocks that have cells other than ghost cells.
/// @param data part of the input on this rank; null: none
/// @throws InputError on all ranks, if the type of data is unsupported, a grid is flat or empty,
/// coordinates do not increase, or ghost cells are inside a block. Also if direction matrices
/// differ or are not orthonormal, if point arrays are selected on grids other than images or mixed
/// with cell arrays, or if RecogniseGrid throws.
/// @pre Collective
CollectedBlocks CollectAllBlocks(vtkDataObject* data, const ArraysToRead& arrays, Ranks& ranks);

} // namespace vfm
