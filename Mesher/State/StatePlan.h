/**
 * StatePlan: what is to be conserved of which arrays, from what is chosen and the names of arrays.
 */
#pragma once

#include "Input/InputFields.h"
#include "State/StateArrays.h"
#include "State/StateChoice.h"

#include <string>
#include <vector>

namespace vfm
{

/// What the values of an array are.
enum class StateMeaning
{
  PerVolume, ///< of the material
  PerMass,
  PerCell,  ///< per volume of the whole cell
  Extensive ///< sums
};

struct ConservedArray
{
  std::string Name; ///< of the output
  StateMeaning Meaning = StateMeaning::PerMass;
  int Components = 1;
  int Weight = -1; ///< the conserved array that multiplies the mass; -1: none
  std::vector<std::size_t>
    States; ///< one for all materials, or one of each material from 1, or of each component
  bool IsVector = false; ///< of each component

  bool IsOfMaterials() const { return this->States.size() > 1 && !this->IsVector; }

  bool IsShared() const
  {
    return this->Meaning == StateMeaning::PerCell || this->Meaning == StateMeaning::Extensive;
  }
};

struct StatePlan
{
  std::vector<ConservedArray> Conserved;
  std::vector<std::size_t> Copied;              ///< states
  int Density = -1, Velocity = -1, Energy = -1; ///< conserved arrays
};

/// states: of choice.Arrays, in their order. Throws InputError on words that are none, names that are not chosen, kinds or components that
/// do not fit, arrays a material that lack a material.
StatePlan PlanState(
  const StateChoice& choice, const std::vector<StateArray>& states, const Materials& materials);

} // namespace vfm
