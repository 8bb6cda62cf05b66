/**
 * WriteExodus: writes a mesh as Exodus, the format of many finite-element codes.
 *
 * Contents of a file:
 * - one element block per material, with its id and name, of type HEX8 or TETRA
 * - one block of type SPHERE per material with particles, with the id of ParticlePart and the name
 *   steel_particles; attributes radius and volume; a node at each particle. Ids in the maps follow
 *   the greatest of the mesh on all ranks
 * - side sets and node sets (MeshSets) with ids and names
 * - GlobalCellIds and GlobalPointIds as element map and node map
 * - arrays of elements and points as variables, numbers of the fields as global variables, at the
 *   time of the mesh, or 0 without a time
 * - a QA record
 *
 * The format is netCDF classic with 64-bit offsets, which all readers support. If an id exceeds
 * 2^31 - 1 or an array exceeds 4 GiB, it is netCDF-4.
 */
#pragma once

#include "Elements/MeshWithRuns.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

enum class ExodusParts
{
  OnePerRank, ///< one file per rank, path.N.RANK for N > 1 ranks, with Nemesis data; epu joins them
  One         ///< one file, equal to that of a single rank; rank 0 gathers the mesh
};

/// Writes the files of a mesh. Equal meshes give bitwise identical files, except for the date in
/// their QA record.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if the mesh is empty or lacks a required array, or if a file cannot be
///   written; on all ranks. The earlier files of all ranks then remain
/// @pre Collective
void WriteExodus(const MeshData& mesh, const std::string& path, Ranks& ranks,
  ExodusParts parts = ExodusParts::OnePerRank);

/// Writes the same file of a mesh on one rank, without holding the hexes that the mesh leaves out.
/// In the format netCDF-4, bytes that are no values may differ.
/// @param whole  the mesh with these hexes
void WriteExodus(const MeshData& mesh, const MeshWithRuns& whole, const std::string& path);

} // namespace vfm
