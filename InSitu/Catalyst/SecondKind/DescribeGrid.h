/**
 * DescribeGrid: a HostGrid in the words of Conduit's Mesh Blueprint.
 */
#pragma once

#include "CatalystAdaptor.h"
#include "Ranks/Ranks.h"

#include <catalyst_conduit.hpp>

namespace vfm
{

/// Collective: makes the node an object of meshes "box0", "box1" ..., as Catalyst's protocol "multimesh" wants it: the boxes of this rank,
/// and meshes without cells up to the most boxes of any rank, for all ranks to have the same. Each is a uniform grid whose fields are the
/// host's memory; its state tells the number of the box among those of all ranks, its level and the numbers. Cells below
/// finer boxes are hidden: the field vtkGhostType, a copy. Throws InputError as CheckHostGrid does.
void DescribeGrid(const HostGrid& grid, const std::vector<HostNumber>& numbers, Ranks& ranks,
  conduit_cpp::Node& meshes);

} // namespace vfm
