/**
 * CyclicSides: the faces on opposite sides of a periodic mesh, in pairs.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// A side of a cell of this rank in a cyclic patch.
struct CyclicSide
{
  Index Side;   ///< number of the side (CellSides.h)
  int CopyRank; ///< rank that has its copy
  Index Number; ///< position among the faces of the patch on all ranks
};

/// Two patches of the whole mesh. Face i of the second one is face i of the first one moved by
/// whole periods.
struct CyclicPatches
{
  /// Names such as x_min and x_max. Faces that are moved along several axes, which free sides may
  /// have at edges of the domain, have patches such as x_min_y_max and x_max_y_min.
  std::array<std::string, 2> Names;
  std::array<std::vector<CyclicSide>, 2> Sides; ///< of this rank, ascending by number
  Index Count = 0;                              ///< number of faces of each patch on all ranks
};

struct CyclicSides
{
  std::vector<CyclicPatches> Patches; ///< the same patches on all ranks
  std::vector<Index> Others;          ///< sides of this rank without a copy, ascending
};

/// Finds the copies of the sides of this rank without a cell behind, on any rank. The order of the
/// faces depends only on the partners of their points.
/// @param mesh  part of this rank, with the field PeriodLengths if it has partners
/// @param open  sides, ascending
/// @pre Collective
CyclicSides FindCyclicSides(const MeshData& mesh, const std::vector<Index>& open, Ranks& ranks);

} // namespace vfm
