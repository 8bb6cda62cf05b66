/**
 * FragmentTable: material, size, position and neighbours of each fragment of a mesh.
 */
#pragma once

#include "Options/MesherOptions.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"
#include "Report/MeshFields.h"

namespace vfm
{

/// A fragment: face-connected elements of one material, over all ranks. Lengths, volumes and masses
/// have the units of the input.
struct FragmentSummary
{
  int Id = 0, Material = 0;
  Index Elements = 0;
  double Volume = 0.0, Mass = 0.0; ///< mass 0 without densities
  Vector3 Centroid{}, Momentum{};  ///< centroid of the volume; momentum 0 without a velocity
  std::array<double, 6> Bounds{};  ///< x min, max, y min, max, z min, max
  double TargetVolume = -1.0;      ///< by the fractions; below 0: the mesh does not list it
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
/// @return fragments that have elements, ascending by id, each on one rank; ids rise with the ranks
/// (FragmentWays). Bitwise identical for any number of ranks
/// @throws InputError if arrays are missing, have other numbers of components, or if the number of
/// density arrays is wrong; on all ranks
/// @pre Collective
std::vector<FragmentSummary> FindFragments(
  const MeshData& mesh, const FragmentArrays& arrays, Ranks& ranks);

/// Tabulates the fragments of a mesh.
/// Columns: FragmentId, MaterialId, Material (name), Elements, FractionVolume, MeshVolume,
/// CentroidX/Y/Z, MinX, MaxX, MinY, MaxY, MinZ, MaxZ, Mass and Neighbours (ids separated by
/// spaces). FractionVolume, from the volume fractions, requires their volumes of all fragments
/// (FragmentTargets.h). Mass requires densities.
/// @return columns with one row per fragment of FindFragments on this rank; the columns, also those
/// without rows, are the same on all ranks
/// @throws InputError if FindFragments does
/// @pre Collective
FieldArrays MakeFragmentTable(
  const MeshData& mesh, const std::vector<std::string>& densities, Ranks& ranks);

/// Gathers a table that is in parts on rank 0 if every rank gets tables of this length
/// (HasWholeTable).
/// @param part  columns of this rank, the same on all ranks
/// @return all rows in the order of the ranks on rank 0, no columns on other ranks; otherwise part
/// @pre Collective
FieldArrays GatherTable(FieldArrays part, TableMode mode, Ranks& ranks);

} // namespace vfm
