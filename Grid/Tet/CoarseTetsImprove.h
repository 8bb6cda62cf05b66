/**
 * The last step of CoarseTets: points of poor tets move.
 */
#pragma once

#include "Mesh/Mesh.h"
#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Calls its argument with the four points of each tet, in positive order, and the widths of its cells.
using TetList =
  std::function<void(const std::function<void(const std::array<int, 4>&, const Vector3&)>&)>;

/// Moves the movers of the tets that have a dihedral angle near 0 or 180 degrees, so that their energy falls. mesh: its points are those of
/// movers and tets. partition: of the grid of the movers' owners. Collective.
void ImproveCoarseTets(std::vector<Mover> movers, const TetList& tets, const CartesianGrid& finest,
  const Partition& partition, const ElementEnergy& energy, Runtime& runtime, Mesh& mesh);

} // namespace vfm
