/**
 * ChooseArrays: which arrays hold the materials, and which materials are meshed. They belong to cells or, of images, to points, each of
 * which then is the centre of a cell.
 */
#pragma once

#include "Arguments.h"
#include "Input.h"
#include "Ranks/Ranks.h"

#include <string>
#include <vector>

namespace vfm
{

struct ChosenArrays
{
  std::vector<std::string> Fractions; ///< of material 1, 2, ...; empty: labels
  std::string Labels;                 ///< empty too: no materials
  std::string How;                    ///< for the user: why these
  std::string Warning;                ///< empty, or what may be missing among them
  ArrayPlace Place = ArrayPlace::Cells;
};

/// Collective: the materials that are taken where the arguments name none; maybe none. tolerance: of fractions, outside of [0, 1].
ChosenArrays FindMaterials(
  const Input& input, const Arguments& arguments, double tolerance, Ranks& ranks);

/// Collective: the labels above 0 that the arrays of that name hold, ascending.
std::vector<int> FindLabels(const ArrayLists& lists, const std::string& name, Ranks& ranks);

/// Collective: what the arguments name, else what fits. Throws InputError
/// (UnreadableInput), which lists the arrays that are there, when nothing fits, and where none has a name that is given.
ChosenArrays ChooseArrays(const Input& input, const Arguments& arguments, Ranks& ranks);

/// Collective: makes cells of materials that the arguments (numbers or names of arrays) do not name void, by replacing
/// arrays of the blocks. Throws InputError (WrongArguments) on a material that is not there, and when the elements are to carry an array
/// that would be replaced.
void KeepMaterials(std::vector<InputBlock>& blocks, const ChosenArrays& arrays,
  const Arguments& arguments, Ranks& ranks);

} // namespace vfm
