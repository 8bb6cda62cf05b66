/**
 * PieceArrays: checks that a piece of a grid of VTK has the arrays that the grid announces. VTK
 * copies values of other types byte by byte.
 */
#pragma once

#include "GridFiles/XmlOutline.h"

namespace vfm
{

/// Checks the names, types and numbers of components of the arrays of points and of cells, the
/// points and coordinates.
/// @param like  first piece of the file, or the grid of a file of pieces
/// @param prefix  of the names of elements in `like`: empty, or "P" in a file of pieces
/// @throws InputError  if an array is missing or different
void CheckPieceArrays(
  const OutlineElement& piece, const OutlineElement& like, const std::string& prefix);

} // namespace vfm
