/**
 * The volumes of the fragments of a mesh.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// Of the owned elements of a mesh by fragment, [0] none, over all ranks, in mean cells: exact but for rounding. fragments: how many
/// there are. Collective.
std::vector<double> MeasureFragments(
  const Mesh& mesh, const CartesianGrid& grid, int fragments, Runtime& runtime);

} // namespace vfm
