/**
 * MaterialArrays: decides which arrays of the input hold the materials.
 *
 * If no array is selected and the choice is clear (ChooseMaterials.h), it is used. A panel selects
 * these arrays by default. If a script then selects it in the other role, such as
 * labels instead of fractions, the array has both roles; the role of the script is used.
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
  ChosenArray Labels;      ///< empty name: none
  bool AreGuessed = false; ///< true: not selected by the user

  bool HasLabels() const { return !this->Labels.Name.empty(); }
  std::vector<ChosenArray> List() const
  {
    return this->HasLabels() ? std::vector<ChosenArray>{ this->Labels } : this->Fractions;
  }
};

/// Returns the arrays of fractions, or the array of labels.
/// @param hasThreshold  materials are ranges of the values of one array, which becomes the labels
/// @throws InputError if no array is selected and the choice is not clear, or if both kinds are
/// selected; on all ranks
/// @pre Collective
MaterialArrays FindMaterialArrays(
  vtkDataObject* input, MaterialArrays chosen, bool hasThreshold, Ranks& ranks);

} // namespace vfm
