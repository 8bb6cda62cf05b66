#include "SurfaceFields.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

namespace vfm
{
namespace
{

const std::string Prefix = "InputSurface";

template <class Array, class Value>
vtkSmartPointer<Array> AddNumbers(
  const char* name, int components, const std::vector<Value>& values, vtkFieldData* fields)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName((Prefix + name).c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  fields->AddArray(array);
  return array;
}

template <class Row, class Array>
void CopyRows(const std::vector<Row>& rows, Array* to)
{
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    to->SetTypedTuple(static_cast<vtkIdType>(r), rows[r].data());
  }
}

void AddInts(const char* name, const std::vector<int>& values, vtkFieldData* fields)
{
  const auto array = AddNumbers<vtkIntArray>(name, 1, values, fields);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
}

void AddTexts(const char* name, const std::vector<std::string>& texts, vtkFieldData* fields)
{
  vtkNew<vtkStringArray> array;
  array->SetName((Prefix + name).c_str());
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  fields->AddArray(array);
}

/// Returns rows of numbers; none if the array is missing or has another number of components.
template <class Row>
std::vector<Row> ReadRows(const char* name, int components, vtkFieldData* fields)
{
  vtkDataArray* array = fields->GetArray((Prefix + name).c_str());
  std::vector<Row> rows;
  if (!array || array->GetNumberOfComponents() != components)
  {
    return rows;
  }
  rows.resize(array->GetNumberOfTuples());
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    for (int c = 0; c < components; ++c)
    {
      rows[r][c] = static_cast<typename Row::value_type>(
        array->GetComponent(static_cast<vtkIdType>(r), c));
    }
  }
  return rows;
}

std::vector<int> ReadInts(const char* name, vtkFieldData* fields)
{
  std::vector<int> numbers;
  for (const auto& row : ReadRows<std::array<int, 1>>(name, 1, fields))
  {
    numbers.push_back(row[0]);
  }
  return numbers;
}

std::vector<std::string> ReadTexts(const char* name, vtkFieldData* fields)
{
  std::vector<std::string> texts;
  auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray((Prefix + name).c_str()));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    texts.push_back(array->GetValue(i));
  }
  return texts;
}

FlatSurfaces ReadFields(vtkFieldData* fields)
{
  if (!fields || !fields->GetArray((Prefix + "Triangles").c_str()))
  {
    return {};
  }
  return { ReadRows<Vector3>("Points", 3, fields), ReadRows<PointTriangle>("Triangles", 3, fields),
    ReadInts("Bodies", fields), ReadInts("Patches", fields), ReadTexts("Names", fields),
    ReadTexts("PatchNames", fields) };
}

} // namespace

void AddSurfaceFields(const FlatSurfaces& surfaces, vtkFieldData* fields)
{
  if (surfaces.Triangles.empty())
  {
    return;
  }
  CopyRows(surfaces.Points,
    AddNumbers<vtkDoubleArray>("Points", 3, surfaces.Points, fields).Get());
  const auto triangles = AddNumbers<vtkTypeInt64Array>("Triangles", 3, surfaces.Triangles, fields);
  for (std::size_t t = 0; t < surfaces.Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangles->SetComponent(static_cast<vtkIdType>(t), i,
        static_cast<double>(surfaces.Triangles[t][i]));
    }
  }
  AddInts("Bodies", surfaces.Bodies, fields);
  AddInts("Patches", surfaces.Patches, fields);
  AddTexts("Names", surfaces.Names, fields);
  AddTexts("PatchNames", surfaces.PatchNames, fields);
}

FlatSurfaces FindSurfaceFields(vtkDataObject* data)
{
  FlatSurfaces found = ReadFields(data->GetFieldData());
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite || !found.Triangles.empty())
  {
    return found;
  }
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal() && found.Triangles.empty();
       block->GoToNextItem())
  {
    found = ReadFields(block->GetCurrentDataObject()->GetFieldData());
  }
  return found;
}

} // namespace vfm
