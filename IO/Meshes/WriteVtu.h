/**
 * WriteVtu: a mesh as VTK's XML files of unstructured grids, .vtu and .pvtu.
 *
 * All arrays of points and elements and the fields with their names, types, components and texts; GlobalPointIds and
 * GlobalCellIds are marked as global ids, MaterialId as the scalars, the time is the field TimeValue. Values are binary,
 * inline, compressed by zlib in builds with it.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

#include <string>

namespace vfm
{

/// Collective: one file, by rank 0, which needs the memory of GatherMesh; its bytes do not depend on the number of ranks.
/// mesh: this rank's part. Throws InputError, with the reason but without the path, on all ranks, when the parts do not make one mesh or
/// the file cannot be written; then it is removed.
void WriteVtu(const MeshData& mesh, const std::string& path, Ranks& ranks);

/// Collective: path, NAME.pvtu, and one file NAME/NAME_RANK.vtu per rank. mesh: this rank's part. Throws as WriteVtu.
void WritePvtu(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
