/**
 * FlatColumns: the columns of two points of a layer of hexes that is one cell thick. The points of
 * a column have equal positions in the plane of the layer.
 */
#pragma once

#include "Base/Runtime.h"
#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// Gives the upper points of a mesh the positions of the lower ones in the plane.
/// @param axis  of the columns
void StraightenColumns(const CartesianGrid& grid, int axis, Runtime& runtime, Mesh& mesh);

/// Sets Columns of an active mesh, so that only the lower points of columns move by themselves.
/// @pre ActiveMesh::PointOf exists; the lists of corners do not.
void ListColumns(const CartesianGrid& grid, const Mesh& mesh, int axis, ActiveMesh& active);

} // namespace vfm
