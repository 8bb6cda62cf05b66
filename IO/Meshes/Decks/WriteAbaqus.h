/**
 * WriteAbaqus: writes a mesh as an input file of Abaqus and CalculiX, also for *INCLUDE.
 *
 * The file contains only the mesh, without sections, materials or steps:
 * - *NODE, in the set NALL
 * - *ELEMENT of type C3D8 or C3D4, one element set per material; the set EALL contains all of them
 * - *NSET of each node set and *SURFACE of each side set (MeshSets.h)
 * - *INITIAL CONDITIONS, if a point array with three components has "velocity" in its name
 *
 * Nodes and elements are numbered from 1 in the order of their global ids, because solvers allocate
 * tables up to the greatest number.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

#include <string>

namespace vfm
{

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if the mesh is empty or lacks a required array, or if the file cannot be
///   written; on all ranks. An incomplete file is removed
/// @pre Collective
/// @note Rank 0 needs the memory of GatherMesh.
void WriteAbaqus(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
