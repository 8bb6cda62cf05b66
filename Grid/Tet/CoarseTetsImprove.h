/**
 * CoarseTetsImprove: the last step of CoarseTets, which moves the points of poor tets.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Function that calls its argument for each tet with the four points, in positive orientation, and
/// the widths of the cell, in mean widths of the grid.
using TetList =
  std::function<void(const std::function<void(const std::array<int, 4>&, const Vector3&)>&)>;

/// Reduces the energy of tets with a dihedral angle within 20 degrees of 0 or
/// 180, by moving their movers.
/// @param partition  partition of the base grid, whose nodes own the movers (Mover::Owner)
/// @param mesh  holds the points to which movers and tets refer
/// @pre Collective.
void ImproveCoarseTets(std::vector<Mover> movers, const TetList& tets, const CartesianGrid& finest,
  const Partition& partition, const ElementEnergy& energy, Runtime& runtime, Mesh& mesh);

} // namespace vfm
