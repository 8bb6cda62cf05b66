#include "Input/GuessMaterials.h"

#include "Input/ValueType.h"

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace vfm
{
namespace
{

/// Returns the SpyPlot arrays, ordered by material number.
std::vector<std::string> FindSpyPlotFractions(const std::vector<ArrayInfo>& arrays)
{
  std::vector<std::string> names;
  for (const ArrayInfo& array : arrays)
  {
    if (IsSpyPlotFraction(array.Name))
    {
      names.push_back(array.Name);
    }
  }
  const auto number = [](const std::string& name)
  { return std::atoi(name.c_str() + name.rfind(' ') + 1); };
  std::stable_sort(names.begin(), names.end(),
    [&number](const std::string& a, const std::string& b) { return number(a) < number(b); });
  return names;
}

bool IsMaterialId(const ArrayInfo& array)
{
  return array.Name == LabelsName && IsWhole(array);
}

} // namespace

bool IsSpyPlotFraction(const std::string& name)
{
  // "Material volume fraction - 1", in newer files "Volume Fraction - 1".
  static const std::regex pattern(".*[vV]olume [fF]raction - [0-9]+");
  return std::regex_match(name, pattern);
}

bool IsWhole(const ArrayInfo& array)
{
  return array.Components == 1 && !IsRealType(array.Type);
}

bool IsFraction(const ArrayInfo& array, double tolerance)
{
  const bool isBytes = array.Type == ValueType::UnsignedChar;
  return array.Components == 1 &&
    (isBytes ||
      (IsRealType(array.Type) && array.Least >= -tolerance && array.Most <= 1.0 + tolerance));
}

GuessedMaterials GuessMaterials(
  const std::vector<ArrayInfo>& arrays, const std::vector<std::string>& others, double tolerance)
{
  GuessedMaterials found;
  found.Fractions = FindSpyPlotFractions(arrays);
  found.AreNumbered = !found.Fractions.empty();
  for (const ArrayInfo& array : arrays)
  {
    const bool isOther = std::find(others.begin(), others.end(), array.Name) != others.end();
    if (!found.AreNumbered && IsFraction(array, tolerance) && !IsMaterialId(array) && !isOther)
    {
      found.Fractions.push_back(array.Name);
    }
  }
  if (found.Fractions.empty() && std::any_of(arrays.begin(), arrays.end(), IsMaterialId))
  {
    found.Labels = LabelsName;
  }
  return found;
}

} // namespace vfm
