#include "Meshes/Exodus/ExodusVariables.h"

#include "Report/FragmentTargets.h"
#include "Report/UniqueNames.h"

#include <algorithm>
#include <iterator>

namespace vfm
{
namespace
{

constexpr std::size_t MaximumNumbers = 100;
constexpr const char* TableNames[] = { "SurfaceIds", "SurfaceParts", "EdgeFacets" }; // not listed
constexpr const char* IdNames[] = { "GlobalPointIds", "GlobalCellIds", "vtkGhostType" };

template <std::size_t Count>
bool IsOneOf(const std::string& name, const char* const (&names)[Count])
{
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Returns the ending of the name of component `place`, counted from 0.
std::string Ending(std::size_t place, std::size_t count, bool hasAxes)
{
  if (count == 1)
  {
    return "";
  }
  if (hasAxes && count <= 3)
  {
    return std::string("_") + "XYZ"[place];
  }
  const std::string number = std::to_string(place + 1);
  return "_" + std::string(std::to_string(count).size() - number.size(), '0') + number;
}

} // namespace

std::vector<ExodusVariable> ListVariables(const std::vector<MeshArray>& arrays, const void* ids)
{
  std::vector<ExodusVariable> variables;
  for (const MeshArray& array : arrays)
  {
    const bool isVariable = !IsOneOf(array.Name, IdNames) && (!ids || array.Values != ids);
    for (int c = 0; isVariable && c < array.Components; ++c)
    {
      variables.push_back(
        { PrintableName(array.Name) + Ending(c, array.Components, true), &array, c });
    }
  }
  return variables;
}

std::vector<ExodusNumber> ListNumbers(const std::vector<FieldArray>& fields)
{
  std::vector<ExodusNumber> numbers;
  for (const FieldArray& field : fields)
  {
    const std::vector<double> values = NumbersOfField(fields, field.Name);
    const bool isListed = values.size() <= MaximumNumbers && !IsOneOf(field.Name, TableNames) &&
      !IsFieldOfRank(field.Name);
    for (std::size_t i = 0; isListed && i < values.size(); ++i)
    {
      numbers.push_back({ PrintableName(field.Name) + Ending(i, values.size(), false), values[i] });
    }
  }
  return numbers;
}

} // namespace vfm
