#include "Surfaces/SurfaceSides.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Returns the number of patches with a name and triangles.
Index CountNamed(const BodySurface& body)
{
  std::vector<bool> isNamed(body.PatchNames.size(), false);
  for (int patch : body.Patches)
  {
    isNamed[patch] = !body.PatchNames[patch].empty();
  }
  return std::count(isNamed.begin(), isNamed.end(), true);
}

} // namespace

SurfaceSides FindSides(const BodySurface& body, const SurfaceSheets& sheets)
{
  if (CountNamed(body) > 1)
  {
    return { body.Patches, body.PatchNames };
  }
  const auto last = std::max_element(sheets.SheetOf.begin(), sheets.SheetOf.end());
  const int count = last == sheets.SheetOf.end() ? 0 : *last + 1;
  return { sheets.SheetOf, std::vector<std::string>(count) };
}

} // namespace vfm
