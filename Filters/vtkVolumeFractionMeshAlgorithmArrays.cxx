/**
 * Options and selected arrays of vtkVolumeFractionMeshAlgorithm.
 */
#include "vtkVolumeFractionMeshAlgorithm.h"

#include "BlockArraysOfData.h"
#include "CollectBlocks.h"
#include "MaterialArrays.h"
#include "Mesher.h"
#include "Options/SetOptions.h"

#include "vtkDataObject.h"

#include <algorithm>
#include <cstdlib>

namespace
{

/// Adds an item unless the list contains it.
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

/// Returns whether a text is the name of an array; panels use "None".
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
    AddItem(std::string(name), this->Options->DensityArrays, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::ClearDensityArrays()
{
  ClearItems(this->Options->DensityArrays, this);
}

void vtkVolumeFractionMeshAlgorithm::AddStateKind(const char* word)
{
  if (word && *word)
  {
    AddItem(std::string(word), this->Options->StateKinds, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::ClearStateKinds()
{
  ClearItems(this->Options->StateKinds, this);
}

void vtkVolumeFractionMeshAlgorithm::AddRotatedArray(const char* name)
{
  if (name && *name)
  {
    AddItem(std::string(name), this->Options->RotatedArrays, this);
  }
}

void vtkVolumeFractionMeshAlgorithm::ClearRotatedArrays()
{
  ClearItems(this->Options->RotatedArrays, this);
}

void vtkVolumeFractionMeshAlgorithm::SetLabelNamesFile(const char* path)
{
  this->SetText("LabelNames", path);
}

void vtkVolumeFractionMeshAlgorithm::AddRefinementBox(
  double x0, double y0, double z0, double x1, double y1, double z1, double halvings)
{
  this->Options->RefinementBoxes.push_back({ { x0, y0, z0 }, { x1, y1, z1 }, halvings });
  this->Modified();
}

void vtkVolumeFractionMeshAlgorithm::ClearRefinementBoxes()
{
  ClearItems(this->Options->RefinementBoxes, this);
}

vfm::MaterialArrays vtkVolumeFractionMeshAlgorithm::FindMaterials(
  vtkDataObject* input, vfm::Ranks& ranks) const
{
  vfm::MaterialArrays chosen{ this->VolumeFractionArrays, this->MaterialIdArray };
  if (!IsNamed(chosen.Labels.Name))
  {
    chosen.Labels.Name.clear();
  }
  return vfm::FindMaterialArrays(
    input, std::move(chosen), !this->Options->Threshold.empty(), ranks);
}

vfm::StateChoice vtkVolumeFractionMeshAlgorithm::ChooseState(
  vtkDataObject* input, vfm::Ranks& ranks) const
{
  vfm::ArrayLists arrays;
  for (const vfm::InputPart& part : vfm::FindParts(input, ranks.Rank(), ranks.Count() == 1))
  {
    for (int association : { vtkDataObject::CELL, vtkDataObject::POINT })
    {
      arrays.push_back(vfm::ArraysOf(part.Data, association));
    }
  }
  return vfm::CompleteChoice(vfm::ChooseState(*this->Options, this->StateArrays), arrays, ranks);
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
  for (const vfm::Option& option : vfm::GetOptionTable())
  {
    if (!option.OnlyTets || this->Options->Elements == vfm::ElementKind::Tets)
    {
      os << indent << option.Name << ": " << vfm::GetOption(*this->Options, option) << "\n";
    }
  }
}
