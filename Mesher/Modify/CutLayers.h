/**
 * CutLayers: divides the hexahedra along surfaces of a finished mesh into layers.
 *
 * Each hexahedron has at most one face on an interface, so the hexahedra along the surface of a
 * fragment form columns, one per facet. A column is cut across the edges that lead away from its
 * facet. Columns next to each other have a side, and so the cuts of its edges, in common: the mesh
 * stays conforming. A part of a column is the map of the column on a smaller box, so all
 * coefficients of its Jacobian stay positive.
 */
#pragma once

#include "Modify/LayerHeights.h"
#include "State/OutputState.h"

namespace vfm
{

/// Cuts columns into layers. New elements and points get ids after the greatest ones. The first
/// layer of a column keeps its id. State of elements is that of the column; extensive arrays are
/// divided by volume. Sets Mesh::Layer, the layer of each element of a column from the surface.
/// @param spacing Layers >= 2
/// @param periods lengths along x, y, z after which the mesh repeats; 0: it does not
/// @pre Collective
/// @note The same mesh on any number of ranks.
void CutLayers(const LayerColumns& columns, const LayerSpacing& spacing, const Vector3& periods,
  Runtime& runtime, Mesh& mesh, OutputState& state);

} // namespace vfm
