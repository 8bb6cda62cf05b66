/**
 * FragmentTable: material, size, position and neighbours of each fragment of a mesh.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"
#include "Report/MeshFields.h"

namespace vfm
{

/// A fragment: face-connected elements of one material, over all ranks. Lengths, volumes and masses
/// have the units of the input.
struct FragmentSummary
{
  int Material = 0;
  Index Elements = 0;
  double Volume = 0.0, Mass = 0.0; ///< mass 0 without densities
  Vector3 Centroid{}, Momentum{};  ///< centroid of the volume; momentum 0 without a velocity
  std::array<double, 6> Bounds{};  ///< x min, max, y min, max, z min, max
  std::vector<int> Neighbours;     ///< ids of the fragments that share faces with it, ascending
};

/// Names of element arrays that are summed over fragments.
struct FragmentArrays
{
  std::vector<std::string> Densities; ///< mass per volume: none, one for all materials, or one per
                                      ///< material in the order of the field MaterialIds
  std::string Velocity;               ///< array of three components; empty: none
};

/// Finds the fragments of a mesh. Positions of fragments that sides of a periodic domain cut are
/// those of the whole fragment (FindTranslations).
/// @return fragments 1, 2, ... of all ranks, on all ranks; bitwise identical for any number
/// of ranks
/// @throws InputError if arrays are missing, have other numbers of components, or if the number of
/// density arrays is wrong; on all ranks
/// @pre Collective
std::vector<FragmentSummary> FindFragments(
  const MeshData& mesh, const FragmentArrays& arrays, Ranks& ranks);

/// Tabulates the fragments of a mesh.
/// Columns: FragmentId, MaterialId, Material (name), Elements, FractionVolume, MeshVolume,
/// CentroidX/Y/Z, MinX, MaxX, MinY, MaxY, MinZ, MaxZ, Mass and Neighbours (ids separated by
/// spaces). FractionVolume, from the volume fractions, requires the field FragmentTargetVolume.
/// Mass requires densities.
/// @return columns with one row per fragment on rank 0; no columns on other ranks
/// @throws InputError if FindFragments does
/// @pre Collective
FieldArrays MakeFragmentTable(
  const MeshData& mesh, const std::vector<std::string>& densities, Ranks& ranks);

} // namespace vfm
