/**
 * EdgePulls: where the surfaces at the ends of interface edges draw the middles of the edges.
 *
 * An end of an edge has a target per pair of labels that meets there (SurfaceTargets.h). The middle
 * of the edge moves along the normals of these targets until its distance to each of them is the
 * mean distance of the two ends. So an edge gets the curvature of the surface, whatever keeps its
 * ends off the surface, and a flat surface leaves it straight. At a sharp edge, only targets that
 * both ends follow count. The mid node lies at the mean of what both ends request. Edges at points
 * that were put back to their start, because facets intersected, stay straight.
 *
 * On a periodic grid, edges have the ids that owners have of their ends (IdOfOwner).
 */
#pragma once

#include "Elements/MidNodes.h"
#include "Interface/SurfaceTargets.h"
#include "Labels/FragmentShare.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Returns the requests of the ends that this rank moves, for all edges of interface facets there.
/// @param facets  all facets of the mesh
/// @param targets  of kind Quadrics
/// @param active  with its final or present positions, attached to the targets
std::vector<EdgePull> FindEdgePulls(const std::vector<Facet>& facets, const Mesh& mesh,
  const SurfaceTargets& targets, const ActiveMesh& active, Runtime& runtime);

/// Returns the displacement of the mid node of each edge, from the requests of all ranks. Of
/// several requests of an end the first counts: ranks may list the same edge of a layer.
/// @pre Collective over `ranks`.
std::vector<EdgeMove> CombinePulls(
  const std::vector<EdgePull>& pulls, const std::vector<EdgeIds>& edges, Ranks& ranks);

/// Returns the volume that each fragment gains when interface edges become curved, in grid
/// coordinates.
/// @param share  the fragments of this rank, whose numbers the facets have
/// @pre Collective over runtime.Group().
std::vector<double> MeasureBulges(const std::vector<EdgePull>& pulls, const Mesh& mesh,
  const ActiveMesh& active, const FragmentShare& share, Runtime& runtime);

} // namespace vfm
