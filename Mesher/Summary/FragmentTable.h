/**
 * FragmentTable: what each fragment of a mesh is.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"
#include "Summary/MeshFields.h"

namespace vfm
{

struct FragmentSummary
{
  int Material = 0;
  Index Elements = 0;
  double Volume = 0.0, Mass = 0.0; ///< mass 0 without densities
  Vector3 Centroid{}, Momentum{};  ///< of the volume; 0 without a velocity
  std::array<double, 6> Bounds{};  ///< x from, to, y from, to, z from, to
  std::vector<int> Neighbours;     ///< ids of the fragments that share faces with it, ascending
};

/// Names of arrays of the elements.
struct FragmentArrays
{
  std::vector<std::string> Densities; ///< mass per volume: none, one for all materials, or one per
                                      ///< material in the order of the field MaterialIds
  std::string Velocity;               ///< with three components; empty: none
};

/// Collective: the fragments 1, 2, ... of all ranks, on all ranks, the same for any number of ranks.
/// Throws InputError, on all ranks alike, when arrays are missing, of other sizes, or of another number.
std::vector<FragmentSummary> FindFragments(
  const MeshData& mesh, const FragmentArrays& arrays, Ranks& ranks);

/// Collective: on rank 0 columns with a row per fragment: FragmentId, MaterialId, Material
/// (name), Elements, FractionVolume (of its cells' fractions, where there is a field FragmentTargetVolume), MeshVolume, CentroidX/Y/Z, MinX, MaxX, MinY,
/// MaxY, MinZ, MaxZ, Mass (with densities) and Neighbours (ids with blanks between). On other ranks none.
/// Throws as FindFragments.
FieldArrays MakeFragmentTable(
  const MeshData& mesh, const std::vector<std::string>& densities, Ranks& ranks);

} // namespace vfm
