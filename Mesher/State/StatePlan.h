/**
 * StatePlan: decides which quantity of each state array is conserved, from the options and the
 * names of arrays.
 */
#pragma once

#include "Input/InputFields.h"
#include "State/StateArrays.h"
#include "State/StateChoice.h"

#include <string>
#include <vector>

namespace vfm
{

/// Meaning of the values of an array.
enum class StateMeaning
{
  PerVolume, ///< value per volume of the material
  PerMass,
  PerCell,  ///< value per volume of the whole cell
  Extensive ///< sums over a cell
};

/// An array of the mesh with conserved contents, made from one or several state arrays.
struct ConservedArray
{
  std::string Name; ///< name on the mesh
  StateMeaning Meaning = StateMeaning::PerMass;
  int Components = 1;
  int Weight = -1; ///< index of the conserved array that multiplies the mass; -1: none
  /// Indices of state arrays: one for all materials, one per material from 1, or one per component.
  std::vector<std::size_t> States;
  bool IsVector = false;  ///< true if States has one array per component
  bool IsRotated = false; ///< true: values are rotated from image axes to world coordinates

  /// Returns whether States has one array per material.
  bool IsOfMaterials() const { return this->States.size() > 1 && !this->IsVector; }

  /// Returns whether the materials of a cell share its value.
  bool IsShared() const
  {
    return this->Meaning == StateMeaning::PerCell || this->Meaning == StateMeaning::Extensive;
  }
};

struct StatePlan
{
  std::vector<ConservedArray> Conserved;
  std::vector<std::size_t> Copied;              ///< indices of state arrays that are copied
  int Density = -1, Velocity = -1, Energy = -1; ///< indices of conserved arrays; -1: none
};

/// Makes the plan.
/// @param states arrays of choice.Arrays, in the same order
/// @throws InputError if kinds are invalid or name arrays that are not selected, if kinds or
/// components do not fit, or if arrays per material lack a material
StatePlan PlanState(
  const StateChoice& choice, const std::vector<StateArray>& states, const Materials& materials);

} // namespace vfm
