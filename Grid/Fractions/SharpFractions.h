/**
 * Sharp fractions in a cell from a smooth field of fractions: the part of the cell where a material has the most.
 *
 * The field of a material is linear along each axis between the centres of the cells, and what a cell holds stands
 * at its centre; up to the sides of the domain it goes on as it is inside. So it is trilinear in each octant of a cell.
 * Two materials in an octant part it by the plane that their difference has there; three or more by samples.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// The field of a material around a cell: at the place (x, y, z), each 0..2 for its lower side, middle and upper side along
/// an axis, Values[x + 3 y + 9 z].
struct MaterialPatch
{
  int Material;
  std::array<double, 27> Values;
};

/// In a cell, First gains Rate * (a - b) of the cell from Second when their fields grow by the small parts a and b.
struct PairRate
{
  int First, Second; ///< the smaller first
  double Rate;
};

/// The patches of some materials, in their order, around a cell of the domain; the 26 cells around it must be in memory.
/// weights: by material, times which its field counts.
std::vector<MaterialPatch> MakePatches(const CartesianGrid& grid, const FractionField& smooth,
  const Index3& cell, const std::vector<int>& materials, const std::vector<double>& weights);

/// The part of the cell where each material has the most; those that have it nowhere are left out. Sums to 1.
/// rates: added to, unless null.
std::vector<FractionField::Part> FindSharpFractions(
  const std::vector<MaterialPatch>& patches, std::vector<PairRate>* rates = nullptr);

/// The part of each child that the first of two materials has, when it has a given part of the cell (0..1): where its
/// field exceeds the other's by so much as gives that. counts: of the children along each axis, numbered as in ChildFractions.h.
std::vector<double> ShareChildren(
  const MaterialPatch& first, const MaterialPatch& second, const Index3& counts, double fraction);

} // namespace vfm
