#include "Meshes/Exodus/WriteExodus.h"

#include "Meshes/Exodus/ExodusLayout.h"
#include "Meshes/Exodus/WriteNetcdf.h"
#include "Meshes/Files/OutputSet.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Ranks/WorkTogether.h"
#include "Report/Gather/GatherMesh.h"

namespace vfm
{
namespace
{

/// Returns path.N.RANK for several ranks; RANK has as many digits as N.
std::string PartPath(const std::string& path, const Ranks& ranks)
{
  if (ranks.Count() == 1)
  {
    return path;
  }
  const std::string count = std::to_string(ranks.Count()), rank = std::to_string(ranks.Rank());
  return path + "." + count + "." + std::string(count.size() - rank.size(), '0') + rank;
}

/// Writes the file of this rank. If there are several files, error messages contain its path.
void WritePart(const ExodusModel& model, const std::string& part, int ranks, OutputSet& files)
{
  const NetcdfFormat format =
    model.HasWideIds || model.HasLargeArrays ? NetcdfFormat::Wide : NetcdfFormat::Classic;
  PrefixErrors(ranks > 1 ? part + ": " : "",
    [&] { WriteNetcdf(MakeExodusLayout(model, ranks), part, format, files); });
}

/// Writes the files of all ranks, or none if one of them fails.
/// @param whole  the mesh with the hexes that it leaves out; null: none
/// @pre Collective
void WriteParts(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const MeshWithRuns* whole = nullptr)
{
  const ExodusModel model = MakeExodusModel(mesh, ranks, whole);
  const std::string part = PartPath(path, ranks);
  OutputSet files(part);
  WorkTogether(ranks,
    [&]
    {
      WritePart(model, part, ranks.Count(), files);
      files.Rename(ranks);
    });
}

} // namespace

void WriteExodus(const MeshData& mesh, const std::string& path, Ranks& ranks, ExodusParts parts)
{
  if (parts == ExodusParts::OnePerRank || ranks.Count() == 1)
  {
    WriteParts(mesh, path, ranks);
    return;
  }
  const StoredMesh ordered = OrderMesh(mesh, ranks);
  StoredMesh whole = GatherMesh(ordered.Data, ranks);
  const std::shared_ptr<const ParticleData> particles = GatherParticles(mesh.Particles, ranks);
  whole.Data.Particles = particles.get();
  WorkTogether(ranks,
    [&]
    {
      if (ranks.Rank() == 0)
      {
        Ranks alone;
        WriteParts(whole.Data, path, alone);
      }
    });
}

void WriteExodus(const MeshData& mesh, const MeshWithRuns& whole, const std::string& path)
{
  Ranks alone;
  WriteParts(mesh, path, alone, &whole);
}

} // namespace vfm
