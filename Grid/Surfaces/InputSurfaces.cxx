#include "Surfaces/InputSurfaces.h"

#include "Ranks/Errors.h"

#include <utility>

namespace vfm
{
namespace
{

void CheckPatches(const std::vector<int>& patches, std::size_t triangles, std::size_t names)
{
  if (patches.size() != triangles)
  {
    throw InputError("There are " + std::to_string(patches.size()) + " patches of triangles and " +
      std::to_string(triangles) + " triangles.");
  }
  for (int patch : patches)
  {
    if (patch < 0 || patch >= static_cast<int>(names))
    {
      throw InputError("A triangle has the patch " + std::to_string(patch) + ", but there are " +
        std::to_string(names) + " patches.");
    }
  }
}

} // namespace

BodySurface MakeBody(const std::string& name, std::vector<Vector3> points,
  std::vector<PointTriangle> triangles, std::vector<int> patches,
  std::vector<std::string> patchNames, std::string* note)
{
  if (patches.empty())
  {
    patches.assign(triangles.size(), 0);
  }
  CheckPatches(patches, triangles.size(), patchNames.size());
  BodySurface body{ name, {}, {}, std::move(patchNames) };
  body.Boundary = CloseSurface(std::move(points), std::move(triangles));
  body.Patches = std::move(patches);
  if (note)
  {
    note->clear();
  }
  return body;
}

} // namespace vfm
