/**
 * ElementMoments: exact volumes and centroids of hexahedra (trilinear) and tetrahedra.
 */
#pragma once

#include "Base/Vector3.h"
#include "Summary/MeshData.h"

namespace vfm
{

struct ElementMoments
{
  double Volume;  ///< length units cubed
  Vector3 Moment; ///< the integral of the position: the centroid times the volume
};

/// The moments of each element.
std::vector<ElementMoments> FindElementMoments(const MeshData& mesh);

} // namespace vfm
