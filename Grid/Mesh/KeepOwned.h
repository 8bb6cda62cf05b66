/**
 * KeepOwned: a mesh without what other ranks write.
 */
#pragma once

#include "Mesh/Mesh.h"

namespace vfm
{

/// Finds Facets, then drops the elements, points and facets that belong to other ranks' cells.
void KeepOwned(Mesh& mesh, const CartesianGrid& grid);

} // namespace vfm
