/**
 * CyclicSides: the faces on opposite sides of a periodic mesh, in pairs.
 */
#pragma once

#include "Summary/MeshData.h"

namespace vfm
{

/// Two patches. Face i of the second one is face i of the first one moved by whole periods.
struct CyclicPatches
{
  /// Names such as x_min and x_max. Faces that are moved along several axes, which free sides may
  /// have at edges of the domain, have patches such as x_min_y_max and x_max_y_min.
  std::array<std::string, 2> Names;
  std::array<std::vector<Index>, 2> Sides; ///< numbers of sides (CellSides.h)
};

struct CyclicSides
{
  std::vector<CyclicPatches> Patches;
  std::vector<Index> Others; ///< sides without a copy, ascending
};

/// Finds the pairs among the sides without a cell behind. The order of the faces depends only on
/// the partners of their points.
/// @param mesh  whole mesh, with the field PeriodLengths if it has partners
/// @param open  sides, ascending
CyclicSides FindCyclicSides(const MeshData& mesh, const std::vector<Index>& open);

} // namespace vfm
