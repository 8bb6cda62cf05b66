/**
 * KeepOwned: removal of the elements that other ranks own, and of the barrier (NarrowVoid.h).
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/BarrierElements.h"

namespace vfm
{

/// Fills mesh.Facets, then removes the elements, points and facets of cells that other ranks own,
/// and elements of the barrier, with the points that only they have.
/// @param[in,out] wholeCells  number of elements, from the first one, that are unchanged cells
void KeepOwned(const CartesianGrid& grid, const BarrierElements& barrier, Runtime& runtime,
  Index& wholeCells, Mesh& mesh);

} // namespace vfm
