/**
 * Meshes with particles on several ranks, for tests of mesh files.
 */
#pragma once

#include "Cells/ParticleCase.h"
#include "FileCases.h"

namespace vfm
{
namespace testing
{

constexpr Index NumberOfTestParticles = 203;

/// What the mesh and its particles have.
struct ParticleForm
{
  bool HasMass = true, HasNodalVelocity = true;
  Index Count = NumberOfTestParticles;
  MeshChange Change = {}; ///< of the mesh before particles are added
};

/// Calls work(mesh, ranks) on each rank with its part of WithMesh, its particles, an array "energy"
/// of elements, and velocities of nodes. The last of several ranks has no particles, and no pointer
/// to them.
template <class Work>
void WithParticles(int count, MeshMaker make, const Work& work, const ParticleForm& form = {})
{
  WithMesh(
    count, make,
    [&](const FileCase& part, Ranks& ranks)
    {
      const int holders = std::max(1, count - 1);
      const ParticleCase particles = MakeParticles(form.Count,
        NumbersOfField(part.Mesh.Fields, "DomainBounds"), ranks.Rank(), holders, form.HasMass);
      MeshData mesh = part.Mesh;
      mesh.Particles = ranks.Rank() < holders ? &particles.Data : nullptr;
      std::vector<double> energy, velocity;
      for (Index element = 0; element < mesh.NumberOfElements; ++element)
      {
        energy.push_back(1.5 * static_cast<double>(mesh.ElementIds[element]));
      }
      for (Index point = 0; point < mesh.NumberOfPoints; ++point)
      {
        velocity.insert(
          velocity.end(), { 0.5 * static_cast<double>(mesh.PointIds[point] % 64), 1.0, 2.0 });
      }
      mesh.ElementArrays.push_back({ "energy", ValueType::Double, 1, {}, energy.data() });
      mesh.ElementArrays.push_back({ "density", ValueType::Double, 1, {}, energy.data() });
      if (form.HasNodalVelocity)
      {
        mesh.PointArrays.push_back({ "NodalVelocity", ValueType::Double, 3, {}, velocity.data() });
      }
      work(mesh, ranks);
    },
    {}, form.Change);
}

} // namespace testing
} // namespace vfm
