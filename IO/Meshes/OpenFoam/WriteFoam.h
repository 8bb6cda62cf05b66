/**
 * WriteFoam: writes a mesh as a case of OpenFOAM.
 *
 * The path, such as case/mesh.foam, is an empty file that ParaView's reader opens; its folder,
 * which must exist, is the case. The mesh is in case/constant/polyMesh: points, faces, owner,
 * neighbour, boundary, cellZones, faceZones and an empty pointZones, as FoamMesh.h describes. The
 * files controlDict, fvSchemes and fvSolution in case/system, without which no program of OpenFOAM
 * starts, are written only where they do not exist.
 *
 * Particles are a cloud (FoamCloud.h), in a decomposed case on the rank that has them.
 *
 * N > 1 ranks write a decomposed case, as decomposePar does: each rank writes
 * case/processorRANK/constant/polyMesh with patches procBoundaryXtoY to other ranks and the files
 * pointProcAddressing, faceProcAddressing, cellProcAddressing and boundaryProcAddressing, which
 * contain numbers in the case of a single rank. Folders of other numbers of ranks are not removed.
 *
 * A mesh of a plane is a layer of prisms with patches of type empty (FoamLayer.h), always as one
 * case, which rank 0 gathers.
 *
 * OpenFOAM User Guide v1912, chapter 4.1 "Mesh description".
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Form of a case.
struct FoamForm
{
  bool IsWhole = false;  ///< one mesh from several ranks, which rank 0 gathers
  bool IsBinary = false; ///< labels of 32 bits, scalars of 64 bits
  bool IsDual = false;   ///< polyhedra around the nodes of tetrahedra (WriteDual.h)
};

/// Writes a case. Whole meshes have identical bytes from any number of ranks.
/// @param mesh  part of this rank, made by the mesher or read from a file; may be empty
/// @throws InputError  if the mesh of all ranks is empty or lacks a required array, if it is
///   periodic with joined sides, if polyhedra are not made of it or of several ranks without
///   IsWhole, if a number exceeds 2^31 - 1, or if a file cannot be written; on all ranks. The
///   earlier files of all ranks then remain, and the folders that this call made are removed
/// @pre Collective
void WriteFoam(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const FoamForm& form = {});

} // namespace vfm
