/**
 * ImageSource: an image or voxels in a file, of which every rank reads a part.
 */
#pragma once

#include "Images/ImagePlace.h"
#include "Ranks/Ranks.h"
#include "TypedValues.h"
#include "VoxelFile.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

struct ImageSource
{
  ImagePlace Place; ///< Size is 0 where a text does not state it; Read throws then
  bool IsOfCells =
    false; ///< values are those of cells, and the origin is the corner of the first; else of points
  /// Collective: the arrays in each rank's box, x fastest; the box may be empty. Throws InputError without the path, maybe on some ranks
  /// only.
  std::function<std::vector<TypedValues>(const IndexBox& box, Ranks& ranks)> Read;
};

/// An image of OpenImageFile: the array of that name, else 'Labels' or 'Values' of points. spacing: 0 along all axes for that of the file.
/// Throws InputError without the path.
ImageSource OpenImage(
  const std::string& path, const Vector3& spacing, const std::string& array = "FeatureIds");

/// A file of InspectVoxels. Throws InputError without the path.
ImageSource OpenVoxels(const std::string& path, const Index3& cells, const Vector3& origin,
  const Vector3& spacing, AxisOrder order);

} // namespace vfm
