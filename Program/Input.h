/**
 * Input: the pieces or blocks of cells that were read from a file, with their arrays and the times
 * of the file. It is the common result of all readers.
 */
#pragma once

#include "ChosenArray.h"
#include "Input/ArrayInfo.h"
#include "Input/LabelNames.h"
#include "Surfaces/InputSurfaces.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Items to which the values of an array belong.
enum class ArrayPlace
{
  Cells,
  Points
};

/// Properties of the cells of a piece or block, for sculptor --list. It can be sent to other ranks.
struct CellsInfo
{
  Index Count = 0;          ///< number of cells, without ghost cells
  Vector3 Lower{}, Upper{}; ///< bounds
  IndexBox Box;             ///< global indices, only for images and rectilinear grids
  Vector3 Widths{};         ///< mean widths of the cells of such grids and of blocks; otherwise 0
};

/// Piece or block of an input. Its cells are not yet checked to form a grid.
struct InputPiece
{
  std::shared_ptr<const BlockArrays> Cells, Points; ///< arrays; null: none
  bool IsImage; ///< its points can be meshed as centres of cells
  /// Describes the cells, or the cells around the points of an image.
  std::function<CellsInfo(ArrayPlace)> Describe;
};

/// Contents of a file.
struct Input
{
  std::vector<InputPiece> Pieces; ///< pieces of this rank that have cells
  bool IsOne = false;             ///< true: pieces of one grid, false: blocks
  /// Returns the blocks to mesh, which hold the memory of their arrays. Collective. Throws
  /// InputError on all ranks.
  std::function<CollectedBlocks(const ArraysToRead& arrays, Ranks& ranks)> Collect;
  std::optional<double> Time; ///< time of the step that was read, if the file has times
  std::vector<double> Times;  ///< times of all steps
  Index Volumes = 1;          ///< number of images in the file
  std::string Warning;        ///< warning about data that were not read or assumed, or empty
  LabelNames Names;           ///< names of labels that the file contains, equal on all ranks
  bool IsPicture = false;     ///< whether the file is a picture of one slice
  /// Arrays of fractions of all materials, if the file itself says so.
  std::vector<std::string> Materials;
  /// Surfaces from which the fractions were computed, equal on all ranks; null: none.
  std::shared_ptr<const InputSurfaces> Surfaces;
};

/// Makes an input of blocks, or of the pieces of one image with their Box.
Input MakeInput(CollectedBlocks blocks, bool areOfImage);

/// Returns the part of this rank in a grid that is divided along its longest axis; empty if there
/// are more ranks than layers of cells.
IndexBox FindSlab(const Index3& cells, const Ranks& ranks);

/// Returns the arrays of all pieces of this rank.
ArrayLists ListsOf(const Input& input, ArrayPlace place);

/// Returns whether all pieces are images.
/// @pre Collective
bool AreImages(const Input& input, Ranks& ranks);

/// Returns the numeric arrays of all ranks, in the order of the files, without ghost marks.
/// @pre Collective
std::vector<ArrayInfo> FindArrays(const Input& input, ArrayPlace place, Ranks& ranks);

/// Describes the arrays for messages: "Its cell arrays: ball (double, 0 to 1), velocity (float, 3
/// components)." The point arrays follow, if any, with a note if they cannot be meshed.
/// @pre Collective
std::string DescribeArrays(const Input& input, Ranks& ranks);

} // namespace vfm
