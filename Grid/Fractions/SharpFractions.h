/**
 * SharpFractions: sharp fractions in a cell, from a smooth field of fractions. A material gets the
 * part of the cell where its field is the largest.
 *
 * The field of a material has the fraction of each cell at the cell centre and is linear between
 * centres along each axis. Up to the sides of the domain it is extrapolated. So it is trilinear in
 * each octant of a cell. The plane of their difference separates two materials in an octant; three
 * or more are sampled.
 */
#pragma once

#include "Fractions/FractionField.h"

namespace vfm
{

/// Field of a material around a cell. Values[x + 3 y + 9 z] is its value at the lower side (0),
/// middle (1) or upper side (2) along x, y and z.
struct MaterialPatch
{
  int Material;
  std::array<double, 27> Values;
};

/// Exchange between two materials in a cell. First gains Rate * (a - b) of the cell from Second if
/// their fields grow by small relative amounts a and b.
struct PairRate
{
  int First, Second; ///< the smaller first
  double Rate;
};

/// Returns the patches of some materials around a cell, in the order of the materials.
/// @param smooth  the 26 cells around must be in the local box or outside the domain
/// @param weights  factor of each field, by material
std::vector<MaterialPatch> MakePatches(const CartesianGrid& grid, const FractionField& smooth,
  const Index3& cell, const std::vector<int>& materials, const std::vector<double>& weights);

/// Returns the fraction of the cell where each material has the largest field. Materials without a
/// fraction are left out; the sum is 1.
/// @param[in,out] rates  rates of pairs of materials are appended, unless it is null
std::vector<FractionField::Part> FindSharpFractions(
  const std::vector<MaterialPatch>& patches, std::vector<PairRate>* rates = nullptr);

/// Returns the fraction of each child that the first of two materials fills. It fills the region
/// where its field plus a constant exceeds the field of the second.
/// @param counts  number of children along each axis
/// @param fraction  fraction of the cell that the first fills, 0 to 1; determines the constant
/// @return one entry per child, x fastest
std::vector<double> ShareChildren(
  const MaterialPatch& first, const MaterialPatch& second, const Index3& counts, double fraction);

} // namespace vfm
