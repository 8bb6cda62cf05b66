/**
 * MaterialBins: elements of a material in groups with similar values of an array, such as grey
 * values or densities. Files of solvers hold each group as a material of its own, with a modulus.
 *
 * The mesh keeps its materials, so interfaces, named sets and fragments stay as they are. The
 * groups are the array BinId and the fields BinIds, BinNames and so on, one row per group.
 */
#pragma once

#include "Input/FieldArray.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Name of the array with the id of the group of each element; 0: it is in none.
constexpr const char* BinIdName = "BinId";

/// Elastic constants that follow from the mean value of a group: the density is
/// rho = Offset + Slope * value, and Young's modulus Factor * rho^Exponent.
struct ElasticLaw
{
  double Factor = 1.0, Exponent = 1.0;
  double Poisson = 0.3;
  double Offset = 0.0, Slope = 1.0;
};

/// Elastic constants of a group.
struct ElasticConstants
{
  double Density, Modulus, Poisson;
};

/// Which elements are grouped, and how.
struct BinRule
{
  std::string Array;          ///< of elements, real or integer, one component
  int Count = 20;             ///< number of intervals of equal width between the extreme values
  std::vector<int> Materials; ///< ids; empty: all but the void
  std::optional<ElasticLaw> Law;
};

constexpr int LargestBinCount = 10000;

/// The elements of a material whose values are in an interval; the last interval has its end.
struct MaterialBin
{
  int Id;           ///< above the ids of all materials, also of a meshed void
  int Material;     ///< id
  int Number;       ///< of the interval, from 1
  std::string Name; ///< as in "bone_bin_03"
  double Lower, Upper;
  double Mean;    ///< of the values, weighted by volume
  double Volume;  ///< of the elements; of a mesh of a plane their area
  Index Elements; ///< number on all ranks
  std::optional<ElasticConstants> Elastic = {}; ///< none without a law
};

/// Groups of a mesh.
struct BinnedElements
{
  std::vector<int> Ids;           ///< values of BinId of this rank
  std::vector<MaterialBin> Bins;  ///< with elements, ascending by material and number
  std::vector<FieldArray> Fields; ///< ListBins
};

/// Groups the elements of the mesh. Earlier groups of the mesh are ignored.
/// @throws InputError  if the mesh has no such array, or it has several components or values that
///   are not finite; if all values are equal, but Count is not 1; if Count or the law is not valid,
///   or gives a density or a modulus that is not above 0; the same message on all ranks
/// @pre Collective
/// @note Ids and table are the same for any number of ranks.
BinnedElements BinElements(const MeshData& mesh, const BinRule& rule, Ranks& ranks);

/// Lists columns with one row per group: BinIds, BinNames, BinMaterials, BinNumbers, BinLower,
/// BinUpper, BinMean, BinVolume, BinElements; with a law BinDensity, BinModulus, BinPoisson.
std::vector<FieldArray> ListBins(const std::vector<MaterialBin>& bins);

/// Returns the groups in the fields of a mesh; none if it has none, or not the array BinId.
/// @throws InputError  if columns are missing or differ in length
std::vector<MaterialBin> ReadBins(const MeshData& mesh);

/// Returns the greatest id of groups in the fields of a mesh; 0 if it has none.
int FindLastBinId(const MeshData& mesh);

/// Puts the columns in place of earlier ones, of which those that are missing now are removed.
void ReplaceBins(const std::vector<FieldArray>& columns, std::vector<FieldArray>& fields);

} // namespace vfm
