/**
 * ElementMoments: exact volumes and centroids of hexahedra (trilinear) and tetrahedra.
 */
#pragma once

#include "Base/Vector3.h"
#include "Report/MeshData.h"

namespace vfm
{

struct ElementMoments
{
  double Volume;  ///< length units cubed
  Vector3 Moment; ///< integral of the position: centroid times volume
};

/// Returns the moments of each element, from its ElementCorners.
std::vector<ElementMoments> FindElementMoments(const MeshData& mesh);

} // namespace vfm
