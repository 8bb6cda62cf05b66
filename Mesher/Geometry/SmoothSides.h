/**
 * SmoothSides: the smooth sides of interfaces with edges, such as the six sides of a cube.
 */
#pragma once

#include "Base/Partition.h"
#include "Elements/Facet.h"
#include "Elements/FeatureKind.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Divides interfaces along their edges into smooth sides.
///
/// An interface separates two fragments, or a fragment and unmeshed space. A facet edge between two
/// sides has a carrier, a point on an edge of the interface (IsCarrier), at one end. Therefore the
/// points of an interface that are not carriers and touch no other interface are joined over facet
/// edges; the connected components are the sides. A facet belongs to the side of its points. If all
/// its points are carriers, or its points belong to several sides, the facet gets the adjacent side
/// that has a facet within 25 degrees of it, else the one with which it has most edges in common,
/// among equals the one with the nearest normal. Sides are joined if most of their common border is
/// smooth. A side of few facets is joined with the adjacent side that has the nearest normal. An
/// edge that ends inside a side does not divide it.
/// @param facets  facets of the mesh
/// @param kinds  kind of every mesh point, valid for points of owned nodes; empty:
///   there are no carriers
/// @param mesh  mesh with final point positions
/// @return smooth side of each facet, from 1 over all ranks by lowest point id; 0 on interfaces
///   with one side and on the domain boundary; valid for facets at points of owned elements
/// @pre Collective.
std::vector<int> FindSmoothSides(const std::vector<Facet>& facets,
  const std::vector<FeatureKind>& kinds, const Mesh& mesh, const Partition& partition);

} // namespace vfm
