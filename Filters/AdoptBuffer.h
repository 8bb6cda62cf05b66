/**
 * AdoptBuffer: numbers of the Grid code as an array of VTK, without a copy.
 */
#pragma once

#include "Base/Buffer.h"

#include "vtkAbstractArray.h"
#include "vtkSmartPointer.h"

namespace vfm
{

/// A VTK array that owns the memory of the buffer from now on.
template <class Array, class T>
vtkSmartPointer<Array> AdoptBuffer(Buffer<T>& buffer, const char* name, int components = 1)
{
  using Value = typename Array::ValueType;
  static_assert(sizeof(Value) == sizeof(T), "the buffer must hold the array's type");
  auto array = vtkSmartPointer<Array>::New();
  const vtkIdType size = static_cast<vtkIdType>(buffer.size());
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetArray(
    reinterpret_cast<Value*>(buffer.release()), size, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

} // namespace vfm
