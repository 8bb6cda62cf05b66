/**
 * Volumes of the elements and fragments of a mesh.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Labels/FragmentShare.h"

namespace vfm
{

/// Returns the volume of an element; for a hex the volume of the trilinear map.
/// @param unit  unit of length of the result, in length units of the mesh
double VolumeOfElement(const Mesh& mesh, Index element, double unit = 1.0);

/// Returns the volume of each fragment of this rank over all ranks, in units of the mean cell
/// volume. [0] is not used. The sums do not depend on ranks and threads.
/// @param mesh  mesh of which only the elements in owned cells are counted
/// @param share  the fragments of this rank, whose numbers the elements have
/// @pre Collective.
std::vector<double> MeasureFragments(
  const Mesh& mesh, const CartesianGrid& grid, const FragmentShare& share, Runtime& runtime);

} // namespace vfm
