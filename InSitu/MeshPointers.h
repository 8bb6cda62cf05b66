/**
 * MeshPointers: the arrays of a mesh of one kind of elements, as the C interface gives them.
 */
#pragma once

#include "ArrayMemory.h"
#include "Base/CartesianGrid.h"

#include "vtkCellArray.h"
#include "vtkUnstructuredGrid.h"

namespace vfm
{

/// Of each element; 0 without elements.
inline int CornersOf(vtkUnstructuredGrid* mesh)
{
  return mesh->GetNumberOfCells() > 0 ? static_cast<int>(mesh->GetCells()->GetMaxCellSize()) : 0;
}

/// CornersOf(mesh) points an element, from 0.
inline const Index* ConnectivityOf(vtkUnstructuredGrid* mesh)
{
  return static_cast<const Index*>(FindMemory(mesh->GetCells()->GetConnectivityArray()));
}

/// Three a point; null without points.
inline const double* CoordinatesOf(vtkUnstructuredGrid* mesh)
{
  return mesh->GetNumberOfPoints() > 0
    ? static_cast<const double*>(FindMemory(mesh->GetPoints()->GetData()))
    : nullptr;
}

} // namespace vfm
