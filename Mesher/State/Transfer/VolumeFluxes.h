/**
 * VolumeFluxes: moves contents between the cells of a fragment until each cell contains the volume
 * that the mesh has in it.
 *
 * A cell contains the volume a of a fragment, and the elements of the fragment have the volume O in
 * the cell. Near interfaces, these differ locally, but hardly in total. Volumes that flow across
 * the faces of cells make them equal. They are differences of a potential: L phi = a - O
 * (PotentialFlow.h). Each volume takes its contents from the giving cell. The contents of a cell
 * thus become a mean of the contents of cells around it, so nothing is lost and bounds hold. Flows
 * go down the potential, so they have no cycles. For any volumes, a cell has enough to give after
 * it has received all its inflow.
 *
 * First, the total volumes of each connected set of donors (FlowNodes.h) are made equal. Volumes
 * are divided by a factor, and values per volume are multiplied by it.
 *
 * Results are bitwise identical on any number of ranks: PotentialFlow sums integers, and the flows
 * of a cell are summed in the order of its faces.
 */
#pragma once

#include "State/Transfer/DonorContents.h"
#include "State/Transfer/FlowNodes.h"

namespace vfm
{

/// Smallest and largest factor of values per volume, per material; 1 if nothing was changed.
using VolumeFactors = std::vector<std::array<double, 2>>;

/// Moves contents between donors until the volumes of owned donors are equal to their overlaps, up
/// to rounding.
/// @param region  donors between which contents move
/// @param links  links of all donors
/// @param donors,values  contents of the owned donors; copies are not up to date afterwards
/// @return factors per material over all ranks
/// @pre Collective.
VolumeFactors MoveContents(const StateSource& source, const FlowRegion& region,
  const DonorLinks& links, Runtime& runtime, DonorTable& donors, DonorValues& values);

} // namespace vfm
