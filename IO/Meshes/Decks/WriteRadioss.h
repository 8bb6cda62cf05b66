/**
 * WriteRadioss: writes a mesh as a starter file of OpenRadioss.
 *
 * The file contains the mesh and its state, without materials and engine options:
 * - /NODE, /BRICK or /TETRA4 of each part
 * - /PART of each material, with its name and id; its material has the same number, and must be
 *   added. /PROP/SOLID/1 with default values
 * - /SPHCEL of the particles of each material with their masses, or volumes if there is no density;
 *   /PART and /PROP/TYPE34 of the same number, with the number of the material
 * - /GRNOD/NODE of each node set, /SURF/SEG of each named surface (NamedSurfaces.h), with their
 *   names and ids
 * - /INIVEL/NODE, if the mesh has velocities of nodes; /INIBRI/STRS_FGLO, if it has other arrays of
 *   DeckState (DeckModel.h)
 *
 * OpenRadioss solves plane strain in its plane of y and z. Quads of a plane are /QUAD there, with
 * /ANALY, edges in /SURF/SEG, and /INIQUA instead of /INIBRI: y and z are the axes of the plane in
 * cyclic order, x and y of a layer across z. Its triangles, /TRIA, are for one law of fluids only.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if WriteDeck does, if the mesh has an energy without a density or triangles
///   of a plane, or if the file cannot be written; on all ranks. The earlier file then remains
/// @pre Collective
void WriteRadioss(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
