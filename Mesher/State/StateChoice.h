/**
 * StateChoice: which arrays of the input are meant by the names of what is to be conserved.
 */
#pragma once

#include "Input/ArrayInfo.h"
#include "Options/MesherOptions.h"

namespace vfm
{

struct StateChoice
{
  bool IsConserved = false;        ///< else all arrays are copied
  std::vector<std::string> Arrays; ///< distinct
  std::vector<std::string> Densities;
  std::vector<std::string> Kinds; ///< words name=kind
  std::string Velocity, Energy;   ///< empty: none
};

/// Whether state is conserved by an option where arrays are the densities.
bool ConservesState(StateTransfer how, const std::vector<std::string>& densities);

/// What options say of state. arrays: that are carried whether they are conserved or not.
StateChoice ChooseState(const MesherOptions& options, std::vector<std::string> arrays);

/// An array of the input that CompleteChoice asks for.
struct StateCandidate
{
  std::string Name;
  int Components;
};

/// Whether an array of that name may be what is chosen as velocity or energy, or a component of it.
bool IsCandidate(const std::string& name, const StateChoice& choice);

/// Adds the arrays of densities, velocity and energy to all, but what may be the stem of some that are listed. Of a velocity
/// whose components are arrays of their own, by its name or that of one of them, these, and Velocity becomes that of x. candidates: those
/// arrays of the input for which IsCandidate holds.
StateChoice CompleteChoice(StateChoice choice, const std::vector<StateCandidate>& candidates);

/// Collective: the same, by the arrays of all ranks.
StateChoice CompleteChoice(StateChoice choice, const ArrayLists& mine, Ranks& ranks);

} // namespace vfm
