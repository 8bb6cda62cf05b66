/**
 * WriteExodus: a mesh as Exodus, the format of many finite-element codes.
 *
 * One element block per material, with its id and its name; side sets and node sets (MeshSets) with ids and names; GlobalCellIds and
 * GlobalPointIds as the maps of elements and nodes; arrays of elements and points as variables and the numbers of the fields as
 * global ones, at the time of the mesh, or 0; a QA record. Elements are HEX8 or TETRA. Files are of netCDF's classic format with
 * 64-bit offsets, which all readers know, unless an id is above 2^31 - 1 or an array of 4 GiB: then of netCDF-4.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

#include <string>

namespace vfm
{

enum class ExodusParts
{
  OneARank, ///< path.N.RANK of N > 1 ranks, with the Nemesis data; SEACAS' epu joins them
  One       ///< path, as from one rank; rank 0 gathers the mesh
};

/// Collective. mesh: this rank's part, of the mesher or read from a file. A file has the same bytes whenever the mesh is the same, except
/// for the date in the QA record. Throws InputError on all ranks when the mesh is none of the mesher or empty, or a file cannot be
/// written; then unfinished files are removed.
void WriteExodus(const MeshData& mesh, const std::string& path, Ranks& ranks,
  ExodusParts parts = ExodusParts::OneARank);

} // namespace vfm
