/**
 * DivideInterfaces: the sides of all interfaces, given or smooth.
 */
#pragma once

#include "Elements/FeatureKind.h"
#include "Geometry/GivenSides.h"

namespace vfm
{

/// Finds the sides of interfaces: those of the surfaces of bodies (GivenSides.h), otherwise the
/// smooth sides (SmoothSides.h), which get greater numbers.
/// @param kinds  as of FindSmoothSides
/// @param surfaces  of the fractions; may be null
/// @pre Collective.
DividedFacets DivideInterfaces(const std::vector<Facet>& facets,
  const std::vector<FeatureKind>& kinds, const Mesh& mesh, const BodySurfaces* surfaces,
  const Partition& partition, Runtime& runtime);

} // namespace vfm
