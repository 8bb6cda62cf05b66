#include "vtkSMMeshArrayListDomain.h"

#include "Input/ArrayNames.h"
#include "Materials/ChooseMaterials.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMStringVectorProperty.h"

#include <algorithm>
#include <cstring>
#include <vector>

vtkStandardNewMacro(vtkSMMeshArrayListDomain);

namespace
{

/// Returns whether points of the data can be centres of cells: images of one level.
bool HasCentres(vtkPVDataInformation* info)
{
  if (!info->IsCompositeDataSet())
  {
    return info->DataSetTypeIsA("vtkImageData");
  }
  const std::vector<int>& types = info->GetUniqueBlockTypes();
  return !info->DataSetTypeIsA("vtkUniformGridAMR") && !types.empty() &&
    std::all_of(types.begin(), types.end(),
      [](int type) {
        return type == VTK_IMAGE_DATA || type == VTK_UNIFORM_GRID || type == VTK_STRUCTURED_POINTS;
      });
}

vtkPVArrayInformation* FindArray(vtkPVDataInformation* info, int association, const char* name)
{
  vtkPVDataSetAttributesInformation* attributes = info->GetAttributeInformation(association);
  return attributes ? attributes->GetArrayInformation(name) : nullptr;
}

bool HoldsIds(vtkPVDataInformation* info, int association, const char* name)
{
  vtkPVDataSetAttributesInformation* attributes = info->GetAttributeInformation(association);
  const auto isAttribute = [&](int type)
  {
    vtkPVArrayInformation* array = attributes->GetAttributeInformation(type);
    return array && array->GetName() && !std::strcmp(array->GetName(), name);
  };
  return attributes &&
    (isAttribute(vtkDataSetAttributes::GLOBALIDS) ||
      isAttribute(vtkDataSetAttributes::PEDIGREEIDS));
}

/// Returns what the client knows about an array. Whether reals are integers is unknown: false.
vfm::ArrayInfo Describe(vtkPVArrayInformation* array)
{
  vfm::ArrayInfo info;
  const double* range = array->GetComponentRange(0);
  info.Name = array->GetName();
  info.Type = array->GetDataType();
  info.Components = array->GetNumberOfComponents();
  info.Least = range[0];
  info.Most = range[1];
  return info;
}

/// Arrays of one association, and their materials.
struct Choice
{
  int Association;
  std::vector<vfm::ArrayInfo> Arrays;
  vfm::MaterialChoice Materials;
};

/// Returns the choice among the arrays of an association that all blocks have.
Choice Choose(int association, vtkSMArrayListDomain& domain, vtkPVDataInformation* info)
{
  Choice choice{ association, {}, {} };
  for (unsigned int i = 0; i < domain.GetNumberOfStrings(); ++i)
  {
    const bool isOfPlace = domain.GetDomainAssociation(i) == association;
    vtkPVArrayInformation* array =
      isOfPlace ? FindArray(info, association, domain.GetString(i)) : nullptr;
    if (array && !array->GetIsPartial())
    {
      choice.Arrays.push_back(Describe(array));
    }
  }
  choice.Materials = vfm::ChooseMaterials(choice.Arrays, {});
  return choice;
}

} // namespace

bool vtkSMMeshArrayListDomain::IsFilteredArray(
  vtkPVDataInformation* info, int association, const char* name)
{
  const bool isMeshed =
    association == vtkDataObject::CELL || (association == vtkDataObject::POINT && HasCentres(info));
  return !isMeshed || !vfm::IsOffered(name) || HoldsIds(info, association, name);
}

bool vtkSMMeshArrayListDomain::IsChosen(const char* function)
{
  vtkSMProperty* property = this->GetRequiredProperty(function);
  if (!property)
  {
    return false;
  }
  const vtkSMPropertyHelper helper(property);
  const unsigned int count = helper.GetNumberOfElements();
  const std::string name = count > 0 ? helper.GetAsString(count - 1) : "";
  return !name.empty() && name != "None";
}

int vtkSMMeshArrayListDomain::SetDefaultValues(vtkSMProperty* property, bool useUnchecked)
{
  vtkPVDataInformation* info = this->GetInputDataInformation("Input");
  if (this->Role.empty() || !info || this->IsChosen("Fractions") || this->IsChosen("Labels"))
  {
    return 1;
  }
  const Choice cells = Choose(vtkDataObject::CELL, *this, info);
  const Choice points = Choose(vtkDataObject::POINT, *this, info);
  const auto isFound = [](const Choice& choice)
  { return !choice.Materials.Fractions.empty() || !choice.Materials.Labels.empty(); };
  const Choice& found = isFound(cells) ? cells : points;
  if (isFound(cells) == isFound(points) || !found.Materials.IsClear)
  {
    return 1;
  }
  const vfm::MaterialChoice& materials = found.Materials;
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUnchecked);
  if (this->Role == "labels" && !materials.Labels.empty())
  {
    helper.SetInputArrayToProcess(found.Association, materials.Labels.c_str());
  }
  // A script that chooses labels does not clear fractions that a panel would select.
  if (this->Role == "fractions" && materials.Fractions.size() == 1)
  {
    helper.Set(0, materials.Fractions[0].c_str());
  }
  return 1;
}

int vtkSMMeshArrayListDomain::ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element)
{
  const char* role = element->GetAttribute("role");
  this->Role = role ? role : "";
  return this->Superclass::ReadXMLAttributes(property, element);
}

void vtkSMMeshArrayListDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Role: " << this->Role << "\n";
}
