/**
 * AdoptBuffer: makes a VTK array from a buffer without a copy.
 */
#pragma once

#include "Base/Buffer.h"
#include "Base/IndexBox.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <type_traits>

namespace vfm
{

///@{ The VTK array type for values of a type. The functions are only declared.
vtkDoubleArray* ArrayFor(double);
vtkFloatArray* ArrayFor(float);
vtkIdTypeArray* ArrayFor(Index);
vtkIntArray* ArrayFor(int);
vtkStringArray* ArrayFor(const std::string&);
template <class T>
using ArrayOf = std::remove_pointer_t<decltype(ArrayFor(T()))>;
///@}

/// Returns a VTK array that takes over the memory of a buffer, which is empty afterwards.
template <class T, class Array = ArrayOf<T>>
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
