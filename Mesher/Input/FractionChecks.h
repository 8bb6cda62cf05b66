/**
 * FractionChecks: checks of the arrays of volume fractions over all blocks and ranks.
 */
#pragma once

#include "Input/InputBlocks.h"

#include <string>
#include <vector>

namespace vfm
{

/// Largest value of bytes that cannot fill half of a cell as a fraction of 255.
constexpr int LargestEmptyByte = 127;

/// Returns whether arrays of type unsigned char are masks, in which 1 is full, because none holds a
/// value above 1. Otherwise 255 is full.
/// @param levels blocks of each level
/// @param names arrays of fractions; arrays of other types are ignored
/// @param labelsOption words of the front end that make a name the array of labels, for messages
/// @throws InputError on all ranks, if the largest value is from 2 to LargestEmptyByte and the
/// names do not say volume fraction; it lists the arrays
/// @pre Collective
bool AreMasks(const std::vector<InputBlocks>& levels, const std::vector<std::string>& names,
  const std::string& labelsOption, Ranks& ranks);

/// Returns an array in which 1 is full: an array of type unsigned char with another type.
std::shared_ptr<const BlockArray> ViewMask(std::shared_ptr<const BlockArray> array);

/// Returns a tolerance of two digits, at most LargestFractionTolerance, that accepts a distance.
/// @param distance  from [0, 1], above 0
double SufficientTolerance(double distance);

/// Fractions outside [0, 1] by more than is accepted; NaN does not count.
struct OutsideFractions
{
  double Largest = 0.0; ///< distance from [0, 1]
  double Value = 0.0;
  int Material = 0;       ///< of Value
  Index3 First{};         ///< cell of Value, with the lowest indices, z before y before x
  double Lowest = 0.0;    ///< lowest finite value, if it is negative
  int LowestMaterial = 0; ///< of Lowest; the first one

  void Add(const OutsideFractions& other);
};

/// Checks the fractions of all ranks.
/// @param mine  fractions of this rank
/// @param names  array of each material
/// @throws InputError  on all ranks, with the tolerance that suffices, or with the option for level
///   sets if values are negative by more than LargestFractionTolerance. Other distances above it
///   are left to FractionField, which rejects them.
/// @pre Collective
void CheckOutside(
  const OutsideFractions& mine, const std::vector<std::string>& names, Ranks& ranks);

/// Sums of fractions that exceed 1 by more than is accepted.
struct OverfullCells
{
  Index Count = 0;
  double LargestSum = 0.0, FirstSum = 0.0;
  Index3 First{}; ///< cell with the lowest indices, z before y before x

  void Add(const OverfullCells& other);
};

/// Checks the sums of all ranks.
/// @param mine cells of this rank
/// @param cells number of cells of this rank
/// @throws InputError on all ranks, with the tolerance that suffices, if there is one
/// @pre Collective
void CheckSums(const OverfullCells& mine, Index cells, Ranks& ranks);

} // namespace vfm
