#include "vtkSMMeshArrayListDomain.h"

#include "Input/MaterialGuess.h"

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

vfm::MaterialGuess Guess(vtkPVArrayInformation* array)
{
  const double* range = array->GetComponentRange(0);
  const vfm::MaterialGuess guess = vfm::GuessMaterial(array->GetDataType(), range[0], range[1]);
  const bool isWhole = !array->GetIsPartial() || guess == vfm::MaterialGuess::Nothing;
  return isWhole ? guess : vfm::MaterialGuess::Unclear;
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
  int candidates = 0, association = 0;
  vfm::MaterialGuess found = vfm::MaterialGuess::Nothing;
  std::string name;
  for (unsigned int i = 0; i < this->GetNumberOfStrings(); ++i)
  {
    vtkPVArrayInformation* array =
      FindArray(info, this->GetDomainAssociation(i), this->GetString(i));
    if (array && Guess(array) != vfm::MaterialGuess::Nothing)
    {
      ++candidates;
      found = Guess(array);
      name = this->GetString(i);
      association = this->GetDomainAssociation(i);
    }
  }
  const vfm::MaterialGuess requested =
    this->Role == "labels" ? vfm::MaterialGuess::Labels : vfm::MaterialGuess::Fraction;
  if (candidates == 1 && found == requested)
  {
    vtkSMPropertyHelper helper(property);
    helper.SetUseUnchecked(useUnchecked);
    if (this->Role == "labels")
    {
      helper.SetInputArrayToProcess(association, name.c_str());
    }
    else
    {
      helper.Set(0, name.c_str());
    }
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
