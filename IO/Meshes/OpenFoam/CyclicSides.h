/**
 * CyclicSides: the faces on opposite sides of a periodic mesh, in pairs.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

namespace vfm
{

/// A side of a cell of a rank.
struct RankSide
{
  int Rank;
  Index Side; ///< number of the side (CellSides.h)
};

/// Two patches of the whole mesh. Face i of the second one is face i of the first one moved by
/// whole periods.
struct CyclicPatches
{
  /// Names such as x_min and x_max. Faces that are moved along several axes, which free sides may
  /// have at edges of the domain, have patches such as x_min_y_max and x_max_y_min.
  std::array<std::string, 2> Names;
  std::array<std::vector<RankSide>, 2> Sides;
};

struct CyclicSides
{
  std::vector<CyclicPatches> Patches; ///< equal on all ranks
  std::vector<Index> Others;          ///< sides of this rank without a copy, ascending
};

/// Finds the pairs among the sides of all ranks without a cell behind. The order of the faces
/// depends only on the partners of their points.
/// @param mesh  part of this rank, with the field PeriodLengths if it has partners
/// @param open  sides, ascending
/// @pre Collective
/// @note Each rank stores the open sides of all ranks, 80 bytes each.
CyclicSides FindCyclicSides(const MeshData& mesh, const std::vector<Index>& open, Ranks& ranks);

} // namespace vfm
