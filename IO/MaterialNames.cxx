#include "MaterialNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

namespace vfm
{

MaterialNames::MaterialNames(vtkUnstructuredGrid* mesh)
{
  vtkFieldData* field = mesh->GetFieldData();
  auto names = vtkStringArray::SafeDownCast(field->GetAbstractArray("MaterialNames"));
  vtkDataArray* ids = field->GetArray("MaterialIds");
  this->Names[0] = "Void";
  for (vtkIdType i = 0; names && ids && i < names->GetNumberOfValues(); ++i)
  {
    this->Names[static_cast<int>(ids->GetComponent(i, 0))] = names->GetValue(i);
  }
}

std::string MaterialNames::Name(int material) const
{
  const auto found = this->Names.find(material);
  return found == this->Names.end() ? "Material " + std::to_string(material) : found->second;
}

} // namespace vfm
