/**
 * HexBoxes: finds the Cartesian grid that hexahedra form.
 *
 * Cells may have any order and need not fill a box, as in a part of a decomposed mesh. The
 * positions of cells follow from the coordinates of their eight corners. Cells are divided into
 * boxes: rows along x, which are joined along y and then z.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <span>
#include <string>
#include <vector>

namespace vfm
{

/// Cells of a data set, given by their corners.
class HexCells
{
public:
  virtual ~HexCells() = default;
  virtual Index NumberOfPoints() const = 0;
  virtual Vector3 GetPoint(Index point) const = 0;
  /// Returns the points at the corners of a cell, in any order. The memory is valid until the next
  /// call. Cells without eight existing points are rejected by the caller.
  virtual std::span<const Index> GetCorners(Index cell) = 0;
};

/// Boxes of cells of a data set.
struct HexBoxes
{
  std::vector<InputBlock> Blocks; ///< all members set except Arrays and Marks
  std::vector<Index> Cells;       ///< cells of the data set, in the order of the blocks

  /// Returns whether the blocks have all cells of the data set in its order.
  bool HaveOrderOf(Index cells) const;
};

/// Throws InputError "NAME: cell N WHAT".
[[noreturn]] void RejectCell(const std::string& name, Index cell, const std::string& what);

/// Finds the boxes of hexahedra. Not collective.
/// @param cells  hexahedra to read; may be empty
/// @param number,name  number and name of all blocks
/// @throws InputError  if cells are not boxes with sides along the axes, lie in the same place, or
///   have nodes of other cells between their nodes
HexBoxes FindHexBoxes(
  HexCells& hexahedra, const std::vector<Index>& cells, int number, const std::string& name);

} // namespace vfm
