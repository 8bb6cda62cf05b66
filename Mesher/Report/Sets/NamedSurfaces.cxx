#include "Report/Sets/NamedSurfaces.h"

#include "Base/Sorted.h"

namespace vfm
{
namespace
{

bool OwnsFaces(const SideSet& set)
{
  const bool isOneSided = set.Kind == SurfaceKind::Interface || set.Kind == SurfaceKind::SmoothSide;
  return !isOneSided || OwnsFace(set.Materials[0], set.Materials[1]);
}

struct Candidate
{
  ElementSide Face;
  const NamedSurface* Surface;
};

/// Lists the faces of all sides of the domain, interfaces and smooth sides, finest surface first.
std::vector<Candidate> ListCandidates(const std::vector<NamedSurface>& surfaces)
{
  std::vector<Candidate> candidates;
  for (SurfaceKind kind :
    { SurfaceKind::DomainSide, SurfaceKind::SmoothSide, SurfaceKind::Interface })
  {
    for (const NamedSurface& surface : surfaces)
    {
      if (surface.Kind == kind)
      {
        for (const ElementSide& face : surface.Sides)
        {
          candidates.push_back({ face, &surface });
        }
      }
    }
  }
  return candidates;
}

} // namespace

std::vector<NamedSurface> SelectNamedSurfaces(std::vector<SideSet> sets)
{
  sets.erase(
    std::remove_if(sets.begin(), sets.end(), [](const SideSet& set) { return !OwnsFaces(set); }),
    sets.end());
  return sets;
}

std::vector<NamedSurface> FindNamedSurfaces(const MeshData& mesh, Ranks& ranks)
{
  return SelectNamedSurfaces(FindMeshSets(mesh, ranks).SideSets);
}

int TaggedFaces::TagOf(const ElementSide& face) const
{
  const auto found = FindSorted(this->Faces, face);
  return found < 0 ? 0 : this->Tags[found];
}

TaggedFaces TagFaces(const std::vector<NamedSurface>& surfaces)
{
  std::vector<Candidate> candidates = ListCandidates(surfaces);
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Face < b.Face; });
  TaggedFaces tagged;
  for (const Candidate& candidate : candidates)
  {
    if (tagged.Faces.empty() || tagged.Faces.back() < candidate.Face)
    {
      tagged.Faces.push_back(candidate.Face);
      tagged.Tags.push_back(candidate.Surface->Id);
      tagged.Names.emplace(candidate.Surface->Id, candidate.Surface->Name);
    }
  }
  return tagged;
}

} // namespace vfm
