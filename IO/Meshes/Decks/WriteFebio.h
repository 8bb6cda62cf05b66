/**
 * WriteFebio: writes a mesh as an input file of FEBio, febio_spec 4.0.
 *
 * The file contains the mesh, without boundary conditions, loads and steps:
 * - Material: one per material, isotropic elastic with E = 1 and v = 0.3, to be replaced; also its
 *   density where the elements of the material have one density
 * - Mesh: Nodes; Elements of each material, of type hex8, hex20, tet4 or tet10; Surface of each
 *   named surface (NamedSurfaces.h); NodeSet of each node set (MeshSets.h); the ElementSet
 *   all_elements
 * - MeshDomains: a SolidDomain of each material
 * - MeshData: ElementData of each array of real numbers of the elements, which a material
 *   parameter takes by `<E type="map">NAME</E>`
 *
 * DeckModel.h has the numbers of nodes and elements. Characters of names other than ASCII letters,
 * digits, '-', '.' and '_' become '_'. Particles are in a file beside it (WriteParticles.h).
 * Cohesive elements are left out.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if WriteDeck does, if the elements have 27 nodes, or if the file cannot be
///   written; on all ranks. The earlier file then remains
/// @pre Collective
void WriteFebio(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
