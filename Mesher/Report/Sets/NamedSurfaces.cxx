#include "Report/Sets/NamedSurfaces.h"

#include <algorithm>

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
  MeshSide Face;
  const NamedSurface* Surface;
};

bool IsBefore(const MeshSide& a, const MeshSide& b)
{
  return a.Element != b.Element ? a.Element < b.Element : a.Side < b.Side;
}

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
        for (const MeshSide& face : surface.Sides)
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

int TaggedFaces::TagOf(const MeshSide& face) const
{
  const auto found = std::lower_bound(this->Faces.begin(), this->Faces.end(), face, IsBefore);
  return this->Tags[found - this->Faces.begin()];
}

TaggedFaces TagFaces(const std::vector<NamedSurface>& surfaces)
{
  std::vector<Candidate> candidates = ListCandidates(surfaces);
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return IsBefore(a.Face, b.Face); });
  TaggedFaces tagged;
  for (const Candidate& candidate : candidates)
  {
    if (tagged.Faces.empty() || IsBefore(tagged.Faces.back(), candidate.Face))
    {
      tagged.Faces.push_back(candidate.Face);
      tagged.Tags.push_back(candidate.Surface->Id);
      tagged.Names.emplace(candidate.Surface->Id, candidate.Surface->Name);
    }
  }
  return tagged;
}

} // namespace vfm
