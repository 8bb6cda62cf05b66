#include "StateOutput.h"

#include "State/StateArrays.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

namespace vfm
{
namespace
{

/// Which travel as bytes.
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

vtkSmartPointer<vtkDataArray> Adopt(CarriedArray& carried)
{
  const int type = CarrierType(carried.Type);
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  const std::size_t values = carried.Values.size() / array->GetDataTypeSize();
  array->SetNumberOfComponents(carried.Components);
  array->SetVoidArray(carried.Values.release(), static_cast<vtkIdType>(values), 0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  array = carried.Type == type ? array : PackBits(array);
  array->SetName(carried.Name.c_str());
  for (std::size_t c = 0; c < carried.ComponentNames.size(); ++c)
  {
    if (!carried.ComponentNames[c].empty())
    {
      array->SetComponentName(static_cast<vtkIdType>(c), carried.ComponentNames[c].c_str());
    }
  }
  return array;
}

} // namespace

void SetStateOutput(CarriedState& state, vtkUnstructuredGrid* mesh)
{
  for (CarriedArray& array : state.Arrays)
  {
    mesh->GetCellData()->AddArray(Adopt(array));
  }
  if (state.NodalVelocity)
  {
    mesh->GetPointData()->AddArray(Adopt(*state.NodalVelocity));
  }
}

} // namespace vfm
