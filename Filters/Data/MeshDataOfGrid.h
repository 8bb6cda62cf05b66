/**
 * MeshDataOfGrid: views a VTK mesh, from a filter or a file, as MeshData.
 */
#pragma once

#include "Report/MeshData.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// Returns a view that shares ownership of the memory of a mesh, with copies if types or layouts
/// differ. Arrays without a name or without numbers are ignored. Corners of an empty mesh are 8.
/// @throws InputError if cells are neither all hexahedra nor all tetrahedra
StoredMesh MeshDataOf(vtkUnstructuredGrid* mesh);

} // namespace vfm
