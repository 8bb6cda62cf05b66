/**
 * ChooseArrays: selects the arrays that hold the materials, and the materials to mesh. The arrays
 * belong to cells or, for images, to points, each of which is then the centre of a cell.
 */
#pragma once

#include "Arguments.h"
#include "Input.h"
#include "Materials/ArrayContent.h"
#include "Ranks/Ranks.h"

#include <string>
#include <vector>

namespace vfm
{

/// Arrays of materials.
struct ChosenArrays
{
  std::vector<std::string> Fractions; ///< arrays of material 1, 2, ...; empty: labels
  std::string Labels;                 ///< array of labels; if also empty, there are no materials
  std::string How;                    ///< reason of the choice, for the user
  std::string Warning;                ///< warning about arrays that may be missing, or empty
  ArrayPlace Place = ArrayPlace::Cells;
  std::string Problem;     ///< reason if there are no materials
  bool AreGuessed = false; ///< false: named by the arguments
};

/// Returns the arrays of materials that are used by default; possibly none.
/// @param tolerance  largest distance of volume fractions from [0, 1]
/// @pre Collective
ChosenArrays FindMaterials(
  const Input& input, const Arguments& arguments, double tolerance, Ranks& ranks);

/// Returns what each array of a place holds.
std::vector<ContentOfArray> DescribeContents(
  const std::vector<ArrayInfo>& arrays, ArrayPlace place, const Arguments& arguments);

/// Returns the labels above 0 in the arrays of a name on all ranks, ascending.
/// @pre Collective
std::vector<int> FindLabels(const ArrayLists& lists, const std::string& name, Ranks& ranks);

/// Returns the arrays of materials that the arguments name, otherwise the result of FindMaterials.
/// @throws InputError  (UnreadableInput) if an array does not exist or there are no materials; the
///   message lists the arrays of the input
/// @pre Collective
ChosenArrays ChooseArrays(const Input& input, const Arguments& arguments, Ranks& ranks);

/// Makes the cells of all materials void that the arguments do not name by number or array. This
/// replaces arrays of the blocks.
/// @throws InputError  (WrongArguments) if a material does not exist, or if an array is replaced
///   that is to be transferred or that determines the refinement
/// @pre Collective
void KeepMaterials(std::vector<InputBlock>& blocks, const ChosenArrays& arrays,
  const Arguments& arguments, Ranks& ranks);

} // namespace vfm
