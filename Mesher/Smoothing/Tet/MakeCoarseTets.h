/**
 * MakeCoarseTets: makes the tets in coarse hexes, in the best ways, and moves points of poor ones.
 *
 * Level by level, the centres and free points of transition hexes are moved where tets are poor:
 * where a dihedral angle is within 20 degrees of 0 or 180. One level follows another because points
 * of one colour but different levels might share a tet.
 */
#pragma once

#include "Elements/Hex/LabelledGrid.h"
#include "Elements/MeshRun.h"
#include "Elements/Tet/CoarseTets.h"
#include "Smoothing/Tet/TetEnergy.h"

#include <memory>

namespace vfm
{

/// Makes levels and the tets of coarse cells. Refines more families until all tets start with
/// positive volumes.
/// @param crossed  nodes around which all cells must be finest ones, ascending
/// @param[out] levels  without refinements there are no coarse tets
/// @throws InputError  see MakeLevels; if ids or numbers of points are too large
/// @pre Collective.
std::unique_ptr<const CoarseTets> MakeCoarseTets(const MeshCells& cells, const LabelArray& labels,
  const std::vector<Index>& crossed, const TetEnergy& energy, MeshRun& run, LevelHexes& levels);

} // namespace vfm
