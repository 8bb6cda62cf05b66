#include "Meshes/OpenFoam/FoamAddressing.h"

#include "Ranks/Agreement.h"
#include "Ranks/WorkTogether.h"

#include <tuple>

namespace vfm
{
namespace
{

/// A face that this rank numbers: all except those whose owner is on another rank.
struct OwnedFace
{
  int Group;              ///< 0 inner faces of the whole mesh, from 1 patches
  Index Owner, Neighbour; ///< positions of cells in the whole mesh
  Index Face;
  auto operator<=>(const OwnedFace&) const = default;
};

bool IsCyclic(const FoamPatch& patch)
{
  return !patch.Opposite.empty() || !patch.Refer.empty();
}

/// Returns the faces that this rank numbers, except those of cyclic patches, in the order of the
/// whole case.
std::vector<OwnedFace> ListOwnedFaces(const FoamMesh& foam)
{
  std::vector<OwnedFace> faces;
  const std::vector<Index>& positions = foam.Cells.Positions;
  Index face = 0;
  for (Index neighbour : foam.Neighbours)
  {
    faces.push_back({ 0, positions[foam.Owner(face)], positions[neighbour], face });
    ++face;
  }
  int group = 0;
  for (const FoamPatch& patch : foam.Patches)
  {
    ++group;
    for (Index i = 0; patch.Type != "processor" && i < patch.Count; ++i, ++face)
    {
      if (!IsCyclic(patch))
      {
        faces.push_back({ group, positions[foam.Owner(face)], NothingBehind, face });
      }
    }
  }
  for (const RemoteSide& side : foam.Remote)
  {
    const Index cell = positions[foam.Owner(face)];
    if (cell < side.Cell)
    {
      faces.push_back({ 0, cell, side.Cell, face });
    }
    ++face;
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Counts the faces of each group and cell.
std::vector<FaceCount> CountFaces(const std::vector<OwnedFace>& faces)
{
  std::vector<FaceCount> counts;
  for (const OwnedFace& face : faces)
  {
    if (counts.empty() || counts.back().Group != face.Group || counts.back().Cell != face.Owner)
    {
      counts.push_back({ face.Owner, face.Group, 0 });
    }
    ++counts.back().Count;
  }
  return counts;
}

/// Sets the numbers, from 1, of the faces of cyclic patches, which are the first patches.
/// @param inner  number of inner faces of the whole mesh
void NumberCyclicFaces(const FoamMesh& foam, Index inner, std::vector<Index>& numbers)
{
  Index face = static_cast<Index>(foam.Neighbours.size());
  auto next = foam.CyclicNumbers.begin();
  for (const FoamPatch& patch : foam.Patches)
  {
    for (Index i = 0; i < patch.Count; ++i, ++face)
    {
      numbers[face] = IsCyclic(patch) ? inner + *next++ + 1 : numbers[face];
    }
  }
}

/// Sets the numbers, from 1, of the faces that this rank numbers.
/// @pre Collective
void NumberOwnedFaces(const FoamMesh& foam, std::vector<Index>& numbers, Ranks& ranks)
{
  const std::vector<OwnedFace> faces = ListOwnedFaces(foam);
  const std::vector<FaceCount> counts = CountFaces(faces);
  const auto patches = std::count_if(foam.Patches.begin(), foam.Patches.end(),
    [](const FoamPatch& patch) { return patch.Neighbour < 0; });
  const std::vector<Index> first =
    NumberFaces(counts, 1 + static_cast<int>(patches), foam.Cells.Total, ranks);
  Index inner = 0;
  auto face = faces.begin();
  for (std::size_t entry = 0; entry < counts.size(); ++entry)
  {
    const bool isInner = counts[entry].Group == 0;
    const Index before = first[entry] + (isInner ? 0 : foam.TotalCyclic);
    inner += isInner ? counts[entry].Count : 0;
    for (Index i = 0; i < counts[entry].Count; ++i, ++face)
    {
      numbers[face->Face] = before + i + 1;
    }
  }
  NumberCyclicFaces(foam, SumOverRanks(inner, ranks), numbers);
}

/// Sets the numbers of the faces whose owners are on other ranks; they are negative.
/// @pre Collective
void TakeNumbers(const FoamMesh& foam, std::vector<Index>& numbers, Ranks& ranks)
{
  std::vector<int> peers;
  std::vector<std::vector<Index>> lists; // numbers of all faces to each rank; 0 unknown
  std::size_t begin = foam.Sides.size() - foam.Remote.size();
  for (const FoamPatch& patch : foam.Patches)
  {
    if (patch.Type == "processor")
    {
      peers.push_back(patch.Neighbour);
      lists.emplace_back(numbers.begin() + begin, numbers.begin() + begin + patch.Count);
      begin += patch.Count;
    }
  }
  std::size_t face = foam.Sides.size() - foam.Remote.size();
  for (Index number : ExchangeItems(ranks, peers, lists))
  {
    numbers[face] = numbers[face] == 0 ? -number : numbers[face];
    ++face;
  }
}

} // namespace

FoamAddressing FindAddressing(const FoamMesh& foam, Ranks& ranks)
{
  FoamAddressing addressing{ foam.Points.Positions, foam.Cells.Positions, {}, {} };
  WorkTogether(ranks,
    [&]
    {
      addressing.Faces.assign(foam.Sides.size(), 0);
      NumberOwnedFaces(foam, addressing.Faces, ranks);
      TakeNumbers(foam, addressing.Faces, ranks);
      for (const FoamPatch& patch : foam.Patches)
      {
        addressing.Patches.push_back(
          patch.Neighbour < 0 ? static_cast<Index>(addressing.Patches.size()) : -1);
      }
    });
  return addressing;
}

} // namespace vfm
