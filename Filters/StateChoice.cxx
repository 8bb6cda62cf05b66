#include "StateChoice.h"

#include "Agreement.h"
#include "ArrayInfo.h"
#include "ArrayStems.h"
#include "CollectBlocks.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

namespace vfm
{
namespace
{

const ArrayInfo* Find(const std::vector<ArrayInfo>& arrays, const std::string& name)
{
  const auto found = std::find_if(
    arrays.begin(), arrays.end(), [&name](const ArrayInfo& array) { return array.Name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

/// Collective: what the input has of velocity and energy, of cells or points.
std::vector<ArrayInfo> FindCandidates(vtkDataObject* input, const StateChoice& choice, Ranks& ranks)
{
  std::vector<vtkSmartPointer<vtkDataSetAttributes>> kept;
  std::vector<vtkDataSetAttributes*> attributes;
  const auto keep = [&](vtkDataSetAttributes* all)
  {
    kept.push_back(vtkSmartPointer<vtkDataSetAttributes>::New());
    attributes.push_back(kept.back());
    for (int a = 0; all && a < all->GetNumberOfArrays(); ++a)
    {
      const char* name = all->GetArrayName(a);
      if (name && (name == choice.Energy || IsOfVector(name, choice.Velocity)))
      {
        kept.back()->AddArray(all->GetAbstractArray(a));
      }
    }
  };
  WorkTogether(ranks,
    [&]
    {
      for (const InputPart& part : FindParts(input, ranks.Rank(), ranks.Count() == 1))
      {
        keep(part.Data->GetAttributes(vtkDataObject::CELL));
        keep(part.Data->GetAttributes(vtkDataObject::POINT));
      }
    });
  return FindArrays(attributes, ranks);
}

/// The components of a velocity that no array holds as a whole.
std::optional<ArrayStem> FindComponents(
  const std::vector<ArrayInfo>& arrays, const std::string& velocity)
{
  const ArrayInfo* named = Find(arrays, velocity);
  if (named)
  {
    return named->Components == 1 ? FindVector(velocity) : std::nullopt;
  }
  for (const ArrayInfo& array : arrays)
  {
    const std::optional<ArrayStem> vector = FindVector(array.Name);
    const auto isThere = [&arrays](const std::string& name)
    {
      const ArrayInfo* member = Find(arrays, name);
      return member && member->Components == 1;
    };
    if (vector && vector->Name == velocity &&
      std::all_of(vector->Members.begin(), vector->Members.end(), isThere))
    {
      return vector;
    }
  }
  return std::nullopt;
}

/// Whether some of the listed arrays may be those of each material that a name is the stem of.
bool IsStem(const std::vector<std::string>& listed, const std::string& name)
{
  return std::any_of(listed.begin(), listed.end(),
    [&name](const std::string& array) { return array.find(name) != std::string::npos; });
}

} // namespace

StateChoice FindChosenState(vtkDataObject* input, StateChoice choice, Ranks& ranks)
{
  std::vector<std::string> names = choice.Densities;
  if (!choice.Velocity.empty() || !choice.Energy.empty())
  {
    const std::vector<ArrayInfo> arrays = FindCandidates(input, choice, ranks);
    const std::optional<ArrayStem> components = FindComponents(arrays, choice.Velocity);
    if (components)
    {
      choice.Velocity = components->Members[0];
      names.insert(names.end(), components->Members.begin(), components->Members.end());
    }
    for (const std::string& name : { choice.Velocity, choice.Energy })
    {
      if (!name.empty() && (Find(arrays, name) || !IsStem(choice.Arrays, name)))
      {
        names.push_back(name);
      }
    }
  }
  for (const std::string& name : names)
  {
    if (std::find(choice.Arrays.begin(), choice.Arrays.end(), name) == choice.Arrays.end())
    {
      choice.Arrays.push_back(name);
    }
  }
  return choice;
}

} // namespace vfm
