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

} // namespace vfm
