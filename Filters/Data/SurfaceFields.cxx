#include "SurfaceFields.h"

#include "Ranks/WorkTogether.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
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

/// Adds an array that panels do not offer.
void AddHidden(vtkAbstractArray* array, vtkFieldData* fields)
{
  array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  fields->AddArray(array);
}

template <class Array, class Value>
vtkSmartPointer<Array> AddNumbers(
  const char* name, int components, const std::vector<Value>& values, vtkFieldData* fields)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName((Prefix + name).c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  AddHidden(array, fields);
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
  AddHidden(array, fields);
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
      rows[r][c] =
        static_cast<typename Row::value_type>(array->GetComponent(static_cast<vtkIdType>(r), c));
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

FlatSurfaces ReadFields(vtkDataObject* data)
{
  vtkFieldData* fields = data ? data->GetFieldData() : nullptr;
  if (!fields || !fields->GetArray((Prefix + "Triangles").c_str()))
  {
    return {};
  }
  return { ReadRows<Vector3>("Points", 3, fields), ReadRows<PointTriangle>("Triangles", 3, fields),
    ReadInts("Bodies", fields), ReadInts("Patches", fields), ReadTexts("Names", fields),
    ReadTexts("PatchNames", fields) };
}

/// Reads the fields of the data object, or of its first block that has them.
FlatSurfaces ReadFirst(vtkDataObject* data)
{
  FlatSurfaces found = ReadFields(data);
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return found;
  }
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal() && found.Triangles.empty();
       block->GoToNextItem())
  {
    found = ReadFields(block->GetCurrentDataObject());
  }
  return found;
}

} // namespace

void AddSurfaceFields(const FlatSurfaces& surfaces, vtkFieldData* fields)
{
  if (surfaces.Triangles.empty())
  {
    return;
  }
  CopyRows(surfaces.Points, AddNumbers<vtkDoubleArray>("Points", 3, surfaces.Points, fields).Get());
  const auto triangles = AddNumbers<vtkTypeInt64Array>("Triangles", 3, surfaces.Triangles, fields);
  for (std::size_t t = 0; t < surfaces.Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangles->SetComponent(
        static_cast<vtkIdType>(t), i, static_cast<double>(surfaces.Triangles[t][i]));
    }
  }
  AddInts("Bodies", surfaces.Bodies, fields);
  AddInts("Patches", surfaces.Patches, fields);
  AddTexts("Names", surfaces.Names, fields);
  AddTexts("PatchNames", surfaces.PatchNames, fields);
}

void RemoveSurfaceFields(vtkFieldData* fields)
{
  for (const char* name : { "Points", "Triangles", "Bodies", "Patches", "Names", "PatchNames" })
  {
    fields->RemoveArray((Prefix + name).c_str());
  }
}

std::shared_ptr<const InputSurfaces> FindSurfaces(vtkDataObject* data, Ranks& ranks)
{
  std::shared_ptr<const InputSurfaces> surfaces;
  WorkTogether(ranks,
    [&]
    {
      const FlatSurfaces flat = ShareSurfaces(ReadFirst(data), ranks);
      if (!flat.Triangles.empty())
      {
        PrefixErrors("The field data InputSurface..: ",
          [&] { surfaces = std::make_shared<const InputSurfaces>(RestoreSurfaces(flat)); });
      }
    });
  return surfaces;
}

} // namespace vfm
