/**
 * Contents moved between the cells of a fragment until each holds the volume that the mesh has in it.
 *
 * A cell holds a, the elements of the fragment have O in it. Near the interfaces these differ, place by place, but hardly in total. The volumes
 * that flow over the faces of cells, the gradient of a potential, L phi = a - O, make them equal. With each volume goes what the
 * giving cell has in it: what a cell holds afterwards is a mean of what was in cells around it, so nothing is lost and no bound is left. Flows go
 * down the potential, so they never run in circles: whatever the volumes, a cell has what it must give once it got what it gets.
 *
 * What a connected piece of these cells (FlowNodes.h) has in total is made equal first: volumes are divided by a factor, values per volume
 * multiplied with it.
 *
 * The same bits on any ranks: the potential is that of conjugate gradients whose sums are of integers; flows of a cell are summed
 * in the order of its faces.
 */
#pragma once

#include "Transfer/DonorContents.h"
#include "Transfer/FlowNodes.h"

namespace vfm
{

/// Of each material the smallest and largest factor of values per volume; 1 where nothing was changed.
using VolumeFactors = std::vector<std::array<double, 2>>;

/// Moves the contents of the owned donors; their volumes are then their overlaps, but for rounding. Collective.
VolumeFactors MoveContents(const StateSource& source, const FlowRegion& region,
  const DonorLinks& links, Runtime& runtime, DonorTable& donors, DonorValues& values);

} // namespace vfm
