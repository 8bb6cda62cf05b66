#include "InputArrays.h"

#include "Base/Runtime.h"
#include "CellOrder.h"
#include "MaterialGuess.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"

namespace vfm
{
namespace
{

std::string ArrayNames(vtkDataSetAttributes* attributes)
{
  std::string names;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const char* name = attributes->GetArrayName(i);
    names += (names.empty() ? "'" : ", '") + std::string(name ? name : "") + "'";
  }
  return names.empty() ? "none" : names;
}

/// Whether the array of that name numbers cells or points, by its name or as an attribute of VTK.
bool HoldsIds(vtkDataSetAttributes* attributes, const std::string& name)
{
  vtkAbstractArray* array = attributes->GetAbstractArray(name.c_str());
  return IsIdName(name) ||
    (array && (array == attributes->GetGlobalIds() || array == attributes->GetPedigreeIds()));
}

} // namespace

vtkDataArray* FindTuples(const InputBlock& block, const std::string& name)
{
  const std::string kind = block.Association == vtkDataObject::POINT ? "point" : "cell";
  vtkDataSetAttributes* attributes = block.Data->GetAttributes(block.Association);
  vtkDataArray* array = attributes->GetArray(name.c_str());
  if (!array)
  {
    throw InputError(block.Name + " has no numeric " + kind + " array '" + name + "'. Its " + kind +
      " arrays: " + ArrayNames(attributes) + ".");
  }
  if (array->GetNumberOfTuples() != block.NumberOfTuples())
  {
    throw InputError(block.Name + ": the " + kind + " array '" + name + "' has " +
      std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(block.NumberOfTuples()) + " " + kind + "s.");
  }
  return block.Order ? block.Order->Arrange(array) : array;
}

vtkDataArray* FindArray(const InputBlock& block, const std::string& name)
{
  vtkDataArray* array = FindTuples(block, name);
  if (array->GetNumberOfComponents() != 1)
  {
    throw InputError("The array '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()) +
      " components: an array with one value a cell is needed.");
  }
  return array;
}

vtkDataArray* FindMaterialArray(const InputBlock& block, const std::string& name)
{
  vtkDataArray* array = FindArray(block, name);
  if (HoldsIds(block.Data->GetAttributes(block.Association), name))
  {
    throw InputError("'" + name +
      "' holds ids, which number cells or points: it holds no materials. Choose other arrays, or "
      "rename it if it does.");
  }
  return array;
}

} // namespace vfm
