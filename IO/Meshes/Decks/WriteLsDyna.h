/**
 * WriteLsDyna: writes a mesh as a keyword file of LS-DYNA, in standard format.
 *
 * The file contains the mesh, without materials and control cards:
 * - *NODE, *ELEMENT_SOLID; tetrahedra repeat their fourth node
 * - *PART of each material, with its name and id; its material has the same number, and must be
 *   defined in another file. *SECTION_SOLID 1
 * - *ELEMENT_SPH at each particle with its mass, or its volume if there is no density; *PART of the
 *   particles of each material, with the number of the material; *SECTION_SPH 2 with defaults
 * - *SET_NODE_LIST_TITLE of each node set, *SET_SEGMENT_TITLE of each named surface
 *   (NamedSurfaces.h), with their names and ids
 * - *INITIAL_VELOCITY_NODE, *INITIAL_STRESS_SOLID, if the mesh has arrays of them (DeckModel.h)
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if WriteDeck does, if a number or id exceeds eight digits, or if the file
///   cannot be written; on all ranks. The earlier file then remains
/// @pre Collective
void WriteLsDyna(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
