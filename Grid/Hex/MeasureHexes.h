/**
 * The volumes of fragments of a hexahedral mesh.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// The exact volumes of the owned hexes of a mesh by fragment, [0] none, over all ranks, in mean cells: the start
/// (FragmentVolumes::SetStart) where nodes between transition hexes have left the faces of the grid. fragments: how many there
/// are. Collective.
std::vector<double> MeasureHexes(
  const Mesh& mesh, const CartesianGrid& grid, int fragments, Runtime& runtime);

} // namespace vfm
