/**
 * ExodusFile: reads element blocks of an Exodus file.
 */
#pragma once

#include "Blocks/HexBoxes.h"
#include "Input/PlainArrays.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Name of the array with the id of each cell's element block, which is made when it is named.
constexpr const char* BlockIds = "object_id";

/// Contents of a file.
struct ExodusContents
{
  std::vector<double> Times;
  std::vector<std::string> Names; ///< element variables
};

/// Element block with three-dimensional elements.
struct ElementBlock
{
  std::string Type;                                   ///< as in the file, for instance HEX8
  Index Count = 0;                                    ///< number of elements
  std::shared_ptr<const std::vector<Vector3>> Points; ///< points of the file
  std::vector<Index> Corners;                         ///< points of each element, from 0
  std::shared_ptr<const PlainArrays> Arrays;

  /// Returns the points of an element.
  std::span<const Index> GetPoints(Index element) const
  {
    const std::size_t each = this->Corners.size() / this->Count;
    return std::span(this->Corners).subspan(element * each, each);
  }
};

/// Reads the structure of a file.
/// @throws InputError  if it cannot be read or is damaged; the message does not contain the path
ExodusContents ReadExodusContents(const std::string& path);

/// Reads the blocks with elements of three dimensions.
/// @param step  index of the time; nothing if the file has no times
/// @param names  arrays to read, of the blocks that have them: element variables and BlockIds
/// @throws InputError  same conditions
std::vector<ElementBlock> ReadElementBlocks(
  const std::string& path, const std::optional<Index>& step, const std::vector<std::string>& names);

/// Finds the grid of the elements of a block.
/// @throws InputError  if an element is no hexahedron, or as FindHexBoxes does
std::vector<InputBlock> FindBoxes(const ElementBlock& block, int number, const std::string& name);

} // namespace vfm
