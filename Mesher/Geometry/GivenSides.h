/**
 * GivenSides: the sides of interfaces that lie on the surfaces of bodies.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Facet.h"
#include "Elements/Mesh.h"

#include <string>

namespace vfm
{

class BodySurfaces;

/// Sides of facets.
struct DividedFacets
{
  std::vector<int> SideOf;          ///< side of each facet, from 1 over all ranks; 0: none
  std::vector<std::string> Names{}; ///< of sides; [0] is not used. Sides beyond have no names
};

/// Finds the sides of the facets on interfaces whose body has a surface (BodySurfaces::
/// FindOfInterface). The side of a facet is that of the triangle with the smallest distance, plus
/// 0.6 times the size of the facet times 1 - cosine of the angle between both normals; triangles on
/// sides of the domain do not count. Then single facets take the side of their neighbours: a side
/// changes while that lowers the sum of these numbers and of 0.2 times the size for each edge
/// between two sides.
///
/// Sides are numbered by body and side of its surface. If an interface has only one side without a
/// name, its facets get side 0, as on interfaces without a surface and on sides of the domain.
/// @param mesh  mesh with final point positions
/// @return SideOf, valid for facets at points of owned elements, and all Names, equal on any number
/// of ranks
/// @pre Collective.
DividedFacets FindGivenSides(const std::vector<Facet>& facets, const Mesh& mesh,
  const BodySurfaces& surfaces, const Partition& partition, Runtime& runtime);

} // namespace vfm
