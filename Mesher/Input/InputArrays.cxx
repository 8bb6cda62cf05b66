#include "Input/InputArrays.h"

#include "Base/ParseText.h"

namespace vfm
{
namespace
{

std::string ListNames(const std::vector<std::string>& names)
{
  return names.empty() ? "none" : "'" + JoinTexts(names, "', '") + "'";
}

} // namespace

std::shared_ptr<const BlockArray> FindTuples(const InputBlock& block, const std::string& name)
{
  const std::string kind = block.ArePoints ? "point" : "cell";
  const auto array = block.Arrays->Find(name);
  if (!array)
  {
    throw InputError(block.Name + " has no numeric " + kind + " array '" + name + "'. Its " + kind +
      " arrays: " + ListNames(block.Arrays->Names()) + ".");
  }
  if (array->Tuples != block.Arrays->NumberOfTuples())
  {
    throw InputError(block.Name + ": the " + kind + " array '" + name + "' has " +
      std::to_string(array->Tuples) + " values for " +
      std::to_string(block.Arrays->NumberOfTuples()) + " " + kind + "s.");
  }
  return array;
}

std::shared_ptr<const BlockArray> FindArray(const InputBlock& block, const std::string& name)
{
  auto array = FindTuples(block, name);
  if (array->Components != 1)
  {
    throw InputError("The array '" + name + "' has " + std::to_string(array->Components) +
      " components: an array with one value per cell is needed.");
  }
  return array;
}

std::shared_ptr<const BlockArray> FindMaterialArray(
  const InputBlock& block, const std::string& name)
{
  auto array = FindArray(block, name);
  if (block.Arrays->HoldsIds(name))
  {
    throw InputError("'" + name +
      "' holds ids of cells or points, not materials. Choose other arrays, or rename this one if "
      "it holds materials.");
  }
  return array;
}

} // namespace vfm
