#include "StateOutput.h"

#include "AdoptBuffer.h"
#include "FieldValues.h"
#include "State/StateArrays.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <iterator>

namespace vfm
{
namespace
{

/// Converts unsigned char to bits, which are transferred as unsigned char.
vtkSmartPointer<vtkDataArray> PackBits(vtkDataArray* bytes)
{
  auto bits = vtkSmartPointer<vtkBitArray>::New();
  bits->SetNumberOfComponents(bytes->GetNumberOfComponents());
  bits->SetNumberOfTuples(bytes->GetNumberOfTuples());
  for (vtkIdType v = 0; v < bytes->GetNumberOfValues(); ++v)
  {
    const int components = bytes->GetNumberOfComponents();
    bits->SetValue(v, bytes->GetComponent(v / components, static_cast<int>(v % components)) != 0.0);
  }
  return bits;
}

vtkSmartPointer<vtkDataArray> Adopt(TransferredArray& transferred)
{
  const int type = CarrierType(transferred.Type);
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  const std::size_t values = transferred.Values.size() / array->GetDataTypeSize();
  array->SetNumberOfComponents(transferred.Components);
  array->SetVoidArray(transferred.Values.release(), static_cast<vtkIdType>(values), 0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  array = transferred.Type == type ? array : PackBits(array);
  array->SetName(transferred.Name.c_str());
  for (std::size_t c = 0; c < transferred.ComponentNames.size(); ++c)
  {
    if (!transferred.ComponentNames[c].empty())
    {
      array->SetComponentName(static_cast<vtkIdType>(c), transferred.ComponentNames[c].c_str());
    }
  }
  return array;
}

} // namespace

void SetStateOutput(OutputState& state, vtkUnstructuredGrid* mesh)
{
  for (TransferredArray& array : state.Arrays)
  {
    mesh->GetCellData()->AddArray(Adopt(array));
  }
  if (state.NodalVelocity)
  {
    mesh->GetPointData()->AddArray(Adopt(*state.NodalVelocity));
  }
}

void AddPointArrays(std::vector<TransferredArray>& arrays, vtkUnstructuredGrid* mesh)
{
  for (TransferredArray& array : arrays)
  {
    mesh->GetPointData()->AddArray(Adopt(array));
  }
}

namespace
{

template <class T>
vtkSmartPointer<ArrayOf<T>> CopyArray(
  const std::vector<T>& values, const char* name, int components = 1)
{
  Buffer<T> copy(values.size());
  std::copy(values.begin(), values.end(), copy.begin());
  return AdoptBuffer(copy, name, components);
}

bool IsOfMaterials(const FieldArray& field)
{
  return field.Name == "MaterialNames" || field.Name == "MaterialIds";
}

} // namespace

void SetParticleOutput(
  Particles& particles, const std::vector<FieldArray>& fields, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(CopyArray(particles.Positions, "Points", 3));
  output->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType p = 0; p < particles.Size(); ++p)
  {
    vertices->InsertNextCell(1, &p);
  }
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  for (TransferredArray& array : particles.Arrays)
  {
    data->AddArray(Adopt(array));
  }
  const auto add = [data](vtkDataArray* array)
  {
    if (!data->HasArray(array->GetName())) // a state array of this name stays
    {
      data->AddArray(array);
    }
  };
  add(CopyArray(particles.Ids, "Id"));
  add(CopyArray(particles.Material, "Material"));
  add(CopyArray(particles.Radius, "Radius"));
  add(CopyArray(particles.Volume, "Volume"));
  if (particles.HasMass)
  {
    add(CopyArray(particles.Mass, "Mass"));
  }
  data->SetActiveScalars("Material");
  std::vector<FieldArray> kept;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(kept), IsOfMaterials);
  AddFields(kept, output->GetFieldData());
}

} // namespace vfm
