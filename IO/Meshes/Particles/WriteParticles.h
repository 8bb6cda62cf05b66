/**
 * WriteParticles: files with only the particles: of VTK, also beside mesh files that hold none, and
 * of LAMMPS.
 */
#pragma once

#include "Meshes/Files/OutputSet.h"
#include "Ranks/Ranks.h"
#include "Report/ParticleData.h"

#include <string>

namespace vfm
{

/// Returns the path of the particles beside a mesh: NAME_particles.vtp; of bones_{}.stl
/// bones_particles.vtp.
std::string PathOfParticles(const std::string& mesh);

/// Writes the particles of a whole mesh to PathOfParticles(path), as vertices with all arrays, the
/// names of materials and the time; nothing if the mesh was made without particles.
/// @param files  set with the file of the mesh, so that both appear together
/// @throws InputError  if the file cannot be written; contains the reason
void WriteParticlesBeside(const MeshData& whole, const std::string& path, OutputSet& files);

/// Writes only the particles as .vtp, on rank 0.
/// @param mesh  part of this rank; it may be empty
/// @throws InputError  if the mesh was made without particles, if GatherParticles does, or if the
///   file cannot be written; on all ranks. The earlier file then remains
/// @pre Collective
void WriteVtpParticles(const MeshData& mesh, const std::string& path, Ranks& ranks);

/// Writes only the particles as a data file of LAMMPS and LIGGGHTS for atom_style sphere:
/// - atoms 1, 2, 3, .. in the order of the ids of particles: id type diameter density x y z
/// - types 1, 2, 3, .. are the materials of the run (field MaterialIds) in ascending order, named
/// in
///   comments
/// - a box around all spheres, one radius of the largest beyond their centres
/// - velocities, with rotations of 0, if particles have an array of them
/// @throws InputError  also if particles have no mass, which a density requires
/// @pre Collective
void WriteLammps(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
