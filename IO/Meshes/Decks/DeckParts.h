/**
 * DeckParts: lines with nodes and lists of nodes that several formats share.
 */
#pragma once

#include "Meshes/Decks/DeckCards.h"
#include "Report/Sets/MeshSets.h"

namespace vfm
{

/// Writes the number and the coordinates of each node, in fields of these widths.
void WriteNodeLines(
  DeckCards& cards, const MeshData& mesh, std::size_t numberWidth, std::size_t realWidth);

/// Writes the numbers of points, so many in a line.
void WriteNumbers(
  DeckCards& cards, const std::vector<Index>& points, std::size_t inLine, std::size_t width);

/// Writes the four nodes of a face; its normal points out of the element. A triangle repeats its
/// last node, and so does an edge of a plane.
void WriteFace(DeckCards& cards, const MeshData& mesh, const ElementSide& side, std::size_t width);

} // namespace vfm
