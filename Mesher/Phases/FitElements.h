/**
 * FitElements: the phase that moves the points of a draft to the interfaces, and improves its
 * elements.
 */
#pragma once

#include "Phases/ElementMethod.h"

namespace vfm
{

/// Moves the points of the draft, and fills Kinds and Mesh::Pulls.
/// @pre Collective.
void FitElements(const MeshCells& cells, ElementMethod& method, MeshRun& run, Draft& draft);

} // namespace vfm
