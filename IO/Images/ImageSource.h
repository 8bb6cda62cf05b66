/**
 * ImageSource: opens an image or voxel file of which each rank reads a part.
 */
#pragma once

#include "Images/ImageFile.h"
#include "Images/ImagePlace.h"
#include "Ranks/Ranks.h"
#include "TypedValues.h"
#include "VoxelFile.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Open file: its place in space and a function that reads its arrays.
struct ImageSource
{
  ImagePlace Place; ///< Size is 0 if a text does not contain it; Read then throws
  /// True: values belong to cells, and the origin is the corner of the first cell. False: values
  /// belong to points, and the origin is the first point.
  bool IsOfCells = false;
  LabelNames Names;    ///< names of labels that the file contains
  std::string Warning; ///< about the place or the values; empty: none
  Index Volumes = 1;   ///< number of images in the file
  /// Returns the arrays in the box of each rank, which may be empty; x fastest. Collective. Throws
  /// InputError, possibly only on some ranks; the message does not contain the path.
  std::function<std::vector<TypedValues>(const IndexBox& box, Ranks& ranks)> Read;
};

/// Opens an image, see OpenImageFile. Its array has the requested name if it belongs to
/// cells, otherwise 'Labels' (integers) or 'Values'.
/// @param spacing  replaces the spacing of the file; 0 along all axes: spacing of the file
/// @throws InputError  if the file cannot be read or is not supported; does not contain the path
ImageSource OpenImage(
  const std::string& path, const Vector3& spacing, const ImageRequest& request = {});

/// Opens a voxel file, see InspectVoxels.
/// @param cells  number of cells along x, y and z of a text, 0 if unknown
/// @param order  order of the axes in the file
/// @param areAnyNumbers  negative integers of a NumPy file are accepted
/// @throws InputError  if the file cannot be read or is not supported, or if origin or spacing are
///   invalid; the message does not contain the path
ImageSource OpenVoxels(const std::string& path, const Index3& cells, const Vector3& origin,
  const Vector3& spacing, AxisOrder order, bool areAnyNumbers = false);

} // namespace vfm
