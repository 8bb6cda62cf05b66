/**
 * StateChoice: which arrays of the input are meant by the names of what is to be conserved.
 */
#pragma once

#include "Base/Ranks.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace vfm
{

/// As chosen by properties of the filters (vtkVolumeFractionMeshAlgorithm tells what they mean).
struct StateChoice
{
  bool IsConserved = false;        ///< else all arrays are copied
  std::vector<std::string> Arrays; ///< distinct
  std::vector<std::string> Densities;
  std::vector<std::string> Kinds; ///< words name=kind
  std::string Velocity, Energy;   ///< empty: none
};

/// Collective: adds the arrays of densities, velocity and energy to all, but what may be the stem of some that are listed. Of a velocity
/// whose components are arrays of their own, by its name or that of one of them, these, and Velocity becomes that of x. Throws
/// InputError, on all ranks alike, on input of a kind that cannot be meshed.
StateChoice FindChosenState(vtkDataObject* input, StateChoice choice, Ranks& ranks);

} // namespace vfm
