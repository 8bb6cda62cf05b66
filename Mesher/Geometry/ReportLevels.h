/**
 * ReportLevels: counts the cells of a refined grid.
 */
#pragma once

#include "Elements/Mesh.h"
#include "Elements/MeshReport.h"

namespace vfm
{

/// Fills MeshReport::Levels and TransitionCells: the families and hexes of each
/// level over all ranks.
/// @param mesh  mesh with owned elements only
/// @param requested  LevelHexes::RequestedFamilies
/// @pre Collective.
void ReportLevels(
  const Mesh& mesh, const std::vector<Index>& requested, Ranks& ranks, MeshReport& report);

} // namespace vfm
