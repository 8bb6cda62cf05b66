/**
 * The arrays that vtkVolumeFractionMeshAlgorithm is told to read.
 */
#include "vtkVolumeFractionMeshAlgorithm.h"

#include "MaterialArrays.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <cstdlib>

namespace
{

/// Adds what the list does not hold yet.
template <class Item>
void AddItem(const Item& item, std::vector<Item>& items, vtkObject* owner)
{
  if (std::find(items.begin(), items.end(), item) == items.end())
  {
    items.push_back(item);
    owner->Modified();
  }
}

template <class Item>
void ClearItems(std::vector<Item>& items, vtkObject* owner)
{
  if (!items.empty())
  {
    items.clear();
    owner->Modified();
  }
}

template <class Item>
const Item* ItemAt(const std::vector<Item>& items, int index)
{
  const bool valid = index >= 0 && index < static_cast<int>(items.size());
  return valid ? &items[index] : nullptr;
}

/// As panels name an array, or none.
bool IsNamed(const std::string& array)
{
  return !array.empty() && array != "None";
}

void PrintArray(ostream& os, const vfm::ChosenArray& array)
{
  os << " '" << array.Name << "'";
  if (array.Association != vfm::AnyAssociation)
  {
    os << (array.Association == vtkDataObject::CELL ? " of cells" : " of points");
  }
}

} // namespace

void vtkVolumeFractionMeshAlgorithm::AddVolumeFractionArray(const char* name)
{
  this->AddVolumeFractionArray(vfm::AnyAssociation, name);
}

void vtkVolumeFractionMeshAlgorithm::AddVolumeFractionArray(int association, const char* name)
{
  if (name && *name)
  {
    AddItem(vfm::ChosenArray{ name, association }, this->VolumeFractionArrays, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::AddVolumeFractionWord(const char* word)
{
  const std::string text = word ? word : "";
  if (text == "POINTS" || text == "CELLS")
  {
    this->WordAssociation = text == "CELLS" ? vtkDataObject::CELL : vtkDataObject::POINT;
    return;
  }
  this->AddVolumeFractionArray(this->WordAssociation, word);
}

void vtkVolumeFractionMeshAlgorithm::ClearVolumeFractionArrays()
{
  this->WordAssociation = vfm::AnyAssociation;
  ClearItems(this->VolumeFractionArrays, this);
}

int vtkVolumeFractionMeshAlgorithm::GetNumberOfVolumeFractionArrays()
{
  return static_cast<int>(this->VolumeFractionArrays.size());
}

const char* vtkVolumeFractionMeshAlgorithm::GetVolumeFractionArray(int index)
{
  const vfm::ChosenArray* array = ItemAt(this->VolumeFractionArrays, index);
  return array ? array->Name.c_str() : nullptr;
}

void vtkVolumeFractionMeshAlgorithm::SetMaterialIdArray(const char* name)
{
  this->SetMaterialIdArray(vfm::AnyAssociation, name);
}

void vtkVolumeFractionMeshAlgorithm::SetMaterialIdArray(int association, const char* name)
{
  const vfm::ChosenArray array{ name ? name : "", association };
  if (!(array == this->MaterialIdArray))
  {
    this->MaterialIdArray = array;
    this->Modified();
  }
}

void vtkVolumeFractionMeshAlgorithm::SetMaterialIdArray(
  const char*, const char*, const char*, const char* association, const char* name)
{
  const bool isAny = !association || !*association;
  this->SetMaterialIdArray(isAny ? vfm::AnyAssociation : std::atoi(association), name);
}

void vtkVolumeFractionMeshAlgorithm::AddStateArray(const char* name)
{
  if (name && *name)
  {
    AddItem(std::string(name), this->StateArrays, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::ClearStateArrays()
{
  ClearItems(this->StateArrays, this);
}

int vtkVolumeFractionMeshAlgorithm::GetNumberOfStateArrays()
{
  return static_cast<int>(this->StateArrays.size());
}

const char* vtkVolumeFractionMeshAlgorithm::GetStateArray(int index)
{
  const std::string* name = ItemAt(this->StateArrays, index);
  return name ? name->c_str() : nullptr;
}

std::string vtkVolumeFractionMeshAlgorithm::GetNamedRefinementArray() const
{
  const bool isUsed = this->Refinement == REFINEMENT_AUTOMATIC && IsNamed(this->RefinementArray);
  return isUsed ? this->RefinementArray : "";
}

vfm::MaterialArrays vtkVolumeFractionMeshAlgorithm::FindMaterials(
  vtkDataObject* input, vfm::Ranks& ranks) const
{
  vfm::MaterialArrays chosen{ this->VolumeFractionArrays, this->MaterialIdArray };
  if (!IsNamed(chosen.Labels.Name))
  {
    chosen.Labels.Name.clear();
  }
  return vfm::FindMaterialArrays(input, std::move(chosen), ranks);
}

vfm::ArraysToRead vtkVolumeFractionMeshAlgorithm::ListArrays(
  const vfm::MaterialArrays& materials) const
{
  vfm::ArraysToRead arrays;
  arrays.Materials = materials.Fractions;
  if (materials.HasLabels())
  {
    arrays.Materials.push_back(materials.Labels);
  }
  for (const std::string& name : this->StateArrays)
  {
    arrays.Others.push_back({ name, vfm::AnyAssociation });
  }
  const std::string refinement = this->GetNamedRefinementArray();
  if (!refinement.empty())
  {
    arrays.Others.push_back({ refinement, vfm::AnyAssociation });
  }
  return arrays;
}

void vtkVolumeFractionMeshAlgorithm::PrintArrays(ostream& os, vtkIndent indent) const
{
  os << indent << "VolumeFractionArrays:";
  for (const vfm::ChosenArray& array : this->VolumeFractionArrays)
  {
    PrintArray(os, array);
  }
  os << "\n" << indent << "MaterialIdArray:";
  if (IsNamed(this->MaterialIdArray.Name))
  {
    PrintArray(os, this->MaterialIdArray);
  }
  os << "\n" << indent << "StateArrays:";
  for (const std::string& name : this->StateArrays)
  {
    os << " '" << name << "'";
  }
  os << "\n" << indent << "RefinementArray: " << this->RefinementArray << "\n";
}
