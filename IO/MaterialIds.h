/**
 * MaterialIds: the materials that a mesh has on all ranks together, and the number of a meshed void.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <vector>

class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: the values of MaterialId that elements have on any rank, ascending. Throws InputError, on all ranks alike, when the
/// array is missing or a value is negative.
std::vector<int> FindMaterials(vtkUnstructuredGrid* mesh, Ranks& ranks);

/// Collective: what stands for material 0, the void, where numbers must be positive: the number after the greatest one of the
/// elements and of the field data MaterialIds. Throws InputError, on all ranks alike, when there is none.
int FindVoidId(vtkUnstructuredGrid* mesh, Ranks& ranks);

} // namespace vfm
