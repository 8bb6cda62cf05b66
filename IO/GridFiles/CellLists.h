/**
 * CellLists: checks the lists of points of cells in an XML file of VTK.
 */
#pragma once

#include "GridFiles/VtkStorage.h"
#include "GridFiles/XmlOutline.h"

namespace vfm
{

/// Checks the points of cells, the ends of their lists, and their types.
/// @param lists  element Cells, or Verts, Lines, Strips, Polys
/// @throws InputError  if a list is missing or damaged, or if lists contradict each other
void CheckCellLists(
  const OutlineElement& lists, std::int64_t cells, std::int64_t points, const VtkStorage& storage);

} // namespace vfm
