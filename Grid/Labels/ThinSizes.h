/**
 * ThinSizes: how much material the cells of thin parts hold, and how thick these parts are.
 */
#pragma once

#include "Labels/ThinCandidates.h"

#include <functional>

namespace vfm
{

/// Returns the load of a cell of the set of a material: the material in it, and shares of that in
/// the 26 cells around that are not in the set, as a fraction of a cell. Each of these divides its
/// material among the cells of the set around it; more goes to those that are filled and near.
/// @param isInSet  isInSet(cell) for linear indices of cells within two cells
double FindLoad(const CartesianGrid& grid, const FractionField& fractions, Index cell, int material,
  const std::function<bool(Index)>& isInSet);

/// Returns the loads of the candidates in the sets, in the owned cells and one layer around them.
std::vector<double> FindLoads(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, Runtime& runtime);

/// Returns whether a candidate of a set in an owned cell is no cell of a thin part: the set is
/// thinner there than the least thickness, or thick and the candidate holds little.
/// @param loads  FindLoads
bool IsRefused(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, const std::vector<double>& loads, double leastThickness,
  std::size_t candidate);

} // namespace vfm
