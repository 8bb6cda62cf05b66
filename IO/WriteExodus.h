/**
 * WriteExodus: a mesh as Exodus, as finite-element codes take it.
 *
 * One element block a material, with its id and its name; side sets and node sets (MeshSets) with ids and names; GlobalCellIds and
 * GlobalPointIds as the maps of elements and nodes; cell and point arrays as variables and the numbers of the field data as global
 * ones, at the time of the mesh, or 0; a QA record. Elements are HEX8 or TETRA. Files are of netCDF's classic format with 64-bit
 * offsets, which all readers know, unless an id is above 2^31 - 1 or an array of 4 GiB: then of netCDF-4.
 */
#pragma once

#include "Ranks/Ranks.h"

#include <string>

class vtkUnstructuredGrid;

namespace vfm
{

enum class ExodusParts
{
  OneARank, ///< path.N.RANK of N > 1 ranks, with the Nemesis data; SEACAS' epu joins them
  One       ///< path, that of one rank; rank 0 gathers the mesh
};

/// Collective. mesh: this rank's part of the mesh of a filter, also one that was read. But for the date in the QA record a file has
/// the same bytes whenever the mesh has. Throws InputError, on all ranks alike, when the mesh is none of a filter or empty, or a file cannot be
/// written; files that were begun are removed.
void WriteExodus(vtkUnstructuredGrid* mesh, const std::string& path, Ranks& ranks,
  ExodusParts parts = ExodusParts::OneARank);

} // namespace vfm
