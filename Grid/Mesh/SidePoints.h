/**
 * SidePoints: which smooth sides of interfaces the points of facets are inside of.
 *
 * Points carry edges as they are told to; an edge also goes on over some points around which the facets turn, so that gaps close. The others
 * that are on one interface alone, joined over the edges of facets, are the pieces that edges leave: the sides (SmoothSides.h).
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Partition.h"
#include "Base/Vector3.h"
#include "Mesh/Facet.h"
#include "Mesh/FeatureKind.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// Of a facet, unit, out of the larger of SurfaceOf.
Vector3 NormalOf(const Mesh& mesh, const Facet& facet);

/// The facets for which isListed(facet) holds at each point of the mesh.
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

struct SidePoints
{
  std::vector<int>
    CutOf; ///< of each facet: its interface among those with edges, from 0; -1: it has none
  int NumberOfCuts; ///< interfaces with edges
  /// Of each point its side, numbered from 1 over all ranks by the lowest point; 0: on an edge, on several interfaces or on one without edges.
  std::vector<int> SideOf;
  std::vector<int> CutsOfSides; ///< the interface of each side; [0] unused
};

/// As of FindSmoothSides. Collective.
SidePoints FindSidePoints(const std::vector<Facet>& facets, const std::vector<FeatureKind>& kinds,
  const Mesh& mesh, const Partition& partition);

} // namespace vfm
