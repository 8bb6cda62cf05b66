#include "MeshArrays.h"

#include "Base/Runtime.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"

namespace vfm
{

vtkDataArray* FindMeshArray(vtkDataSetAttributes* data, const std::string& name)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array)
  {
    throw InputError(
      "The mesh has no array " + name + ". A mesh of Volume Fraction To Hex or To Tet is needed.");
  }
  return array;
}

vtkSmartPointer<vtkIdTypeArray> FindMeshIds(vtkDataSetAttributes* data, const std::string& name)
{
  vtkDataArray* array = FindMeshArray(data, name);
  vtkSmartPointer<vtkIdTypeArray> ids = vtkIdTypeArray::SafeDownCast(array);
  if (!ids)
  {
    ids = vtkSmartPointer<vtkIdTypeArray>::New();
    ids->DeepCopy(array);
  }
  return ids;
}

} // namespace vfm
