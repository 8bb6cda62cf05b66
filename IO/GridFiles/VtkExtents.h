/**
 * VtkExtents: reads and checks the numbers of the elements of XML files of VTK: extents, numbers of
 * points and cells, spacing.
 */
#pragma once

#include "GridFiles/XmlOutline.h"

#include <array>
#include <limits>
#include <optional>

namespace vfm
{

constexpr int LargestVtkInt = std::numeric_limits<int>::max() - 1;

/// Rejects a file.
/// @throws InputError  always; the message does not contain the path
[[noreturn]] void RejectVtkFile(const std::string& problem);

/// Returns the integers of an attribute; the text must hold just their number.
/// @param least  least allowed integer
/// @throws InputError  if it does not
template <std::size_t Count>
std::array<std::int64_t, Count> ReadVtkInts(
  const OutlineElement& element, const std::string& name, int least);

/// Numbers of points and cells of a piece; nothing if unknown.
struct VtkPieceSize
{
  std::optional<std::int64_t> Points, Cells;
  std::array<std::int64_t, 3> Nodes{}; ///< along each axis of structured grids
};

/// First and last node along each axis.
using VtkExtent = std::array<std::int64_t, 6>;

/// Reads an extent, which must not have more than 2^50 points.
VtkExtent ReadVtkExtent(const OutlineElement& element, const std::string& name);
VtkPieceSize SizeOfVtkExtent(const VtkExtent& extent);

/// Checks the extents of a grid and of its pieces, which lie in the grid and fill it, and the place
/// of an image. VTK's readers return memory that is not set where pieces are missing.
/// @param part  element of the file of pieces that names this grid, whose pieces then need not fill
///   it; null for other files
/// @throws InputError  if they are invalid
void CheckVtkExtents(const OutlineElement& grid, const OutlineElement* part);

} // namespace vfm
