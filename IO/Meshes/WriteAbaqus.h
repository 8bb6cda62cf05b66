/**
 * WriteAbaqus: a mesh as an input file of Abaqus and CalculiX, to be read on its own or by *INCLUDE.
 *
 * The file contains only the mesh: *NODE (set NALL), *ELEMENT of type C3D8 or C3D4 with one element set per material, all of them in
 * the set EALL, *NSET of each node set, *SURFACE of each side set (MeshSets.h), and *INITIAL CONDITIONS of a velocity of the nodes, a
 * point array of three components with that word in its name; no section, material or step. Nodes and elements
 * are numbered from 1 in the order of their global ids: solvers make tables as long as the greatest number.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

#include <string>

namespace vfm
{

/// Collective: one file, by rank 0, which needs the memory of GatherMesh; its bytes do not depend on the number of ranks.
/// mesh: this rank's part, of the mesher or read from a file. Throws InputError on all ranks when the mesh is empty or lacks an
/// array, or the file cannot be written; then it is removed.
void WriteAbaqus(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
