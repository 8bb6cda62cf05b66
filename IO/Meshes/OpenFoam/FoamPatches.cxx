#include "Meshes/OpenFoam/FoamPatches.h"

#include <algorithm>

namespace vfm
{

std::vector<FoamPatch> ListPatches(const FoamSurfaces& surfaces, UniqueNames& used)
{
  std::vector<FoamPatch> patches;
  for (const FoamSurface& surface : surfaces.Surfaces)
  {
    const std::string& interface = surfaces.Surfaces[surface.Interface].Name;
    patches.push_back({ used.Add(surface.Name), surface.IsDomainSide ? "patch" : "wall",
      interface == surface.Name ? "" : interface });
  }
  patches.push_back({ used.Add("defaultFaces"), "patch", "" });
  return patches;
}

void RemoveEqualGroups(std::vector<FoamPatch>& patches)
{
  for (FoamPatch& patch : patches)
  {
    if (std::any_of(patches.begin(), patches.end(),
          [&patch](const FoamPatch& other) { return other.Name == patch.Group; }))
    {
      patch.Group.clear();
    }
  }
}

} // namespace vfm
