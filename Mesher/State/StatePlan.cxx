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

/// Entries of arrays, by their names.
using KindWords = std::map<std::string, StateKindWord>;

/// Selected state arrays with their roles and kinds.
struct SelectedStates
{
  const StateChoice& Choice;
  const std::vector<StateArray>& States;
  const Materials& Table;
  const MaterialStems Stems;
  const KindWords Words;
};

const StateKindWord* FindWord(const KindWords& words, const std::string& name)
{
  const auto found = words.find(TrimText(name));
  return found == words.end() ? nullptr : &found->second;
}

/// Returns the entry of a group, by its name or the name of one of its arrays.
const StateKindWord* FindWord(
  const KindWords& words, const std::vector<StateArray>& states, const StateGroup& group)
{
  const StateKindWord* word = FindWord(words, group.Name);
  for (std::size_t s : group.States)
  {
    const StateKindWord* own = FindWord(words, states[s].Name);
    if (word && own && !word->IsSameKind(*own))
    {
      throw InputError("The state kinds of " + Quote(word->Name) + " and " + Quote(own->Name) +
        " differ, but they are one array of the mesh, " + Quote(group.Name) + ".");
    }
    word = word ? word : own;
  }
  return word;
}

bool IsDensity(const StateChoice& choice, const std::string& name)
{
  const std::vector<std::string>& densities = choice.Densities;
  return std::find(densities.begin(), densities.end(), name) != densities.end();
}

bool IsDensity(
  const StateChoice& choice, const std::vector<StateArray>& states, const StateGroup& group)
{
  return std::any_of(group.States.begin(), group.States.end(),
    [&](std::size_t s) { return IsDensity(choice, states[s].Name); });
}

/// Returns whether a group is the velocity or the energy, by its name or the name of an array.
bool IsPerMass(
  const StateChoice& choice, const std::vector<StateArray>& states, const StateGroup& group)
{
  const auto isChosen = [&](const std::string& name)
  { return name == choice.Velocity || name == choice.Energy; };
  return isChosen(group.Name) ||
    std::any_of(group.States.begin(), group.States.end(),
      [&](std::size_t s) { return isChosen(states[s].Name); });
}

/// Returns whether a group is copied; integers are, unless they are density, velocity or energy.
bool IsCopied(const SelectedStates& selected, const StateGroup& group)
{
  const std::vector<StateArray>& states = selected.States;
  const StateKindWord* word = FindWord(selected.Words, states, group);
  return word ? word->IsCopy
              : !IsRealType(states[group.States[0]].Type) &&
      !IsDensity(selected.Choice, states, group) && !IsPerMass(selected.Choice, states, group);
}

/// Returns the index of a state, or -1.
int FindState(const std::vector<StateArray>& states, const std::string& name)
{
  const auto found = std::find_if(
    states.begin(), states.end(), [&name](const StateArray& state) { return state.Name == name; });
  return found == states.end() ? -1 : static_cast<int>(found - states.begin());
}

/// Returns the arrays of the components of the velocity, if its x component is an array.
StateGroup FindVelocity(const SelectedStates& selected)
{
  StateGroup group;
  const std::string& name = selected.Choice.Velocity;
  const int x = FindState(selected.States, name);
  const std::optional<ArrayStem> vector = FindVector(name);
  if (vector && x >= 0 && selected.States[x].Components == 1)
  {
    if (!selected.Stems.FindStems(name).empty() && !FindWord(selected.Words, name))
    {
      throw InputError("The velocity array " + Quote(name) +
        " is a component of one material's velocity, by its name. Make one vector array per "
        "material, or set its kind for all materials (state kind " +
        name + "=mass).");
    }
    group = { vector->Name, {}, true };
    for (const std::string& member : vector->Members)
    {
      group.States.push_back(
        FindState(selected.States, member)); // CompleteChoice added all of them
    }
  }
  return group;
}

[[noreturn]] void RejectPartial(
  const SelectedStates& selected, const std::string& name, const ArrayStem& stem)
{
  std::size_t missing = 0;
  while (FindState(selected.States, stem.Members[missing]) >= 0)
  {
    ++missing;
  }
  throw InputError("The state array " + Quote(name) +
    " belongs to one material, by its name, and of the material " +
    Quote(selected.Table.Names[missing + 1]) +
    " no array is selected: " + Quote(stem.Members[missing]) +
    ". Select the arrays of all materials, or set its kind for all materials (state kind " + name +
    (IsDensity(selected.Choice, name) ? "=volume" : "=mass") + ", or another).");
}

StateGroup FindGroup(const SelectedStates& selected, std::size_t state)
{
  const StateGroup alone{ selected.States[state].Name, { state } };
  const StateGroup velocity = FindVelocity(selected);
  if (std::find(velocity.States.begin(), velocity.States.end(), state) != velocity.States.end())
  {
    return velocity;
  }
  const std::vector<ArrayStem> stems = selected.Stems.FindStems(alone.Name);
  for (const ArrayStem& stem : stems)
  {
    StateGroup group{ stem.Name, {} };
    for (const std::string& member : stem.Members)
    {
      const int place = FindState(selected.States, member);
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
  if (!stems.empty() && !IsCopied(selected, alone) && !FindWord(selected.Words, alone.Name))
  {
    RejectPartial(selected, alone.Name, stems[0]);
  }
  return alone;
}

/// Returns the groups of arrays per material and of components, and single arrays, in the order of
/// the states.
std::vector<StateGroup> FindGroups(const SelectedStates& selected)
{
  std::vector<StateGroup> groups;
  std::vector<bool> isTaken(selected.States.size(), false);
  for (std::size_t s = 0; s < selected.States.size(); ++s)
  {
    if (!isTaken[s])
    {
      groups.push_back(FindGroup(selected, s));
      for (std::size_t member : groups.back().States)
      {
        isTaken[member] = true;
      }
    }
  }
  return groups;
}

/// Returns the conserved array of a group, without its weight.
ConservedArray MakeConserved(const SelectedStates& selected, const StateGroup& group)
{
  const std::vector<StateArray>& states = selected.States;
  ConservedArray array;
  array.Name = group.Name;
  array.States = group.States;
  array.IsVector = group.IsVector;
  const int components = states[group.States[0]].Components;
  array.Components = group.IsVector ? 3 : components;
  const StateKindWord* word = FindWord(selected.Words, states, group);
  array.Meaning = word                          ? word->Meaning
    : IsDensity(selected.Choice, states, group) ? StateMeaning::PerVolume
                                                : StateMeaning::PerMass;
  for (std::size_t s : group.States)
  {
    if (states[s].Components != components)
    {
      throw InputError("The arrays of " + Quote(group.Name) + " have " +
        std::to_string(components) + " and " + std::to_string(states[s].Components) +
        " components: they become one array of the mesh.");
    }
  }
  return array;
}

/// Returns the index of the conserved array with a name, its own or that of one of its states,
/// without spaces at the ends; -1: none.
int FindConserved(const std::vector<ConservedArray>& arrays, const std::vector<StateArray>& states,
  const std::string& name)
{
  for (std::size_t c = 0; c < arrays.size(); ++c)
  {
    const auto isNamed = [&](std::size_t s) { return TrimText(states[s].Name) == TrimText(name); };
    if (TrimText(arrays[c].Name) == TrimText(name) ||
      std::any_of(arrays[c].States.begin(), arrays[c].States.end(), isNamed))
    {
      return static_cast<int>(c);
    }
  }
  return -1;
}

/// Checks that all entries name arrays.
void CheckWords(const KindWords& words, const std::vector<StateArray>& states,
  const std::vector<ConservedArray>& arrays)
{
  for (const auto& word : words)
  {
    const bool isOfState = std::any_of(states.begin(), states.end(),
      [&word](const StateArray& state) { return TrimText(state.Name) == word.first; });
    if (!isOfState && FindConserved(arrays, states, word.first) < 0)
    {
      throw InputError(
        "The state kinds name " + Quote(word.first) + ", which is not a selected state array.");
    }
  }
}

/// Checks the names of arrays that are made from several state arrays.
void CheckNames(const std::vector<ConservedArray>& arrays, const std::vector<StateArray>& states)
{
  for (const ConservedArray& array : arrays)
  {
    if (array.States.size() > 1)
    {
      CheckNameOfState(array.Name);
      const auto count = std::count_if(arrays.begin(), arrays.end(),
        [&](const ConservedArray& other) { return other.Name == array.Name; });
      if (count > 1 || FindState(states, array.Name) >= 0)
      {
        throw InputError("The arrays " + Quote(states[array.States[0]].Name) + ", " +
          Quote(states[array.States[1]].Name) + ", .. become the array " + Quote(array.Name) +
          " of the mesh, but there is another of that name. Rename or leave out one of them.");
      }
    }
  }
}

/// Sets the indices of weights.
/// @param weights  name of the weight of each conserved array; empty: none
void SetWeights(const std::vector<std::string>& weights, const std::vector<StateArray>& states,
  std::vector<ConservedArray>& arrays)
{
  for (std::size_t c = 0; c < weights.size(); ++c)
  {
    const std::string& name = weights[c];
    if (name.empty())
    {
      continue;
    }
    const int weight = arrays[c].Weight = FindConserved(arrays, states, name);
    const bool isFit = weight >= 0 && weight != static_cast<int>(c) && weights[weight].empty() &&
      arrays[weight].Meaning == StateMeaning::PerMass && arrays[weight].Components == 1;
    if (!isFit)
    {
      throw InputError("The state array " + Quote(arrays[c].Name) + " cannot be weighted with " +
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

/// Returns the index of the density, or -1.
/// @param densities  names of selected density arrays
int FindDensity(const std::vector<std::string>& densities, const std::vector<StateArray>& states,
  const std::vector<ConservedArray>& arrays)
{
  int density = -1;
  for (const std::string& name : densities)
  {
    const int found = FindConserved(arrays, states, name);
    if (found < 0)
    {
      throw InputError("The density array " + Quote(name) + " cannot be copied.");
    }
    if (density >= 0 && found != density)
    {
      throw InputError("The density arrays " + Quote(densities[0]) + " and " + Quote(name) +
        " are not arrays of different materials. Select one array for all materials, or one per "
        "material with names that differ only in the material.");
    }
    density = found;
  }
  if (density >= 0)
  {
    CheckDensity(arrays[density]);
  }
  return density;
}

/// Returns the index of the velocity or energy, or -1; what: its name in messages.
int FindPerMass(const std::vector<ConservedArray>& arrays, const std::vector<StateArray>& states,
  const std::string& name, const std::string& what, int components)
{
  if (name.empty())
  {
    return -1;
  }
  const int found = FindConserved(arrays, states, name);
  const std::string array = "The " + what + " array " + Quote(name);
  if (found < 0 && FindState(states, name) < 0)
  {
    throw InputError(
      array + " is neither an array of the input nor the common part of names of state arrays.");
  }
  if (found < 0 || arrays[found].Meaning != StateMeaning::PerMass || arrays[found].Weight >= 0)
  {
    throw InputError(array + " must be of the kind mass: " + what + " is per mass.");
  }
  const int has = arrays[found].Components;
  if (has != components)
  {
    throw InputError(array + " has " + std::to_string(has) + " component" + (has == 1 ? "" : "s") +
      ": " + what + " has " + std::to_string(components) + ".");
  }
  return found;
}

/// Returns the entries name=kind.
KindWords ReadWords(const std::vector<std::string>& texts)
{
  KindWords words;
  for (const std::string& text : texts)
  {
    const StateKindWord word = ReadWord(text);
    if (!words.emplace(word.Name, word).second)
    {
      throw InputError("The state kinds name " + Quote(word.Name) + " twice.");
    }
  }
  return words;
}

} // namespace

StatePlan PlanState(
  const StateChoice& choice, const std::vector<StateArray>& states, const Materials& materials)
{
  const SelectedStates selected{ choice, states, materials, { materials.Names, materials.Labels },
    ReadWords(choice.Kinds) };
  StatePlan plan;
  std::vector<std::string> weights; // name of the weight of each conserved array; empty: none
  for (const StateGroup& group : FindGroups(selected))
  {
    if (IsCopied(selected, group))
    {
      plan.Copied.insert(plan.Copied.end(), group.States.begin(), group.States.end());
      continue;
    }
    const StateKindWord* word = FindWord(selected.Words, states, group);
    weights.push_back(word ? word->Weight : "");
    plan.Conserved.push_back(MakeConserved(selected, group));
  }
  const std::vector<ConservedArray>& conserved = plan.Conserved;
  CheckWords(selected.Words, states, conserved);
  CheckNames(conserved, states);
  SetWeights(weights, states, plan.Conserved);
  plan.Density = FindDensity(choice.Densities, states, conserved);
  plan.Velocity = FindPerMass(conserved, states, choice.Velocity, "velocity", 3);
  plan.Energy = FindPerMass(conserved, states, choice.Energy, "energy", 1);
  return plan;
}

} // namespace vfm
