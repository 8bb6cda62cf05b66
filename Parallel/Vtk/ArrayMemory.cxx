#include "ArrayMemory.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace vfm
{

vtkDataArray* FindGhostTypes(vtkDataSet* data, int association)
{
  vtkDataArray* types =
    data->GetAttributes(association)->GetArray(vtkDataSetAttributes::GhostArrayName());
  return types && types->GetDataType() == VTK_UNSIGNED_CHAR ? types : nullptr;
}

vtkSmartPointer<vtkUnsignedCharArray> InMemory(vtkDataArray* ghostTypes)
{
  vtkSmartPointer<vtkUnsignedCharArray> plain = vtkUnsignedCharArray::FastDownCast(ghostTypes);
  if (ghostTypes && !plain)
  {
    plain = vtkSmartPointer<vtkUnsignedCharArray>::New();
    plain->DeepCopy(ghostTypes);
  }
  return plain;
}

} // namespace vfm
