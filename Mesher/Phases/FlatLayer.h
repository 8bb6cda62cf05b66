/**
 * FlatLayer: the option Flat: a layer of one cell becomes a mesh of a plane.
 */
#pragma once

#include "Modify/FlattenMesh.h"
#include "Phases/MesherResult.h"
#include "Phases/PrepareCells.h"

namespace vfm
{

/// Returns the axis along which the cells are one layer, the last one if there are several.
/// @throws InputError  if there is none, or if the cells have several levels
int FindFlatAxis(const Cells& cells, const MeshOptions& options);

/// Turns the layer of hexes into quads, or triangles instead of tets, and the volumes of the report
/// into areas.
/// @param axis  FindFlatAxis
/// @pre Collective.
void FlattenResult(const MesherJob& job, int axis, FlatElement kind, const CartesianGrid& grid,
  MesherResult& result);

/// Completes the fields of a flat mesh: FlatAxis, the axis, comes first, and the bounds of the
/// domain along it are equal.
void FlattenBounds(int axis, std::vector<FieldArray>& fields);

} // namespace vfm
