#include "InputArrays.h"

#include "Base/Runtime.h"
#include "CellOrder.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

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

} // namespace

vtkDataArray* FindCellArray(const InputBlock& block, const std::string& name)
{
  vtkDataArray* array = block.Data->GetCellData()->GetArray(name.c_str());
  if (!array && block.Data->GetPointData()->HasArray(name.c_str()))
  {
    throw InputError("'" + name +
      "' is point data. Cell data is needed: apply ParaView's filter Point Data to Cell Data "
      "first.");
  }
  if (!array)
  {
    throw InputError(block.Name + " has no numeric cell array '" + name +
      "'. Its cell arrays: " + ArrayNames(block.Data->GetCellData()) + ".");
  }
  if (array->GetNumberOfTuples() != block.Data->GetNumberOfCells())
  {
    throw InputError(block.Name + ": the cell array '" + name + "' has " +
      std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(block.Data->GetNumberOfCells()) + " cells.");
  }
  return block.Order ? block.Order->Arrange(array) : array;
}

vtkDataArray* FindArray(const InputBlock& block, const std::string& name)
{
  vtkDataArray* array = FindCellArray(block, name);
  if (array->GetNumberOfComponents() != 1)
  {
    throw InputError("The cell array '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()) +
      " components: an array with one value a cell is needed.");
  }
  return array;
}

} // namespace vfm
