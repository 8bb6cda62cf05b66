/**
 * WriteAbaqus: writes a mesh as an input file of Abaqus and CalculiX, also for *INCLUDE.
 *
 * The file contains only the mesh, without sections, materials or steps:
 * - *NODE, in the set NALL
 * - *ELEMENT of type C3D8, C3D20, C3D20R, C3D4 or C3D10, in a plane CPE4, CPE3, CPS4 or CPS3, one
 *   element set per material, EB and its id, whose ids deal.II reads
 * - *ELSET with the name of each material; EALL contains all elements
 * - *ELEMENT of type MASS and *MASS at each particle; *NSET and *ELSET of the particles of each
 *   material, only *NSET if there is no density
 * - *NSET of each node set and *SURFACE of each side set (MeshSets.h)
 * - *INITIAL CONDITIONS, if a point array with three components has "velocity" in its name
 *
 * DeckModel.h has the numbers of nodes and elements.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Choices among the types of elements.
struct AbaqusForm
{
  bool IsReduced = false;     ///< C3D20R instead of C3D20
  bool IsPlaneStress = false; ///< CPS4, CPS3 instead of CPE4, CPE3
};

/// Writes one file on rank 0. Its contents do not depend on the number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file
/// @throws InputError  if the mesh is empty or lacks a required array, if it is one of another
/// plane
///   than that of x and y, or if the file cannot be written; on all ranks. The earlier file then
///   remains
/// @pre Collective
/// @note Rank 0 needs the memory of GatherMesh.
void WriteAbaqus(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const AbaqusForm& form = {});

} // namespace vfm
