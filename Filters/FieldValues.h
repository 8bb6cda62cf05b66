/**
 * Numbers as arrays of field data.
 */
#pragma once

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace vfm
{

/// For scripts and files; views are not to offer it among the arrays of cells and points.
inline void AddHidden(vtkAbstractArray* array, vtkFieldData* field)
{
  array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  field->AddArray(array);
}

/// A value a tuple.
template <class Array, class T>
vtkSmartPointer<Array> MakeColumn(const char* name, const std::vector<T>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  return array;
}

template <class Array, class T>
void AddFieldValues(vtkFieldData* field, const char* name, const std::vector<T>& values)
{
  AddHidden(MakeColumn<Array>(name, values), field);
}

} // namespace vfm
