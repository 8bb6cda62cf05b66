#include "Meshes/OpenFoam/WriteFoam.h"

#include "Meshes/Files/WriteWhole.h"
#include "Meshes/OpenFoam/FoamFolder.h"
#include "Ranks/WorkTogether.h"
#include "Summary/GatherMesh.h"

#include <limits>
#include <optional>

namespace vfm
{
namespace
{

constexpr Index LargestLabel = std::numeric_limits<std::int32_t>::max();

/// Throws InputError if a number of the whole case or of a list of this rank is too large.
void CheckLabels(const FoamMesh& foam)
{
  const int corners = ElementFaces(foam.Mesh.Corners).Corners;
  const Index offsets = corners * static_cast<Index>(foam.Sides.size());
  const Index largest = std::max({ foam.Points.Total, foam.Cells.Total, foam.TotalFaces, offsets });
  if (largest > LargestLabel)
  {
    throw InputError("The mesh has " + std::to_string(foam.TotalFaces) + " faces with " +
      std::to_string(corners) +
      " corners each. A case of OpenFOAM with labels of 32 bits holds at most 2147483647 corners.");
  }
}

/// Writes the mesh of each rank, or one mesh if there is one rank. All files appear, or none.
/// @pre Collective
void WriteCase(const MeshData& mesh, const std::string& path, Ranks& ranks, bool isBinary)
{
  const FoamMesh foam = MakeFoamMesh(mesh, ranks);
  WorkTogether(ranks, [&foam] { CheckLabels(foam); });
  std::optional<FoamAddressing> addressing;
  if (ranks.Count() > 1)
  {
    addressing = FindAddressing(foam, ranks);
  }
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const std::string part =
    ranks.Count() > 1 ? folder + "/processor" + std::to_string(ranks.Rank()) : folder;
  UnfinishedFolders files;
  WorkTogether(ranks,
    [&]
    {
      WritePolyMesh(foam, addressing ? &*addressing : nullptr, part, isBinary, files);
      ranks.Any(false); // throws if another rank failed
      if (ranks.Rank() == 0)
      {
        WriteCaseFiles(folder, path, ranks.Count(), files);
      }
      ranks.Any(false);
    });
  files.Keep();
}

} // namespace

void WriteFoam(const MeshData& mesh, const std::string& path, Ranks& ranks, const FoamForm& form)
{
  if (form.IsWhole || ranks.Count() == 1)
  {
    WriteWhole(mesh, ranks,
      [&](const MeshData& whole)
      {
        Ranks alone;
        WriteCase(whole, path, alone, form.IsBinary);
      });
    return;
  }
  const StoredMesh part = OrderMesh(TakeKnownArrays(mesh), ranks);
  WriteCase(part.Data, path, ranks, form.IsBinary);
}

} // namespace vfm
