/**
 * PackMesh: a mesh as bytes for other ranks.
 */
#pragma once

#include "Ranks/Ranks.h"

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace vfm
{

/// With all arrays and the field data; not the time.
Bytes PackMesh(vtkUnstructuredGrid* mesh);
vtkSmartPointer<vtkUnstructuredGrid> UnpackMesh(const Bytes& bytes);

} // namespace vfm
