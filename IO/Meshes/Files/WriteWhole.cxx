#include "Meshes/Files/WriteWhole.h"

#include "Meshes/Particles/GatherParticles.h"
#include "Ranks/WorkTogether.h"
#include "Report/Gather/GatherMesh.h"

namespace vfm
{

void WriteWhole(const MeshData& mesh, Ranks& ranks,
  const std::function<void(const MeshData&)>& write,
  const std::function<bool(const MeshArray&)>& isTaken)
{
  WorkTogether(ranks, [&] { Require(mesh.Material, "MaterialId", mesh); });
  const StoredMesh ordered = OrderMesh(TakeKnownArrays(mesh, isTaken), ranks);
  StoredMesh whole = GatherMesh(ordered.Data, ranks);
  const std::shared_ptr<const ParticleData> particles = GatherParticles(mesh.Particles, ranks);
  whole.Data.Particles = particles.get();
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        write(whole.Data);
      }
    });
}

} // namespace vfm
