#include "FieldValues.h"

#include "AdoptBuffer.h"

#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkTable.h"

namespace vfm
{
namespace
{

using ArrayPointer = vtkSmartPointer<vtkAbstractArray>;

template <class T>
ArrayPointer ToArray(const std::vector<T>& values, int components)
{
  auto array = vtkSmartPointer<ArrayOf<T>>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  return array;
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
