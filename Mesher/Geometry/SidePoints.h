/**
 * SidePoints: the smooth sides of interfaces, as sets of the points inside them (SmoothSides.h).
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Partition.h"
#include "Base/Vector3.h"
#include "Elements/Facet.h"
#include "Elements/FeatureKind.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Returns the unit normal of a facet, out of the larger side in SurfaceOf.
Vector3 NormalOf(const Mesh& mesh, const Facet& facet);

/// Returns, for each point of the mesh, the adjacent facets for which isListed(facet) is true.
template <class Condition>
Groups<int> ListFacetsAt(
  const std::vector<Facet>& facets, const Mesh& mesh, const Condition& isListed)
{
  return MakeGroups<int>(mesh.PointIds.size(),
    [&](const auto& visit)
    {
      for (int f = 0; f < static_cast<int>(facets.size()); ++f)
      {
        for (int c = 0; isListed(f) && c < mesh.CornersOfFacet(); ++c)
        {
          visit(facets[f].Points[c], f);
        }
      }
    });
}

/// Interfaces with edges, which are cut into sides, and the points inside the sides.
struct SidePoints
{
  /// Cut interface of each facet, from 0 over all ranks; -1 if its interface has no edges.
  std::vector<int> CutOf;
  /// Side of each point, numbered from 1 over all ranks by the lowest point. 0: the point is on an
  /// edge, on several interfaces, or on an interface without edges.
  std::vector<int> SideOf;
  int NumberOfSides; ///< on all ranks
};

/// Finds the points inside smooth sides. Edges run over carriers (IsCarrier); gaps of a few points
/// around which facets turn are closed. The remaining points on only one interface are joined over
/// facet edges; their connected components are the sides. FindSmoothSides explains the parameters.
/// @pre Collective.
SidePoints FindSidePoints(const std::vector<Facet>& facets, const std::vector<FeatureKind>& kinds,
  const Mesh& mesh, const Partition& partition);

} // namespace vfm
