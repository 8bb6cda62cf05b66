/**
 * MaterialArrays: which arrays of the input hold the materials, by what is chosen and what there is.
 *
 * Where nothing is chosen and there is a single array that can hold them (MaterialGuess), it is meant. As a panel ticks that one by itself,
 * a script that names it in its other role, as labels and not as fractions, chooses it for both: then the role that it was not ticked for
 * is meant.
 */
#pragma once

#include "ChosenArray.h"
#include "Ranks/Ranks.h"

#include <vector>

class vtkDataObject;

namespace vfm
{

struct MaterialArrays
{
  std::vector<ChosenArray> Fractions;
  ChosenArray Labels; ///< without a name: none

  bool HasLabels() const { return !this->Labels.Name.empty(); }
  std::vector<ChosenArray> List() const
  {
    return this->HasLabels() ? std::vector<ChosenArray>{ this->Labels } : this->Fractions;
  }
};

/// Collective: either fractions or labels. Throws InputError, on all ranks alike, when nothing is chosen and nothing or too much could be
/// meant, or both are chosen.
MaterialArrays FindMaterialArrays(vtkDataObject* input, MaterialArrays chosen, Ranks& ranks);

} // namespace vfm
