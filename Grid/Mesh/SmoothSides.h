/**
 * SmoothSides: the smooth sides of interfaces that have edges, as the six of a cube.
 *
 * No edge of a facet joins two sides without a point that carries an edge. So the points of an interface that carry none and that no other
 * surface touches, joined over the edges of its facets, fall into pieces: the sides, however an edge winds from point to point. A facet is of
 * the side of its points; one of carriers alone, or with points of several sides, of the side around it whose facets have the nearest normal.
 * Sides join where most of their border turns out to be smooth, and those of a few facets the one beside them with the nearest normal. An edge that ends within a side cuts nothing.
 */
#pragma once

#include "Base/Partition.h"
#include "Mesh/Facet.h"
#include "Mesh/FeatureKind.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// Of each facet the side that it is of, numbered from 1 over all ranks by their lowest points; 0 on interfaces (of two fragments, or of a
/// fragment and what is not meshed) that are of a single side, and on sides of the domain. Right for facets at points of owned elements.
/// kinds: of every point of the mesh, as far as it is on owned nodes; none: no point carries an edge. mesh: points in their last
/// places. Collective.
std::vector<int> FindSmoothSides(const std::vector<Facet>& facets,
  const std::vector<FeatureKind>& kinds, const Mesh& mesh, const Partition& partition);

} // namespace vfm
