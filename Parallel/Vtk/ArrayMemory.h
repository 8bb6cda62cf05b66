/**
 * ArrayMemory: direct access to the values of VTK arrays that store them contiguously. Arrays of
 * bits, arrays with separate memory per component and arrays that compute their values do not.
 */
#pragma once

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkUnsignedCharArray;

namespace vfm
{

/// Returns the memory of all values, tuple by tuple; null if they are not stored contiguously.
inline void* FindMemory(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(auto* plain = vtkAOSDataArrayTemplate<VTK_TT>::FastDownCast(array);
                     return plain ? plain->GetPointer(0) : nullptr);
  }
  return nullptr;
}

/// Returns the array vtkGhostType of cells or points, or null if there is none.
/// @param association  vtkDataObject::CELL or vtkDataObject::POINT
vtkDataArray* FindGhostTypes(vtkDataSet* data, int association);

/// Returns the array if it is a vtkUnsignedCharArray, otherwise a copy that is; null for null.
vtkSmartPointer<vtkUnsignedCharArray> InMemory(vtkDataArray* ghostTypes);

} // namespace vfm
