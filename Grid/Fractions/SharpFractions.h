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

/// Field of a material around a cell. The value at the lower side (0), middle (1) or upper side (2)
/// along x, y and z is Values[x + Row * y + Layer * z]. The last value of a row is not used.
struct MaterialPatch
{
  static constexpr int Row = 4, Layer = 3 * Row, Size = 3 * Layer;
  static constexpr int Middle = 1 + Row + Layer;

  int Material;
  std::array<double, Size> Values;
};

/// Exchange between two materials in a cell. First gains Rate * (a - b) of the cell from Second if
/// their fields grow by small relative amounts a and b.
struct PairRate
{
  int First, Second; ///< the smaller first
  double Rate;
};

/// Returns a factor by which one field leads another everywhere in a cell: if it, times the weight
/// of the one, exceeds the weight of the other, the other has no part of the cell, and leaving it
/// out changes nothing. Not above 0 if the first field is nearly 0 somewhere.
/// @param one, other  patches of weights 1
double FindLead(const MaterialPatch& one, const MaterialPatch& other);

/// Finds the patches of materials around cells; keeps its memory, for the next cell.
class PatchFinder
{
public:
  explicit PatchFinder(const CartesianGrid& grid, int numberOfMaterials);
  PatchFinder(const PatchFinder&) = delete; // it holds pointers to its members
  PatchFinder& operator=(const PatchFinder&) = delete;

  /// Returns the patches of some materials around a cell, in their order. Valid until the next
  /// call.
  /// @param materials  distinct
  /// @param weights  factor of each field, by material
  /// @param forParts  forParts(visit) calls visit(n, material, fraction) for each part of the 27
  ///   cells around (CellAround), those of the domain that are nearest to them
  template <class ForParts>
  const std::vector<MaterialPatch>& Find(const Index3& cell, std::span<const int> materials,
    const std::vector<double>& weights, const ForParts& forParts)
  {
    this->Begin(materials);
    forParts(
      [&](int n, int material, double fraction)
      {
        const int place = n % 3 + MaterialPatch::Row * (n / 3);
        this->ValuesOf[material][place] = weights[material] * fraction;
      });
    this->End(cell);
    return this->Patches;
  }

private:
  void Begin(std::span<const int> materials);
  void End(const Index3& cell);

  const CartesianGrid& Grid;
  std::vector<MaterialPatch> Patches;
  std::array<double, MaterialPatch::Size> Unused; // takes the values of all other materials
  std::vector<double*> ValuesOf;                  // by material, those of its patch or Unused
};

/// How two fields differ in the octants of a cell.
struct OctantDifferences
{
  bool HasPlanes;       ///< whether Mean, Slope and Value are set
  unsigned FirstCovers; ///< bit o: the first is nowhere less than the second in octant o
  unsigned SecondCovers;
  std::array<double, 8> Mean; ///< of the first minus the second, by octant
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
  OctantDifferences& Pair(std::size_t first, std::size_t second)
  {
    return this->Pairs[second * (second - 1) / 2 + first];
  }
  void FindContenders(const std::vector<MaterialPatch>& patches);
  void PartByPlane(const std::vector<MaterialPatch>& patches, std::size_t first, std::size_t second,
    int octant, std::vector<PairRate>* rates);
  void PartBySamples(const std::vector<MaterialPatch>& patches, int octant);

  std::vector<double> Fractions;        // by patch
  std::vector<OctantDifferences> Pairs; // of all pairs of patches, by the second, then the first
  std::vector<unsigned> IsContender;    // by patch; bit o: no other covers it in octant o
  std::vector<std::array<double, 8>> Corners; // of the contenders in an octant
  std::vector<int> Wins;                      // samples in which each of them is the largest
};

/// Returns the fraction of each child that the first of two materials fills. It fills the region
/// where its field plus a constant exceeds the field of the second.
/// @param counts  number of children along each axis
/// @param fraction  fraction of the cell that the first fills, 0 to 1; determines the constant
/// @return one entry per child, x fastest
std::vector<double> ShareChildren(
  const MaterialPatch& first, const MaterialPatch& second, const Index3& counts, double fraction);

} // namespace vfm
