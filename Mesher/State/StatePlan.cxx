#include "State/StatePlan.h"

#include "Base/ParseText.h"
#include "Input/ValueType.h"
#include "Ranks/Errors.h"
#include "State/ArrayStems.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace vfm
{
namespace
{

const std::map<std::string, StateMeaning> Meanings{ { "volume", StateMeaning::PerVolume },
  { "mass", StateMeaning::PerMass }, { "cell", StateMeaning::PerCell },
  { "extensive", StateMeaning::Extensive } };
constexpr const char* KindsText = "mass, volume, cell, extensive, copy, or mass*other with the "
                                  "name of another state array";

std::string Quote(const std::string& name)
{
  return "'" + name + "'";
}

/// The kind of an array, from an entry name=kind.
struct StateKindWord
{
  std::string Name;
  bool IsCopy = false;
  StateMeaning Meaning = StateMeaning::PerMass;
  std::string Weight; ///< empty: none

  bool IsSameKind(const StateKindWord& other) const
  {
    return std::tie(this->IsCopy, this->Meaning, this->Weight) ==
      std::tie(other.IsCopy, other.Meaning, other.Weight);
  }
};

/// Reads the kind after the "="; returns false if it is not a kind.
bool ReadKind(const std::string& text, StateKindWord& word)
{
  const std::size_t star = text.find('*');
  if (star != std::string::npos && TrimText(text.substr(0, star)) == "mass")
  {
    word.Weight = TrimText(text.substr(star + 1));
    return !word.Weight.empty();
  }
  const auto found = Meanings.find(text);
  word.IsCopy = text == "copy";
  word.Meaning = found == Meanings.end() ? StateMeaning::PerMass : found->second;
  return word.IsCopy || found != Meanings.end();
}

/// Reads an entry name=kind. Names may contain "=": the first "=" that precedes a kind
/// separates them.
StateKindWord ReadWord(const std::string& text)
{
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1))
  {
    StateKindWord word;
    word.Name = TrimText(text.substr(0, at));
    if (!word.Name.empty() && ReadKind(TrimText(text.substr(at + 1)), word))
    {
      return word;
    }
  }
  throw InputError("The state kind " + Quote(text) +
    " is not valid: write array=kind, such as pressure=volume. Kinds: " + KindsText + ".");
}

/// State arrays that become one array of the mesh.
struct StateGroup
{
  std::string Name;
  std::vector<std::size_t> States;
  bool IsVector = false;
};

struct Work
{
  const StateChoice& Choice;
  const std::vector<StateArray>& States;
  const Materials& Table;
  const MaterialStems Stems{ Table.Names, Table.Labels };
  std::map<std::string, StateKindWord> Words{};
  std::vector<std::string> Weights{}; // name of the weight of each conserved array
  StatePlan Plan{};
};

const StateKindWord* FindWord(const Work& work, const std::string& name)
{
  const auto found = work.Words.find(TrimText(name));
  return found == work.Words.end() ? nullptr : &found->second;
}

/// Returns the entry of a group, by its name or the name of one of its arrays.
const StateKindWord* FindWord(const Work& work, const StateGroup& group)
{
  const StateKindWord* word = FindWord(work, group.Name);
  for (std::size_t s : group.States)
  {
    const StateKindWord* own = FindWord(work, work.States[s].Name);
    if (word && own && !word->IsSameKind(*own))
    {
      throw InputError("The state kinds of " + Quote(word->Name) + " and " + Quote(own->Name) +
        " differ, but they are one array of the mesh, " + Quote(group.Name) + ".");
    }
    word = word ? word : own;
  }
  return word;
}

bool IsDensity(const Work& work, const std::string& name)
{
  const std::vector<std::string>& densities = work.Choice.Densities;
  return std::find(densities.begin(), densities.end(), name) != densities.end();
}

bool IsDensity(const Work& work, const StateGroup& group)
{
  return std::any_of(group.States.begin(), group.States.end(),
    [&](std::size_t s) { return IsDensity(work, work.States[s].Name); });
}

/// Returns whether a group is the velocity or the energy, by its name or the name of an array.
bool IsPerMass(const Work& work, const StateGroup& group)
{
  const auto isChosen = [&](const std::string& name)
  { return name == work.Choice.Velocity || name == work.Choice.Energy; };
  return isChosen(group.Name) ||
    std::any_of(group.States.begin(), group.States.end(),
      [&](std::size_t s) { return isChosen(work.States[s].Name); });
}

/// Returns whether a group is copied; integers are, unless they are density, velocity or energy.
bool IsCopied(const Work& work, const StateGroup& group)
{
  const StateKindWord* word = FindWord(work, group);
  return word ? word->IsCopy
              : !IsRealType(work.States[group.States[0]].Type) && !IsDensity(work, group) &&
      !IsPerMass(work, group);
}

/// Returns the index of a state, or -1.
int FindState(const Work& work, const std::string& name)
{
  const auto found = std::find_if(work.States.begin(), work.States.end(),
    [&name](const StateArray& state) { return state.Name == name; });
  return found == work.States.end() ? -1 : static_cast<int>(found - work.States.begin());
}

/// Returns the arrays of the components of the velocity, if its x component is an array.
StateGroup FindVelocity(const Work& work)
{
  StateGroup group;
  const int x = FindState(work, work.Choice.Velocity);
  const std::optional<ArrayStem> vector = FindVector(work.Choice.Velocity);
  if (vector && x >= 0 && work.States[x].Components == 1)
  {
    if (!work.Stems.FindStems(work.Choice.Velocity).empty() &&
      !FindWord(work, work.Choice.Velocity))
    {
      throw InputError("The velocity array " + Quote(work.Choice.Velocity) +
        " is a component of one material's velocity, by its name. Make one vector array per "
        "material, or set its kind for all materials (state kind " +
        work.Choice.Velocity + "=mass).");
    }
    group = { vector->Name, {}, true };
    for (const std::string& member : vector->Members)
    {
      group.States.push_back(FindState(work, member)); // CompleteChoice added all of them
    }
  }
  return group;
}

[[noreturn]] void RejectPartial(const Work& work, const std::string& name, const ArrayStem& stem)
{
  std::size_t missing = 0;
  while (FindState(work, stem.Members[missing]) >= 0)
  {
    ++missing;
  }
  throw InputError("The state array " + Quote(name) +
    " belongs to one material, by its name, and of the material " +
    Quote(work.Table.Names[missing + 1]) +
    " no array is selected: " + Quote(stem.Members[missing]) +
    ". Select the arrays of all materials, or set its kind for all materials (state kind " + name +
    (IsDensity(work, name) ? "=volume" : "=mass") + ", or another).");
}

StateGroup FindGroup(const Work& work, std::size_t state)
{
  const StateGroup alone{ work.States[state].Name, { state } };
  const StateGroup velocity = FindVelocity(work);
  if (std::find(velocity.States.begin(), velocity.States.end(), state) != velocity.States.end())
  {
    return velocity;
  }
  const std::vector<ArrayStem> stems = work.Stems.FindStems(alone.Name);
  for (const ArrayStem& stem : stems)
  {
    StateGroup group{ stem.Name, {} };
    for (const std::string& member : stem.Members)
    {
      const int place = FindState(work, member);
      if (place >= 0)
      {
        group.States.push_back(place);
      }
    }
    if (group.States.size() == stem.Members.size())
    {
      return group;
    }
  }
  if (!stems.empty() && !IsCopied(work, alone) && !FindWord(work, alone.Name))
  {
    RejectPartial(work, alone.Name, stems[0]);
  }
  return alone;
}

/// Returns the groups of arrays per material and of components, and single arrays, in the order of
/// the states.
std::vector<StateGroup> FindGroups(const Work& work)
{
  std::vector<StateGroup> groups;
  std::vector<bool> isTaken(work.States.size(), false);
  for (std::size_t s = 0; s < work.States.size(); ++s)
  {
    if (!isTaken[s])
    {
      groups.push_back(FindGroup(work, s));
      for (std::size_t member : groups.back().States)
      {
        isTaken[member] = true;
      }
    }
  }
  return groups;
}

void Place(Work& work, const StateGroup& group)
{
  if (IsCopied(work, group))
  {
    work.Plan.Copied.insert(work.Plan.Copied.end(), group.States.begin(), group.States.end());
    return;
  }
  ConservedArray array;
  array.Name = group.Name;
  array.States = group.States;
  array.IsVector = group.IsVector;
  const int components = work.States[group.States[0]].Components;
  array.Components = group.IsVector ? 3 : components;
  const StateKindWord* word = FindWord(work, group);
  array.Meaning = word       ? word->Meaning
    : IsDensity(work, group) ? StateMeaning::PerVolume
                             : StateMeaning::PerMass;
  work.Weights.push_back(word ? word->Weight : "");
  for (std::size_t s : group.States)
  {
    if (work.States[s].Components != components)
    {
      throw InputError("The arrays of " + Quote(group.Name) + " have " +
        std::to_string(components) + " and " + std::to_string(work.States[s].Components) +
        " components: they become one array of the mesh.");
    }
  }
  work.Plan.Conserved.push_back(std::move(array));
}

/// Returns the index of the conserved array with a name, its own or that of one of its states,
/// without spaces at the ends; -1: none.
int FindConserved(const Work& work, const std::string& name)
{
  const std::vector<ConservedArray>& arrays = work.Plan.Conserved;
  for (std::size_t c = 0; c < arrays.size(); ++c)
  {
    const auto isNamed = [&](std::size_t s)
    { return TrimText(work.States[s].Name) == TrimText(name); };
    if (TrimText(arrays[c].Name) == TrimText(name) ||
      std::any_of(arrays[c].States.begin(), arrays[c].States.end(), isNamed))
    {
      return static_cast<int>(c);
    }
  }
  return -1;
}

void CheckWords(const Work& work)
{
  for (const auto& word : work.Words)
  {
    const bool isOfState = std::any_of(work.States.begin(), work.States.end(),
      [&word](const StateArray& state) { return TrimText(state.Name) == word.first; });
    if (!isOfState && FindConserved(work, word.first) < 0)
    {
      throw InputError(
        "The state kinds name " + Quote(word.first) + ", which is not a selected state array.");
    }
  }
}

/// Checks the names of arrays that are made from several state arrays.
void CheckNames(const Work& work)
{
  for (const ConservedArray& array : work.Plan.Conserved)
  {
    if (array.States.size() > 1)
    {
      CheckNameOfState(array.Name);
      const auto count = std::count_if(work.Plan.Conserved.begin(), work.Plan.Conserved.end(),
        [&](const ConservedArray& other) { return other.Name == array.Name; });
      if (count > 1 || FindState(work, array.Name) >= 0)
      {
        throw InputError("The arrays " + Quote(work.States[array.States[0]].Name) + ", " +
          Quote(work.States[array.States[1]].Name) + ", .. become the array " + Quote(array.Name) +
          " of the mesh, but there is another of that name. Rename or leave out one of them.");
      }
    }
  }
}

void SetWeights(Work& work)
{
  for (std::size_t c = 0; c < work.Weights.size(); ++c)
  {
    const std::string& name = work.Weights[c];
    if (name.empty())
    {
      continue;
    }
    ConservedArray& array = work.Plan.Conserved[c];
    array.Weight = FindConserved(work, name);
    const bool isFit = array.Weight >= 0 && array.Weight != static_cast<int>(c) &&
      work.Weights[array.Weight].empty() &&
      work.Plan.Conserved[array.Weight].Meaning == StateMeaning::PerMass &&
      work.Plan.Conserved[array.Weight].Components == 1;
    if (!isFit)
    {
      throw InputError("The state array " + Quote(array.Name) + " cannot be weighted with " +
        Quote(name) + ": select another state array, of one component and the kind mass.");
    }
  }
}

void CheckDensity(const ConservedArray& density)
{
  if (density.Components != 1)
  {
    throw InputError("The density array " + Quote(density.Name) + " has " +
      std::to_string(density.Components) +
      " components: an array with one value per cell is needed.");
  }
  if (density.Meaning == StateMeaning::PerMass)
  {
    throw InputError("The density array " + Quote(density.Name) +
      " cannot be of the kind mass: volume, cell and extensive (the mass of a cell) are "
      "allowed.");
  }
}

void SetDensity(Work& work)
{
  for (const std::string& name : work.Choice.Densities)
  {
    const int found = FindConserved(work, name);
    if (found < 0)
    {
      throw InputError("The density array " + Quote(name) + " cannot be copied.");
    }
    if (work.Plan.Density >= 0 && found != work.Plan.Density)
    {
      throw InputError("The density arrays " + Quote(work.Choice.Densities[0]) + " and " +
        Quote(name) +
        " are not arrays of different materials. Select one array for all materials, or one per "
        "material with names that differ only in the material.");
    }
    work.Plan.Density = found;
  }
  if (work.Plan.Density >= 0)
  {
    CheckDensity(work.Plan.Conserved[work.Plan.Density]);
  }
}

/// Returns the index of the velocity or energy, or -1; what: its name in messages.
int FindPerMass(const Work& work, const std::string& name, const std::string& what, int components)
{
  if (name.empty())
  {
    return -1;
  }
  const int found = FindConserved(work, name);
  const std::string array = "The " + what + " array " + Quote(name);
  if (found < 0 && FindState(work, name) < 0)
  {
    throw InputError(
      array + " is neither an array of the input nor the common part of names of state arrays.");
  }
  if (found < 0 || work.Plan.Conserved[found].Meaning != StateMeaning::PerMass ||
    work.Plan.Conserved[found].Weight >= 0)
  {
    throw InputError(array + " must be of the kind mass: " + what + " is per mass.");
  }
  const int has = work.Plan.Conserved[found].Components;
  if (has != components)
  {
    throw InputError(array + " has " + std::to_string(has) + " component" + (has == 1 ? "" : "s") +
      ": " + what + " has " + std::to_string(components) + ".");
  }
  return found;
}

void AddWord(Work& work, const StateKindWord& word)
{
  if (!work.Words.emplace(word.Name, word).second)
  {
    throw InputError("The state kinds name " + Quote(word.Name) + " twice.");
  }
}

} // namespace

StatePlan PlanState(
  const StateChoice& choice, const std::vector<StateArray>& states, const Materials& materials)
{
  Work work{ choice, states, materials };
  for (const std::string& text : choice.Kinds)
  {
    AddWord(work, ReadWord(text));
  }
  for (const StateGroup& group : FindGroups(work))
  {
    Place(work, group);
  }
  CheckWords(work);
  CheckNames(work);
  SetWeights(work);
  SetDensity(work);
  work.Plan.Velocity = FindPerMass(work, work.Choice.Velocity, "velocity", 3);
  work.Plan.Energy = FindPerMass(work, work.Choice.Energy, "energy", 1);
  return std::move(work.Plan);
}

} // namespace vfm
