/**
 * ShareHead: what a mesh says of itself, on ranks without elements too.
 */
#pragma once

#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Collective: the mesh; on ranks without elements an empty one with the field data and the arrays, without values, of the first rank
/// that has elements. Throws InputError, on all ranks alike, when none has.
vtkSmartPointer<vtkUnstructuredGrid> ShareHead(vtkUnstructuredGrid* mesh, Ranks& ranks);

} // namespace vfm
