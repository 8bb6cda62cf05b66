#include "Meshes/Files/WriteWhole.h"

#include "Ranks/WorkTogether.h"
#include "Report/GatherMesh.h"

namespace vfm
{

void WriteWhole(const MeshData& mesh, Ranks& ranks,
  const std::function<void(const MeshData&)>& write,
  const std::function<bool(const MeshArray&)>& isTaken)
{
  WorkTogether(ranks, [&] { Require(mesh.Material, "MaterialId", mesh); });
  const StoredMesh ordered = OrderMesh(TakeKnownArrays(mesh, isTaken), ranks);
  const StoredMesh whole = GatherMesh(ordered.Data, ranks);
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
