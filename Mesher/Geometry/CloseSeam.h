/**
 * CloseSeam: makes the points on opposite sides of a periodic mesh exact translates of each other.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Sets copies of points to the position of their owner, translated. The upper copy of a
/// coordinate is the lower one plus the period, bitwise.
/// @param mesh  mesh with the elements of CartesianGrid::HexBox
/// @pre Collective among peers.
void CloseSeam(const Partition& partition, Mesh& mesh);

} // namespace vfm
