/**
 * Ties an active tetrahedral mesh to its interfaces: targets, and the triangles that volumes are measured with.
 */
#pragma once

#include "Base/Options.h"
#include "Tet/ActiveTets.h"
#include "Tet/TetFacets.h"

namespace vfm
{

/// Draws every interface point to the target of each pair of labels that meets there: the one of the mixed node within two
/// nodes whose surface point is nearest; in Cells that of its own node. Pairs without one stay free.
void AttachTets(const Interface& interface, const Mesh& mesh, const TetFaces& faces,
  TetMethod method, ActiveTets& active);

/// Fills active.Facets and the fragments of the attachments.
void MeasureWithFaces(const Interface& interface, const Mesh& mesh, const TetFaces& faces,
  const CartesianGrid& grid, const Partition& partition, ActiveTets& active);

} // namespace vfm
