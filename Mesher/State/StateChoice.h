/**
 * StateChoice: finds the arrays of the input that the options of state transfer name.
 */
#pragma once

#include "Input/ArrayInfo.h"
#include "Options/MesherOptions.h"

namespace vfm
{

/// Selected state arrays and their roles.
struct StateChoice
{
  bool IsConserved = false;        ///< false: all arrays are copied
  std::vector<std::string> Arrays; ///< distinct names of all arrays
  std::vector<std::string> Densities;
  std::vector<std::string> Kinds;        ///< entries name=kind
  std::string Velocity, Energy;          ///< empty: not selected
  std::vector<std::string> Rotated = {}; ///< arrays that are rotated from image axes
};

/// Returns whether state is conserved.
/// @param densities selected density arrays
bool ConservesState(TransferMode how, const std::vector<std::string>& densities);

/// Returns the selection of the options; arrays: state arrays that are transferred in any case.
StateChoice ChooseState(const MesherOptions& options, std::vector<std::string> arrays);

/// An array of the input that may have a role (IsCandidate).
struct StateCandidate
{
  std::string Name;
  int Components;
};

/// Returns whether an array of that name may be the selected velocity or energy, or a component.
bool IsCandidate(const std::string& name, const StateChoice& choice);

/// Adds the arrays of densities, velocity and energy to Arrays, except names that may be the common
/// part of listed arrays. If the components of the velocity are separate arrays, all three are
/// added, and Velocity becomes the array of x.
/// @param candidates arrays of the input for which IsCandidate is true
StateChoice CompleteChoice(StateChoice choice, const std::vector<StateCandidate>& candidates);

/// Completes the choice with the arrays of all ranks.
/// @param mine arrays of this rank
/// @pre Collective
StateChoice CompleteChoice(StateChoice choice, const ArrayLists& mine, Ranks& ranks);

} // namespace vfm
