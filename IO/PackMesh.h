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
Bytes PackGrid(vtkUnstructuredGrid* mesh);
vtkSmartPointer<vtkUnstructuredGrid> UnpackGrid(const Bytes& bytes);

} // namespace vfm
