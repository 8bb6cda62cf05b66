/**
 * The volumes of the elements of a mesh and of its fragments.
 */
#pragma once

#include "Base/Runtime.h"
#include "Mesh/Mesh.h"

namespace vfm
{

/// The volume of an element, of hexes the trilinear one; unit: of lengths.
double VolumeOfElement(const Mesh& mesh, Index element, double unit = 1.0);

/// Of the owned elements of a mesh by fragment, [0] none, over all ranks, in mean cells: exact but for rounding. fragments: how many
/// there are. Collective.
std::vector<double> MeasureFragments(
  const Mesh& mesh, const CartesianGrid& grid, int fragments, Runtime& runtime);

} // namespace vfm
