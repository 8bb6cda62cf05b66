/**
 * ParticleParts: particles as parts and nodes of a mesh file.
 */
#pragma once

#include "Meshes/Files/MeshModel.h"
#include "Report/ParticleData.h"

namespace vfm
{

/// The particles of a material, as a part or a block of a file.
struct ParticlePart
{
  int Material;
  /// Greater than the ids of all materials, of the void and of cohesive elements. It depends only
  /// on the materials of the run (field MaterialIds), not on those that have particles.
  int Id;
  std::string Name;             ///< "steel_particles"
  std::vector<Index> Particles; ///< of this rank, ascending
};

/// Returns the materials of the run (field MaterialIds) and of mesh.Particles, ascending.
std::vector<int> ListMaterials(const MeshData& mesh);

/// Returns the parts of mesh.Particles, ascending by material; none without particles. All ranks
/// have the same list.
/// @throws InputError  if no integer is left for an id; on all ranks
/// @pre Collective
std::vector<ParticlePart> FindParticleParts(
  const MeshData& mesh, const std::vector<CohesiveBlock>& cohesive, Ranks& ranks);

/// Returns the names of parts as NameMaterials returns those of materials.
std::vector<std::string> NameParts(const std::vector<ParticlePart>& parts,
  std::string (*form)(const std::string&), UniqueNames& used);

/// Returns the mesh with a node at each particle, after its points. At these nodes point arrays
/// have the values of the array of particles with the same name, or the velocity; 0 without one.
/// @param mesh  must outlive the result
/// @param ids  of the new nodes
StoredMesh AddParticleNodes(const MeshData& mesh, const std::vector<Index>& ids);

/// Returns the density of a particle. @pre it has a mass
inline double DensityOf(const ParticleData& particles, Index particle)
{
  return particles.Mass[particle] / particles.Volume[particle];
}

} // namespace vfm
