/**
 * KeepOwned: removal of the elements that other ranks own, and of the barrier (NarrowVoid.h).
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"

namespace vfm
{

/// Fills mesh.Facets, then removes the elements, points and facets of cells that other ranks own,
/// and elements that are only a barrier, with the points that only they have.
void KeepOwned(Mesh& mesh, const CartesianGrid& grid, Runtime& runtime);

} // namespace vfm
