/**
 * DescribeGrid: describes a HostGrid by Conduit's Mesh Blueprint.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "Ranks/Ranks.h"

#include <catalyst_conduit.hpp>

namespace vfm
{

/// Fills a node with meshes "box0", "box1", ..., as Catalyst's protocol "multimesh" requires. They
/// are the boxes of this rank, then meshes without cells, so that all ranks have equally many.
///
/// Each mesh is a uniform grid whose fields are the memory of the simulation. Its state contains
/// the number of the box over all ranks, its level and the global numbers. Cells below finer boxes
/// are hidden by the field vtkGhostType, which is a copy.
/// @param[out] meshes  node to fill
/// @throws InputError  same conditions as CheckHostGrid, or if there are no boxes on any rank
/// @pre Collective
void DescribeGrid(const HostGrid& grid, const std::vector<HostNumber>& numbers, Ranks& ranks,
  conduit_cpp::Node& meshes);

} // namespace vfm
