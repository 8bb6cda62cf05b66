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

/// Drops names of patches without triangles, and renumbers the patches.
void DropUnused(std::vector<int>& patches, std::vector<std::string>& names)
{
  std::vector<int> numbers(names.size(), -1);
  for (int patch : patches)
  {
    numbers[patch] = 0;
  }
  int count = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] == 0)
    {
      numbers[p] = count;
      names[count++] = names[p];
    }
  }
  names.resize(count);
  for (int& patch : patches)
  {
    patch = numbers[patch];
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
  BodySurface body{ name, {}, std::move(patches), std::move(patchNames) };
  body.Boundary = CloseSurface(std::move(points), std::move(triangles), &body.Patches, note);
  DropUnused(body.Patches, body.PatchNames);
  return body;
}

} // namespace vfm
