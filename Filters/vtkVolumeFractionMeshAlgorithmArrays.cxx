/**
 * The arrays that vtkVolumeFractionMeshAlgorithm is told to read.
 */
#include "vtkVolumeFractionMeshAlgorithm.h"

#include "ChosenState.h"
#include "MaterialArrays.h"
#include "Mesher.h"

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

const char* TextAt(const std::vector<std::string>& texts, int index)
{
  const std::string* text = ItemAt(texts, index);
  return text ? text->c_str() : nullptr;
}

void PrintTexts(
  ostream& os, vtkIndent indent, const char* name, const std::vector<std::string>& texts)
{
  os << indent << name << ":";
  for (const std::string& text : texts)
  {
    os << " '" << text << "'";
  }
  os << "\n";
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
  return TextAt(this->StateArrays, index);
}

void vtkVolumeFractionMeshAlgorithm::AddDensityArray(const char* name)
{
  if (name && *name)
  {
    AddItem(std::string(name), this->DensityArrays, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::ClearDensityArrays()
{
  ClearItems(this->DensityArrays, this);
}

int vtkVolumeFractionMeshAlgorithm::GetNumberOfDensityArrays()
{
  return static_cast<int>(this->DensityArrays.size());
}

const char* vtkVolumeFractionMeshAlgorithm::GetDensityArray(int index)
{
  return TextAt(this->DensityArrays, index);
}

void vtkVolumeFractionMeshAlgorithm::AddStateKind(const char* word)
{
  if (word && *word)
  {
    AddItem(std::string(word), this->StateKinds, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::ClearStateKinds()
{
  ClearItems(this->StateKinds, this);
}

int vtkVolumeFractionMeshAlgorithm::GetNumberOfStateKinds()
{
  return static_cast<int>(this->StateKinds.size());
}

const char* vtkVolumeFractionMeshAlgorithm::GetStateKind(int index)
{
  return TextAt(this->StateKinds, index);
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

bool vtkVolumeFractionMeshAlgorithm::IsStateConserved() const
{
  return this->StateTransfer == STATE_CONSERVE ||
    (this->StateTransfer == STATE_AUTOMATIC && !this->DensityArrays.empty());
}

vfm::StateChoice vtkVolumeFractionMeshAlgorithm::ChooseState(
  vtkDataObject* input, vfm::Ranks& ranks) const
{
  vfm::StateChoice choice;
  choice.Arrays = this->StateArrays;
  choice.IsConserved = this->IsStateConserved();
  if (choice.IsConserved)
  {
    choice.Densities = this->DensityArrays;
    choice.Kinds = this->StateKinds;
    choice.Velocity = IsNamed(this->VelocityArray) ? this->VelocityArray : "";
    choice.Energy = IsNamed(this->EnergyArray) ? this->EnergyArray : "";
    return vfm::FindChosenState(input, std::move(choice), ranks);
  }
  return choice;
}

void vtkVolumeFractionMeshAlgorithm::SetStateOptions(vfm::MesherOptions& options) const
{
  options.StateOrder = this->StateOrder;
  options.UnmeshedMaterial = static_cast<vfm::Unmeshed>(this->UnmeshedMaterial);
  options.NodalVelocity = this->NodalVelocity;
  options.LostKineticEnergy = static_cast<vfm::LostEnergy>(this->LostKineticEnergy);
}

vfm::ArraysToRead vtkVolumeFractionMeshAlgorithm::ListArrays(
  const vfm::MaterialArrays& materials, const vfm::StateChoice& state) const
{
  vfm::ArraysToRead arrays;
  arrays.Materials = materials.Fractions;
  if (materials.HasLabels())
  {
    arrays.Materials.push_back(materials.Labels);
  }
  for (const std::string& name : state.Arrays)
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
  os << "\n";
  PrintTexts(os, indent, "StateArrays", this->StateArrays);
  os << indent << "StateTransfer: " << this->StateTransfer << "\n";
  PrintTexts(os, indent, "DensityArrays", this->DensityArrays);
  PrintTexts(os, indent, "StateKinds", this->StateKinds);
  os << indent << "StateOrder: " << this->StateOrder << "\n";
  os << indent << "VelocityArray: " << this->VelocityArray << "\n";
  os << indent << "EnergyArray: " << this->EnergyArray << "\n";
  os << indent << "NodalVelocity: " << this->NodalVelocity << "\n";
  os << indent << "LostKineticEnergy: " << this->LostKineticEnergy << "\n";
  os << indent << "UnmeshedMaterial: " << this->UnmeshedMaterial << "\n";
  os << indent << "RefinementArray: " << this->RefinementArray << "\n";
}
