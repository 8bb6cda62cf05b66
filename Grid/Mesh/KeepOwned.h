/**
 * KeepOwned: removal of the elements that other ranks own.
 */
#pragma once

#include "Mesh/Mesh.h"

namespace vfm
{

/// Fills mesh.Facets, then removes the elements, points and facets of cells that other ranks own.
void KeepOwned(Mesh& mesh, const CartesianGrid& grid);

} // namespace vfm
