/**
 * MakeCoarseTets: makes the tets in coarse hexes, in the best ways, and moves points of poor ones.
 *
 * Level by level, the centres and free points of transition hexes are moved where tets are poor:
 * where a dihedral angle is within 20 degrees of 0 or 180. One level follows another because points
 * of one colour but different levels might share a tet.
 */
#pragma once

#include "Elements/Tet/CoarseTets.h"
#include "Smoothing/Tet/TetEnergy.h"

#include <memory>

namespace vfm
{

struct SmoothedTets
{
  std::unique_ptr<CoarseTets> Tets;
  /// Families to refine because tets in owned base cells are not positive, one list per refinement.
  /// If there are any on a rank, levels and tets must be made again.
  std::vector<std::vector<Index>> BadFamilies;
};

/// Makes the tets, or none if the grid has no refinements.
/// @param hexes  coarse hexes that are not split; they are consumed (CoarseHexes::Visit)
/// @throws InputError  if ids or numbers of points are too large
/// @pre Collective.
SmoothedTets MakeCoarseTets(CoarseHexes& hexes, const TetEnergy& energy, Runtime& runtime);

} // namespace vfm
