/**
 * FlattenLayers: makes the faces between layers flatter than the facets on which the layers stand.
 *
 * A facet of hexahedra is bent where the surface is curved. If the face between two layers were
 * bent as much, no centre of a thin layer could see all of it: finite volumes and the tracking of
 * particles in OpenFOAM need that. The bend of a face is the distance of its two diagonals. Where
 * it exceeds a share of the thickness of a layer next to it, the corners of the face move along
 * their edges, in sweeps; each move is the smallest one that satisfies the limit of one face.
 */
#pragma once

#include "Modify/LayerColumns.h"

namespace vfm
{

/// Moves the ends of layers inside edges. Each layer keeps at least 60 % of its thickness.
/// @param[in,out] ends for each edge, where its layers end: 0, .., 1
/// @pre Collective
/// @note The same values on any number of ranks.
void FlattenLayers(const Mesh& mesh, const LayerColumns& columns, Ranks& ranks,
  std::vector<std::vector<double>>& ends);

} // namespace vfm
