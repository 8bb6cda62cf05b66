/**
 * PeriodicPairs: the points of a periodic mesh that are copies of another point.
 */
#pragma once

#include "Report/MeshData.h"

namespace vfm
{

/// A copy of a point. Its position is that of the other point plus whole periods.
struct PeriodicPair
{
  Index Point, Partner; ///< points of the mesh; the partner has the lowest id of all copies
  Index3 Periods;       ///< number of periods along x, y, z (axes of the image) between both
};

/// Returns the number of periods between two points in axes of the image.
/// @param lengths PeriodLengths
Index3 CountPeriods(const Vector3& from, const Vector3& to, const std::vector<double>& lengths);

/// Returns the pairs of a mesh, ascending by point; none if the mesh is not periodic.
/// @param mesh whole mesh, with the field PeriodLengths
/// @throws InputError if a partner is not in the mesh
std::vector<PeriodicPair> FindPeriodicPairs(const MeshData& mesh);

} // namespace vfm
