/**
 * CollectBlocks: the blocks of a VTK data object.
 *
 * Taken are vtkImageData, vtkUniformGrid, vtkRectilinearGrid, vtkUnstructuredGrid and vtkStructuredGrid whose cells are
 * those of a Cartesian grid (RecogniseGrid), and composite data sets of them; extents may restart at 0 in every block.
 * Where point data of images are chosen, each point is the centre of a cell: the grid begins half a spacing lower, and has a
 * cell more along each axis than the image.
 * Ghost cells (vtkGhostType, DUPLICATECELL) are dropped: in images and rectilinear grids they may only form layers on the
 * sides of a block. Blanked cells (HIDDENCELL) stay and are void.
 */
#pragma once

#include "ChosenArray.h"
#include "Input/InputBlocks.h"
#include "State/StateChoice.h"

#include "vtkDataObject.h"

class vtkDataArray;

namespace vfm
{

/// A data object that is no composite.
struct InputPart
{
  vtkDataObject* Data;
  int Number;       ///< in a composite data set, else -1
  std::string Name; ///< for messages
  bool IsPiece;     ///< of an input that is dealt to several ranks: it may be flat or empty

  /// What has none has no cells either, and on a rank that has nothing may be without all else.
  bool HasPoints() const;
};

/// Of cells or points by the array vtkGhostType, in its order; null of null.
std::shared_ptr<std::vector<unsigned char>> MarksOf(vtkDataArray* ghostTypes);

/// Of this rank alone. input: null for none.
std::vector<InputPart> FindParts(vtkDataObject* input, int rank, bool isAlone);

/// The arrays of the materials, of the state and of the cells to refine.
ArraysToRead ListArrays(
  std::vector<ChosenArray> materials, const StateChoice& state, const MesherOptions& options);

/// Collective; data: this rank's part, null for none. The blocks that have cells which are no ghosts. Throws InputError, on all ranks alike,
/// on data of another kind, flat or empty grids, direction matrices that differ or are sheared, points of grids that are no images,
/// arrays of points beside those of cells, coordinates that do not increase, ghost cells in the middle of a block, and as RecogniseGrid does.
CollectedBlocks CollectAllBlocks(vtkDataObject* data, const ArraysToRead& arrays, Ranks& ranks);

} // namespace vfm
