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

#include <span>

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

/// Finds the patches of materials around cells; keeps its memory, for the next cell.
class PatchFinder
{
public:
  /// @param smooth  fields; the 26 cells around each cell must be in the local box or outside the
  ///   domain
  PatchFinder(const CartesianGrid& grid, const FractionField& smooth);
  PatchFinder(const PatchFinder&) = delete; // it holds pointers to its members
  PatchFinder& operator=(const PatchFinder&) = delete;

  /// Returns the patches of some materials around a cell, in their order. Valid until the next
  /// call.
  /// @param materials  distinct
  /// @param weights  factor of each field, by material
  const std::vector<MaterialPatch>& Find(
    const Index3& cell, std::span<const int> materials, const std::vector<double>& weights);

private:
  const CartesianGrid& Grid;
  const FractionField& Smooth;
  std::vector<MaterialPatch> Patches;
  std::array<double, 27> Unused; // takes the values of all other materials
  std::vector<double*> ValuesOf; // by material, those of its patch or Unused
};

/// How two fields differ in the octants of a cell, one number per octant.
struct OctantDifferences
{
  std::array<double, 8> Least, Greatest; ///< of the first minus the second
  std::array<double, 8> Mean;            ///< of the first minus the second
  std::array<std::array<double, 8>, 3> Slope;
  std::array<double, 8> Value; ///< mean of both fields
};

/// Finds sharp fractions; keeps its memory, for the next cell.
class SharpFractions
{
public:
  /// Returns the fraction of the cell where each patch has the largest field; their sum is 1.
  /// Valid until the next call.
  /// @param[in,out] rates  rates of pairs of materials are appended, unless it is null
  const std::vector<double>& Find(
    const std::vector<MaterialPatch>& patches, std::vector<PairRate>* rates = nullptr);

private:
  void Compare(const std::vector<MaterialPatch>& patches);
  const OctantDifferences& Pair(std::size_t first, std::size_t second) const;
  void FindContenders(std::size_t patches, int octant);
  void PartByPlane(
    const std::vector<MaterialPatch>& patches, int octant, std::vector<PairRate>* rates);
  void PartBySamples(const std::vector<MaterialPatch>& patches, int octant);

  std::vector<double> Fractions;        // by patch
  std::vector<OctantDifferences> Pairs; // of all pairs of patches, by the second, then the first
  std::vector<std::size_t> Contenders;  // patches that no other covers in an octant
  std::vector<std::array<double, 8>>
    Rest;                // their values at the corners, if there are three or more
  std::vector<int> Wins; // samples in which each of them is the largest
};

/// Returns the fraction of each child that the first of two materials fills. It fills the region
/// where its field plus a constant exceeds the field of the second.
/// @param counts  number of children along each axis
/// @param fraction  fraction of the cell that the first fills, 0 to 1; determines the constant
/// @return one entry per child, x fastest
std::vector<double> ShareChildren(
  const MaterialPatch& first, const MaterialPatch& second, const Index3& counts, double fraction);

} // namespace vfm
