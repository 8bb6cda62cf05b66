/**
 * LayerPulls: the curvature of interfaces in the layers above them.
 *
 * A layer of a curved hexahedron has the shape of the hexahedron between two values of its
 * parameter: an edge between two layers has the displacements of the edges at the base and at the
 * top of the column, blended linearly. So thin layers along a curved interface are as valid as the
 * hexahedron.
 */
#pragma once

#include "Modify/LayerParts.h"

namespace vfm
{

/// Adds pulls for the edges between layers. The parts of edges of columns are straight.
/// @param mesh  with the points of the layers
/// @pre Collective.
void AddLayerPulls(const LayerParts& parts, Ranks& ranks, Mesh& mesh);

} // namespace vfm
