#include "MeshDataOfGrid.h"

#include "Report/FlatData.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <span>

namespace vfm
{
namespace
{

static_assert(sizeof(vtkIdType) == sizeof(Index), "VTK must be built with 64-bit ids");

/// Returns the values of an array in contiguous memory as a VTK type: a view, or a copy.
const void* Store(vtkDataArray* array, int type, StoredMesh& mesh)
{
  vtkSmartPointer<vtkDataArray> kept = array;
  if (array->GetDataType() != type || !array->HasStandardMemoryLayout())
  {
    kept.TakeReference(vtkDataArray::CreateDataArray(type));
    kept->DeepCopy(array);
  }
  mesh.Memory.push_back(std::make_shared<const vtkSmartPointer<vtkDataArray>>(kept));
  return kept->GetVoidPointer(0);
}

std::vector<MeshArray> ListArrays(vtkDataSetAttributes* data, StoredMesh& mesh)
{
  std::vector<MeshArray> arrays;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    if (!array || !array->GetName())
    {
      continue;
    }
    const int type = array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType();
    MeshArray view{ array->GetName(), type, array->GetNumberOfComponents(), {},
      Store(array, type, mesh) };
    for (int c = 0; array->HasAComponentName() && c < view.Components; ++c)
    {
      const char* name = array->GetComponentName(c);
      view.ComponentNames.emplace_back(name ? name : "");
    }
    arrays.push_back(std::move(view));
  }
  return arrays;
}

/// Returns the values converted to the type of another array.
template <class T, class Array>
std::vector<T> CopyNumbers(vtkDataArray* array)
{
  const auto plain = vtkSmartPointer<Array>::New();
  plain->DeepCopy(array);
  return { plain->GetPointer(0), plain->GetPointer(0) + plain->GetNumberOfValues() };
}

std::vector<FieldArray> ListFields(vtkFieldData* data)
{
  std::vector<FieldArray> fields;
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (!array->GetName())
    {
      continue;
    }
    FieldArray field{ array->GetName(), {}, array->GetNumberOfComponents() };
    if (auto* texts = vtkStringArray::SafeDownCast(array))
    {
      field.Values = std::vector<std::string>(
        texts->GetPointer(0), texts->GetPointer(0) + texts->GetNumberOfValues());
    }
    else if (auto* numbers = vtkDataArray::SafeDownCast(array))
    {
      const int size = numbers->GetDataTypeSize();
      const bool isReal =
        numbers->GetDataType() == VTK_DOUBLE || size == 0 || numbers->GetDataType() == VTK_FLOAT;
      if (isReal)
      {
        field.Values = CopyNumbers<double, vtkDoubleArray>(numbers);
      }
      else if (size == 8)
      {
        field.Values = CopyNumbers<Index, vtkTypeInt64Array>(numbers);
      }
      else
      {
        field.Values = CopyNumbers<int, vtkIntArray>(numbers);
      }
    }
    else
    {
      continue;
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

/// Returns the kind of elements of a type of VTK, or null.
const ElementShape* FindShape(int type, std::span<const ElementShape> shapes)
{
  const auto found = std::find_if(shapes.begin(), shapes.end(),
    [type](const ElementShape& shape) { return shape.VtkType == type; });
  return found == shapes.end() ? nullptr : &*found;
}

/// Returns the kind of all cells.
const ElementShape& FindShape(vtkUnstructuredGrid* mesh)
{
  const int type = mesh->GetCellType(0);
  const bool isFlat = mesh->GetFieldData()->HasArray(FlatAxisName) != 0;
  const ElementShape* known = isFlat ? FindShape(type, FlatShapes) : FindShape(type, ElementShapes);
  bool isOneKind = known != nullptr;
  for (vtkIdType cell = 0; isOneKind && cell < mesh->GetNumberOfCells(); ++cell)
  {
    isOneKind = mesh->GetCellType(cell) == type;
  }
  if (!isOneKind)
  {
    throw InputError("The mesh must be all hexahedra or all tetrahedra.");
  }
  return *known;
}

/// Sets the elements of a mesh of linear cells without a copy if possible.
const Index* KeepElements(vtkCellArray* cells, StoredMesh& mesh)
{
  const Index corners = mesh.Data.Corners, count = corners * mesh.Data.NumberOfElements;
  if (cells->IsStorage64Bit() && cells->GetNumberOfConnectivityIds() == count &&
    cells->IsHomogeneous() == corners)
  {
    vtkDataArray* connectivity = cells->GetConnectivityArray64();
    return static_cast<const Index*>(Store(connectivity, connectivity->GetDataType(), mesh));
  }
  return nullptr;
}

/// Sets the corners and mid nodes of all cells.
void SetElements(vtkCellArray* cells, StoredMesh& mesh)
{
  MeshData& data = mesh.Data;
  data.Elements = data.MidsPerElement == 0 ? KeepElements(cells, mesh) : nullptr;
  if (data.Elements)
  {
    return;
  }
  std::vector<Index> corners, mids;
  corners.reserve(data.Corners * data.NumberOfElements);
  mids.reserve(data.MidsPerElement * data.NumberOfElements);
  for (vtkIdType cell = 0; cell < data.NumberOfElements; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(cell, size, points);
    corners.insert(corners.end(), points, points + data.Corners);
    mids.insert(mids.end(), points + data.Corners, points + size);
  }
  data.Elements = mesh.Store(std::move(corners));
  data.MidPoints = mesh.Store(std::move(mids));
}

} // namespace

StoredMesh MeshDataOf(vtkUnstructuredGrid* mesh)
{
  StoredMesh stored;
  MeshData& data = stored.Data;
  data.NumberOfPoints = mesh->GetNumberOfPoints();
  data.NumberOfElements = mesh->GetNumberOfCells();
  if (data.NumberOfPoints > 0)
  {
    vtkDataArray* points = mesh->GetPoints()->GetData();
    data.Points = static_cast<const double*>(Store(points, VTK_DOUBLE, stored));
  }
  if (data.NumberOfElements > 0)
  {
    const ElementShape& shape = FindShape(mesh);
    data.Corners = shape.Corners;
    data.MidsPerElement = shape.Mids;
    SetElements(mesh->GetCells(), stored);
  }
  data.PointArrays = ListArrays(mesh->GetPointData(), stored);
  data.ElementArrays = ListArrays(mesh->GetCellData(), stored);
  data.Fields = ListFields(mesh->GetFieldData());
  PutFlatAxisFirst(data.Fields);
  vtkInformation* information = mesh->GetInformation();
  if (information->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    data.Time = information->Get(vtkDataObject::DATA_TIME_STEP());
  }
  FindKnownArrays(stored);
  return stored;
}

} // namespace vfm
