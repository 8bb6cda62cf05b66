#include "State/StateChoice.h"

#include "State/ArrayStems.h"

#include <algorithm>

namespace vfm
{
namespace
{

const StateCandidate* Find(const std::vector<StateCandidate>& arrays, const std::string& name)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [&name](const StateCandidate& array) { return array.Name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

/// Returns the components of a velocity that is not a single array.
std::optional<ArrayStem> FindComponents(
  const std::vector<StateCandidate>& arrays, const std::string& velocity)
{
  const StateCandidate* named = Find(arrays, velocity);
  if (named)
  {
    return named->Components == 1 ? FindVector(velocity) : std::nullopt;
  }
  for (const StateCandidate& array : arrays)
  {
    const std::optional<ArrayStem> vector = FindVector(array.Name);
    const auto isThere = [&arrays](const std::string& name)
    {
      const StateCandidate* member = Find(arrays, name);
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

/// Returns whether a name may be the common part of listed arrays, one per material.
bool IsStem(const std::vector<std::string>& listed, const std::string& name)
{
  return std::any_of(listed.begin(), listed.end(),
    [&name](const std::string& array) { return array.find(name) != std::string::npos; });
}

} // namespace

bool ConservesState(TransferMode how, const std::vector<std::string>& densities)
{
  return how == TransferMode::Conserve || (how == TransferMode::Automatic && !densities.empty());
}

StateChoice ChooseState(const MesherOptions& options, std::vector<std::string> arrays)
{
  if (!ConservesState(options.StateTransfer, options.DensityArrays))
  {
    return { false, std::move(arrays), {}, {}, {}, {}, options.RotatedArrays };
  }
  return { true, std::move(arrays), options.DensityArrays, options.StateKinds,
    options.VelocityArray, options.EnergyArray, options.RotatedArrays };
}

bool IsCandidate(const std::string& name, const StateChoice& choice)
{
  return name == choice.Energy || IsOfVector(name, choice.Velocity);
}

StateChoice CompleteChoice(StateChoice choice, const std::vector<StateCandidate>& candidates)
{
  std::vector<std::string> names = choice.Densities;
  const std::optional<ArrayStem> components =
    choice.Velocity.empty() ? std::nullopt : FindComponents(candidates, choice.Velocity);
  if (components)
  {
    choice.Velocity = components->Members[0];
    names.insert(names.end(), components->Members.begin(), components->Members.end());
  }
  for (const std::string& name : { choice.Velocity, choice.Energy })
  {
    if (!name.empty() && (Find(candidates, name) || !IsStem(choice.Arrays, name)))
    {
      names.push_back(name);
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

StateChoice CompleteChoice(StateChoice choice, const ArrayLists& mine, Ranks& ranks)
{
  std::vector<StateCandidate> candidates;
  if (choice.Velocity.empty() && choice.Energy.empty())
  {
    return CompleteChoice(std::move(choice), candidates);
  }
  std::vector<ArrayInfo> arrays;
  for (const std::shared_ptr<const BlockArrays>& list : mine)
  {
    for (const std::string& name : list->Names())
    {
      const auto array = IsCandidate(name, choice) ? list->Find(name) : nullptr;
      if (array && array->Tuples > 0)
      {
        AddArray(arrays, { name, array->Type, array->Components });
      }
    }
  }
  for (const ArrayInfo& array : UnionOfArrays(arrays, ranks))
  {
    candidates.push_back({ array.Name, array.Components });
  }
  return CompleteChoice(std::move(choice), candidates);
}

} // namespace vfm
