#include "Meshes/OpenFoam/WriteFoam.h"

#include "Meshes/Files/ElementNodes.h"
#include "Meshes/Files/WriteWhole.h"
#include "Meshes/OpenFoam/FoamCloud.h"
#include "Meshes/OpenFoam/FoamFolder.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/Polyhedra/WriteDual.h"
#include "Ranks/WorkTogether.h"
#include "Report/FlatData.h"
#include "Report/Gather/GatherMesh.h"

#include <algorithm>
#include <optional>

namespace vfm
{
namespace
{

/// Throws InputError for periodic meshes that OpenFOAM cannot read, on all ranks.
/// @pre Collective
void CheckPeriodic(const MeshData& mesh, Ranks& ranks)
{
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  const bool isPeriodic =
    std::any_of(lengths.begin(), lengths.end(), [](double length) { return length > 0.0; });
  if (ranks.Any(isPeriodic && !mesh.PeriodicPartner && mesh.NumberOfElements > 0))
  {
    throw InputError("OpenFOAM needs a periodic mesh that is cut open: PeriodicSides flat or free, "
                     "and the array PeriodicPartner.");
  }
}

/// Writes the files of a case. All appear, or none.
/// @param writeMesh  writeMesh(part, files) writes the mesh in the folder of this rank
/// @pre Collective
template <class WriteMesh>
void WriteFiles(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const WriteMesh& writeMesh)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const std::string part =
    ranks.Count() > 1 ? folder + "/processor" + std::to_string(ranks.Rank()) : folder;
  OutputSet files(path);
  WorkTogether(ranks,
    [&]
    {
      writeMesh(part, files);
      if (mesh.Particles)
      {
        WriteCloud(*mesh.Particles, part, files);
      }
      if (ranks.Rank() == 0)
      {
        WriteCaseFiles(folder, path, ranks.Count(), files);
      }
      files.Rename(ranks);
    });
}

/// Writes the mesh of each rank, or one mesh if there is one rank.
/// @pre Collective
void WriteCase(const MeshData& mesh, const std::string& path, Ranks& ranks, bool isBinary)
{
  WorkTogether(ranks, [&mesh] { RequireNodes(mesh, {}, "OpenFOAM"); });
  CheckPeriodic(mesh, ranks);
  const FoamMesh foam = MakeFoamMesh(mesh, ranks);
  WorkTogether(ranks, [&foam] { CheckSizes(foam); });
  std::optional<FoamAddressing> addressing;
  if (ranks.Count() > 1)
  {
    addressing = FindAddressing(foam, ranks);
  }
  WriteFiles(mesh, path, ranks,
    [&](const std::string& part, OutputSet& files)
    { WritePolyMesh(foam, addressing ? &*addressing : nullptr, part, isBinary, files); });
}

/// Writes a whole mesh on one rank.
void WriteWholeCase(const MeshData& whole, const std::string& path, const FoamForm& form)
{
  Ranks alone;
  if (!form.IsDual)
  {
    WriteCase(whole, path, alone, form.IsBinary);
    return;
  }
  RequireDual(whole);
  WriteFiles(whole, path, alone,
    [&](const std::string& folder, OutputSet& files)
    { WriteDualFoam(whole, folder, form.IsBinary, files); });
}

} // namespace

void WriteFoam(const MeshData& mesh, const std::string& path, Ranks& ranks, const FoamForm& form)
{
  if (form.IsDual && !form.IsWhole && ranks.Count() > 1)
  {
    throw InputError("Polyhedra are written as one mesh, which rank 0 gathers: with several ranks "
                     "they need the option of a single file (--single-file).");
  }
  if (form.IsWhole || ranks.Count() == 1 || ranks.Any(IsFlat(mesh)))
  {
    WriteWhole(mesh, ranks, [&](const MeshData& whole) { WriteWholeCase(whole, path, form); });
    return;
  }
  StoredMesh part = OrderMesh(TakeKnownArrays(mesh), ranks);
  const std::shared_ptr<const ParticleData> particles = OrderParticles(mesh.Particles, ranks);
  part.Data.Particles = particles.get();
  WriteCase(part.Data, path, ranks, form.IsBinary);
}

} // namespace vfm
