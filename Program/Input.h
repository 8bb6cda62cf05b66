/**
 * Input: what was read of a file, whoever read it: the pieces or blocks of this rank with their arrays, and the times of the file.
 */
#pragma once

#include "ChosenArray.h"
#include "Input/ArrayInfo.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// What the values of an array belong to.
enum class ArrayPlace
{
  Cells,
  Points
};

/// The cells of a piece or block, as they are sent and listed.
struct CellsInfo
{
  Index Count = 0; ///< without copies of others'
  Vector3 Lower{}, Upper{};
  IndexBox Box;     ///< of images and rectilinear grids
  Vector3 Widths{}; ///< of a mean cell of these and of blocks; others: 0
};

/// A piece or block; whether its cells form a grid shows when they are collected.
struct InputPiece
{
  std::shared_ptr<const BlockArrays> Cells, Points; ///< arrays; null: none
  bool IsImage;                                  ///< its points can be meshed as cells around them
  std::function<CellsInfo(ArrayPlace)> Describe; ///< Points: of images only
};

struct Input
{
  std::vector<InputPiece> Pieces; ///< of this rank, those that have cells
  bool IsOne = false;             ///< they are pieces of one grid, else its blocks
  /// Collective: the blocks that are meshed, with the memory of their arrays. Throws InputError, on all ranks.
  std::function<CollectedBlocks(const ArraysToRead& arrays, Ranks& ranks)> Collect;
  std::optional<double> Time; ///< of the step that was read, where the file has times
  std::vector<double> Times;  ///< of all steps
  std::string Warning;        ///< empty, or what the reader left out
};

/// An input of blocks, or of the pieces of one image, with their Box.
Input MakeInput(CollectedBlocks blocks, bool areOfImage);

/// This rank's part of a grid with so many cells, across its longest axis; empty where there are more ranks than layers.
IndexBox FindSlab(const Index3& cells, const Ranks& ranks);

ArrayLists ListsOf(const Input& input, ArrayPlace place);

/// Collective: whether all pieces are images.
bool AreImages(const Input& input, Ranks& ranks);

/// Collective: the numeric arrays of all ranks in the order in which files list them, without marks of ghosts.
std::vector<ArrayInfo> FindArrays(const Input& input, ArrayPlace place, Ranks& ranks);

/// Collective, for messages: "Its cell arrays: ball (double, 0 to 1), velocity (float, 3 components)." and, if there are, those of
/// points, and whether they can be meshed.
std::string DescribeArrays(const Input& input, Ranks& ranks);

} // namespace vfm
