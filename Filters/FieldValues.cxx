#include "FieldValues.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace vfm
{
namespace
{

using ArrayPointer = vtkSmartPointer<vtkAbstractArray>;

template <class Array, class T>
ArrayPointer MakeArray(const std::vector<T>& values, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  return array;
}

ArrayPointer ToArray(const std::vector<int>& values, int components)
{
  return MakeArray<vtkIntArray>(values, components);
}

ArrayPointer ToArray(const std::vector<Index>& values, int components)
{
  return MakeArray<vtkIdTypeArray>(values, components);
}

ArrayPointer ToArray(const std::vector<double>& values, int components)
{
  return MakeArray<vtkDoubleArray>(values, components);
}

ArrayPointer ToArray(const std::vector<std::string>& values, int components)
{
  return MakeArray<vtkStringArray>(values, components);
}

ArrayPointer ToArray(const FieldArray& field)
{
  const auto convert = [&field](const auto& values) { return ToArray(values, field.Components); };
  ArrayPointer array = std::visit(convert, field.Values);
  array->SetName(field.Name.c_str());
  return array;
}

} // namespace

void AddFields(const std::vector<FieldArray>& arrays, vtkFieldData* field)
{
  for (const FieldArray& values : arrays)
  {
    const auto array = ToArray(values);
    array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
    field->AddArray(array);
  }
}

void AddColumns(const std::vector<FieldArray>& arrays, vtkTable* table)
{
  for (const FieldArray& values : arrays)
  {
    table->AddColumn(ToArray(values));
  }
}

} // namespace vfm
