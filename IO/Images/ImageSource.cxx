#include "Images/ImageSource.h"

#include "Images/DistributeImage.h"
#include "ReadVoxels.h"

#include <algorithm>
#include <cmath>

namespace vfm
{

ImageSource OpenImage(const std::string& path, const Vector3& spacing, const ImageRequest& request)
{
  const bool isSet = spacing != Vector3{ { 0.0, 0.0, 0.0 } };
  if (isSet && !std::all_of(spacing.begin(), spacing.end(), [](double s) { return s > 0.0; }))
  {
    throw InputError(
      "Spacing must be above 0 along all axes, or 0 along all to use that of the file.");
  }
  ImageFile file = OpenImageFile(path, request);
  file.Place.Spacing = isSet ? spacing : file.Place.Spacing;
  if (!isSet && !file.SpacingWarning.empty())
  {
    file.Warning += (file.Warning.empty() ? "" : " ") + file.SpacingWarning;
  }
  return { file.Place, file.IsOfCells, file.Names, file.Warning, file.Volumes,
    [file, array = request.Array](const IndexBox& box, Ranks& ranks)
    {
      std::vector<TypedValues> arrays;
      arrays.push_back(ReadPart(file, box, ranks));
      const char* name = IsRealType(arrays[0].Type) ? "Values" : "Labels";
      arrays[0].Name = file.IsOfCells ? array : name;
      return arrays;
    } };
}

ImageSource OpenVoxels(const std::string& path, const Index3& cells, const Vector3& origin,
  const Vector3& spacing, AxisOrder order, bool areAnyNumbers)
{
  for (int a = 0; a < 3; ++a)
  {
    if (!(spacing[a] > 0.0) || !std::isfinite(spacing[a] + origin[a]))
    {
      throw InputError("Spacing must be above 0, and Origin finite.");
    }
  }
  VoxelFile file = InspectVoxels(path, cells, order);
  file.AreAnyNumbers = areAnyNumbers;
  const bool isSized = *std::min_element(file.Cells.begin(), file.Cells.end()) > 0;
  ImagePlace place;
  place.Size = isSized ? file.Cells : Index3{};
  place.Origin = origin;
  place.Spacing = spacing;
  return { place, true, {}, "", 1,
    [file](const IndexBox& box, Ranks&) { return ReadVoxels(file, box); } };
}

} // namespace vfm
