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

/// What a word says of an array.
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

/// From what stands behind the =; false when it is no kind.
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

/// Names may hold = themselves: the first one behind which a kind stands parts them.
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
    " is none: write array=kind, as pressure=volume. Kinds are " + KindsText + ".");
}

/// Arrays that become one of the output.
struct StateGroup
{
  std::string Name;
  std::vector<std::size_t> States;
  bool IsVector = false;
};

class StatePlanner
{
public:
  StatePlanner(
    const StateChoice& choice, const std::vector<StateArray>& states, const Materials& materials) :
    Choice(choice), States(states), Table(materials), Stems(materials.Names, materials.Labels)
  {
    for (const std::string& text : choice.Kinds)
    {
      this->AddWord(ReadWord(text));
    }
  }

  StatePlan Make()
  {
    for (const StateGroup& group : this->FindGroups())
    {
      this->Place(group);
    }
    this->CheckWords();
    this->CheckNames();
    this->SetWeights();
    this->SetDensity();
    this->Plan.Velocity = this->FindPerMass(this->Choice.Velocity, "velocity", 3);
    this->Plan.Energy = this->FindPerMass(this->Choice.Energy, "energy", 1);
    return std::move(this->Plan);
  }

private:
  void AddWord(const StateKindWord& word)
  {
    if (!this->Words.emplace(word.Name, word).second)
    {
      throw InputError("The state kinds name " + Quote(word.Name) + " twice.");
    }
  }

  const StateKindWord* FindWord(const std::string& name) const
  {
    const auto found = this->Words.find(TrimText(name));
    return found == this->Words.end() ? nullptr : &found->second;
  }

  /// What is said of a group, by its name or that of any of its arrays.
  const StateKindWord* FindWord(const StateGroup& group) const
  {
    const StateKindWord* word = this->FindWord(group.Name);
    for (std::size_t s : group.States)
    {
      const StateKindWord* own = this->FindWord(this->States[s].Name);
      if (word && own && !word->IsSameKind(*own))
      {
        throw InputError("The state kinds of " + Quote(word->Name) + " and " + Quote(own->Name) +
          " differ, but they are one array of the mesh, " + Quote(group.Name) + ".");
      }
      word = word ? word : own;
    }
    return word;
  }

  bool IsDensity(const std::string& name) const
  {
    const std::vector<std::string>& densities = this->Choice.Densities;
    return std::find(densities.begin(), densities.end(), name) != densities.end();
  }

  bool IsDensity(const StateGroup& group) const
  {
    return std::any_of(group.States.begin(), group.States.end(),
      [&](std::size_t s) { return this->IsDensity(this->States[s].Name); });
  }

  /// Whether it is the velocity or the energy, by its name or that of any of its arrays.
  bool IsPerMass(const StateGroup& group) const
  {
    const auto isChosen = [this](const std::string& name)
    { return name == this->Choice.Velocity || name == this->Choice.Energy; };
    return isChosen(group.Name) ||
      std::any_of(group.States.begin(), group.States.end(),
        [&](std::size_t s) { return isChosen(this->States[s].Name); });
  }

  /// Whole numbers too, but where their role tells what they are.
  bool IsCopied(const StateGroup& group) const
  {
    const StateKindWord* word = this->FindWord(group);
    return word ? word->IsCopy
                : !IsRealType(this->States[group.States[0]].Type) && !this->IsDensity(group) &&
        !this->IsPerMass(group);
  }

  /// The place of a state, or -1.
  int FindState(const std::string& name) const
  {
    const auto found = std::find_if(this->States.begin(), this->States.end(),
      [&name](const StateArray& state) { return state.Name == name; });
    return found == this->States.end() ? -1 : static_cast<int>(found - this->States.begin());
  }

  /// Arrays a material together, all others alone, in the order of the states.
  std::vector<StateGroup> FindGroups() const
  {
    std::vector<StateGroup> groups;
    std::vector<bool> isTaken(this->States.size(), false);
    for (std::size_t s = 0; s < this->States.size(); ++s)
    {
      if (!isTaken[s])
      {
        groups.push_back(this->FindGroup(s));
        for (std::size_t member : groups.back().States)
        {
          isTaken[member] = true;
        }
      }
    }
    return groups;
  }

  StateGroup FindGroup(std::size_t state) const
  {
    const StateGroup alone{ this->States[state].Name, { state } };
    const StateGroup velocity = this->FindVelocity();
    if (std::find(velocity.States.begin(), velocity.States.end(), state) != velocity.States.end())
    {
      return velocity;
    }
    const std::vector<ArrayStem> stems = this->Stems.FindStems(alone.Name);
    for (const ArrayStem& stem : stems)
    {
      StateGroup group{ stem.Name, {} };
      for (const std::string& member : stem.Members)
      {
        const int place = this->FindState(member);
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
    if (!stems.empty() && !this->IsCopied(alone) && !this->FindWord(alone.Name))
    {
      this->RefusePartial(alone.Name, stems[0]);
    }
    return alone;
  }

  /// The arrays of the velocity's components, if it is chosen by that of its x.
  StateGroup FindVelocity() const
  {
    StateGroup group;
    const int x = this->FindState(this->Choice.Velocity);
    const std::optional<ArrayStem> vector = FindVector(this->Choice.Velocity);
    if (vector && x >= 0 && this->States[x].Components == 1)
    {
      if (!this->Stems.FindStems(this->Choice.Velocity).empty() &&
        !this->FindWord(this->Choice.Velocity))
      {
        throw InputError("The velocity array " + Quote(this->Choice.Velocity) +
          " is a component of one material's velocity, by its name. Make a vector array of each "
          "material's components, or tell what it is, for all materials alike (the state kind " +
          this->Choice.Velocity + "=mass).");
      }
      group = { vector->Name, {}, true };
      for (const std::string& member : vector->Members)
      {
        group.States.push_back(this->FindState(member)); // which FindChosenState lists
      }
    }
    return group;
  }

  [[noreturn]] void RefusePartial(const std::string& name, const ArrayStem& stem) const
  {
    std::size_t missing = 0;
    while (this->FindState(stem.Members[missing]) >= 0)
    {
      ++missing;
    }
    throw InputError("The state array " + Quote(name) +
      " is that of one material, by its name, but of the material " +
      Quote(this->Table.Names[missing + 1]) + " none is chosen: " + Quote(stem.Members[missing]) +
      ". Choose one for every material, or tell what it is, for all materials alike (the state "
      "kind " +
      name + (this->IsDensity(name) ? "=volume" : "=mass") + ", or another).");
  }

  void Place(const StateGroup& group)
  {
    if (this->IsCopied(group))
    {
      this->Plan.Copied.insert(this->Plan.Copied.end(), group.States.begin(), group.States.end());
      return;
    }
    ConservedArray array;
    array.Name = group.Name;
    array.States = group.States;
    array.IsVector = group.IsVector;
    const int components = this->States[group.States[0]].Components;
    array.Components = group.IsVector ? 3 : components;
    const StateKindWord* word = this->FindWord(group);
    array.Meaning = word       ? word->Meaning
      : this->IsDensity(group) ? StateMeaning::PerVolume
                               : StateMeaning::PerMass;
    this->Weights.push_back(word ? word->Weight : "");
    for (std::size_t s : group.States)
    {
      if (this->States[s].Components != components)
      {
        throw InputError("The arrays of " + Quote(group.Name) + " have " +
          std::to_string(components) + " and " + std::to_string(this->States[s].Components) +
          " components: they become one array of the mesh.");
      }
    }
    this->Plan.Conserved.push_back(std::move(array));
  }

  /// The conserved array with a name, its own or that of one of its states, but for blanks at the ends; -1: none.
  int FindConserved(const std::string& name) const
  {
    const std::vector<ConservedArray>& arrays = this->Plan.Conserved;
    for (std::size_t c = 0; c < arrays.size(); ++c)
    {
      const auto isNamed = [&](std::size_t s)
      { return TrimText(this->States[s].Name) == TrimText(name); };
      if (TrimText(arrays[c].Name) == TrimText(name) ||
        std::any_of(arrays[c].States.begin(), arrays[c].States.end(), isNamed))
      {
        return static_cast<int>(c);
      }
    }
    return -1;
  }

  void CheckWords() const
  {
    for (const auto& word : this->Words)
    {
      const bool isOfState = std::any_of(this->States.begin(), this->States.end(),
        [&word](const StateArray& state) { return TrimText(state.Name) == word.first; });
      if (!isOfState && this->FindConserved(word.first) < 0)
      {
        throw InputError("The state kinds name " + Quote(word.first) +
          ", which is no state array that is chosen.");
      }
    }
  }

  /// Of what several arrays become.
  void CheckNames() const
  {
    for (const ConservedArray& array : this->Plan.Conserved)
    {
      if (array.States.size() > 1)
      {
        CheckNameOfState(array.Name);
        const auto count = std::count_if(this->Plan.Conserved.begin(), this->Plan.Conserved.end(),
          [&](const ConservedArray& other) { return other.Name == array.Name; });
        if (count > 1 || this->FindState(array.Name) >= 0)
        {
          throw InputError("The arrays " + Quote(this->States[array.States[0]].Name) + ", " +
            Quote(this->States[array.States[1]].Name) + ", .. become the array " +
            Quote(array.Name) +
            " of the mesh, but there is another of that name. Rename or leave out one of them.");
        }
      }
    }
  }

  void SetWeights()
  {
    for (std::size_t c = 0; c < this->Weights.size(); ++c)
    {
      const std::string& name = this->Weights[c];
      if (name.empty())
      {
        continue;
      }
      ConservedArray& array = this->Plan.Conserved[c];
      array.Weight = this->FindConserved(name);
      const bool isFit = array.Weight >= 0 && array.Weight != static_cast<int>(c) &&
        this->Weights[array.Weight].empty() &&
        this->Plan.Conserved[array.Weight].Meaning == StateMeaning::PerMass &&
        this->Plan.Conserved[array.Weight].Components == 1;
      if (!isFit)
      {
        throw InputError("The state array " + Quote(array.Name) + " cannot be weighed with " +
          Quote(name) +
          ": that must be another state array that is chosen, of one component and the kind mass.");
      }
    }
  }

  void SetDensity()
  {
    for (const std::string& name : this->Choice.Densities)
    {
      const int found = this->FindConserved(name);
      if (found < 0)
      {
        throw InputError("The density array " + Quote(name) + " cannot be copied.");
      }
      if (this->Plan.Density >= 0 && found != this->Plan.Density)
      {
        throw InputError("The density arrays " + Quote(this->Choice.Densities[0]) + " and " +
          Quote(name) +
          " are two: choose one for all materials, or one a material whose names differ in the "
          "material alone, as those of the volume fractions do.");
      }
      this->Plan.Density = found;
    }
    if (this->Plan.Density >= 0)
    {
      this->CheckDensity(this->Plan.Conserved[this->Plan.Density]);
    }
  }

  void CheckDensity(const ConservedArray& density) const
  {
    if (density.Components != 1)
    {
      throw InputError("The density array " + Quote(density.Name) + " has " +
        std::to_string(density.Components) +
        " components: an array with one value a cell is needed.");
    }
    if (density.Meaning == StateMeaning::PerMass)
    {
      throw InputError("The density array " + Quote(density.Name) +
        " cannot be of the kind mass: volume, cell and extensive (the mass of a cell) are "
        "allowed.");
    }
  }

  /// what: for messages.
  int FindPerMass(const std::string& name, const std::string& what, int components) const
  {
    if (name.empty())
    {
      return -1;
    }
    const int found = this->FindConserved(name);
    const std::string array = "The " + what + " array " + Quote(name);
    if (found < 0 && this->FindState(name) < 0)
    {
      throw InputError(
        array + " is neither an array of the input nor what names of state arrays have in common.");
    }
    if (found < 0 || this->Plan.Conserved[found].Meaning != StateMeaning::PerMass ||
      this->Plan.Conserved[found].Weight >= 0)
    {
      throw InputError(array + " must be of the kind mass: " + what + " is per mass.");
    }
    const int has = this->Plan.Conserved[found].Components;
    if (has != components)
    {
      throw InputError(array + " has " + std::to_string(has) + " component" +
        (has == 1 ? "" : "s") + ": " + what + " has " + std::to_string(components) + ".");
    }
    return found;
  }

  const StateChoice& Choice;
  const std::vector<StateArray>& States;
  const Materials& Table;
  MaterialStems Stems;
  std::map<std::string, StateKindWord> Words;
  std::vector<std::string> Weights; // of each conserved array
  StatePlan Plan;
};

} // namespace

StatePlan PlanState(
  const StateChoice& choice, const std::vector<StateArray>& states, const Materials& materials)
{
  return StatePlanner(choice, states, materials).Make();
}

} // namespace vfm
