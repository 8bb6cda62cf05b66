/**
 * WriteLsDyna: writes a mesh as a keyword file of LS-DYNA, in standard format.
 *
 * The file contains the mesh, without materials and control cards:
 * - *NODE, *ELEMENT_SOLID; tetrahedra repeat their fourth node. In a plane *ELEMENT_SHELL;
 *   triangles repeat their third node
 * - *PART of each material, with its name and id; its material has the same number, and must be
 *   defined in another file. *SECTION_SOLID 1; *SECTION_SHELL 1 of thickness 1
 * - *ELEMENT_SPH at each particle with its mass, or its volume if there is no density; *PART of the
 *   particles of each material, with the number of the material; *SECTION_SPH 2 with defaults
 * - *SET_NODE_LIST_TITLE of each node set, *SET_SEGMENT_TITLE of each named surface
 *   (NamedSurfaces.h), with their names and ids. An edge of a plane repeats its second node
 * - *INITIAL_VELOCITY_NODE, *INITIAL_STRESS_SOLID or _SHELL, if the mesh has arrays of them
 * (DeckModel.h)
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @param isPlaneStress  whether elements of a plane have plane stress instead of plane strain
/// @throws InputError  if WriteDeck does, if a number or id exceeds eight digits, if the mesh is
/// one
///   of another plane than that of x and y, or if the file cannot be written; on all ranks. The
///   earlier file then remains
/// @pre Collective
void WriteLsDyna(
  const MeshData& mesh, const std::string& path, Ranks& ranks, bool isPlaneStress = false);

} // namespace vfm
