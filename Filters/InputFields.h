/**
 * The material in every cell, read from the cell arrays of the input's blocks without copying them:
 * either one volume fraction array a material, or one integer array of labels.
 */
#pragma once

#include "FractionField.h"
#include "InputBlocks.h"

#include <string>
#include <vector>

namespace vfm
{

/// The materials of a field, by their number in the Grid code: 0 is void, 1..N the materials.
struct Materials
{
  std::vector<std::string> Names;
  std::vector<int> Labels; ///< what the user calls them; 0 is void
};

struct InputField
{
  FractionField Fractions;
  Materials Table;
};

/// Fractions of material m from the cell array names[m - 1]: of any type with one component, unsigned
/// char counting 0..255. Throws InputError on missing arrays and on values that are no fractions.
InputField ReadFractions(
  const CartesianGrid& grid, const InputBlocks& input, const std::vector<std::string>& names);

/// Labels >= 0 from an integer cell array, 0 void. The labels that occur are numbered 1..N in
/// increasing order. Throws InputError on missing arrays, real types, negative labels.
InputField ReadLabels(const CartesianGrid& grid, const InputBlocks& input, const std::string& name);

} // namespace vfm
