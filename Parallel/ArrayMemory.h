/**
 * ArrayMemory: the values of an array of VTK where they lie one after the other, of whatever type. They lie otherwise in arrays of bits, in
 * those with memory of its own for each component, and in those that compute their values.
 */
#pragma once

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkUnsignedCharArray;

namespace vfm
{

/// All values, tuple by tuple; null where they lie otherwise.
inline void* FindMemory(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    vtkTemplateMacro(auto* plain = vtkAOSDataArrayTemplate<VTK_TT>::FastDownCast(array);
                     return plain ? plain->GetPointer(0) : nullptr);
  }
  return nullptr;
}

/// What is said of cells or points (vtkGhostType), as it lies; null when nothing is. association: vtkDataObject::CELL or POINT.
vtkDataArray* FindGhostTypes(vtkDataSet* data, int association);

/// The same, copied where it lies otherwise; null of null.
vtkSmartPointer<vtkUnsignedCharArray> InMemory(vtkDataArray* ghostTypes);

} // namespace vfm
