/**
 * WriteNastran: writes a mesh as bulk data of Nastran, for INCLUDE.
 *
 * The file contains the mesh, without materials and case control:
 * - GRID*, in fields of 16 characters; CHEXA or CTETRA, in a plane CQUAD4 or CTRIA3
 * - PSOLID, or PSHELL of thickness 1, of each material, with its id, and its name in a comment; its
 * material has the same number, and must be defined in another file
 * - CONM2* at each particle with its mass, and a node without one if there is no density
 * - SET1 of each node set, and of the nodes of the particles of each material
 * - PLOAD4 of each named surface (NamedSurfaces.h): a unit pressure, which a LOAD entry scales.
 *   Edges of a plane have no such entry: SET1 has the nodes of each named surface
 *
 * Names of sets are comments. Ids are those of MeshSets.h, or consecutive numbers if one exceeds
 * eight digits.
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
/// @throws InputError  if WriteDeck does, if a number or the id of a material exceeds eight digits,
///   or if the file cannot be written; on all ranks. The earlier file then remains
/// @pre Collective
void WriteNastran(
  const MeshData& mesh, const std::string& path, Ranks& ranks, bool isPlaneStress = false);

} // namespace vfm
