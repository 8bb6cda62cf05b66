#include "Summary/NamedSurfaces.h"

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

} // namespace vfm
