/**
 * ImageFile: a file of one image, one value a point or a cell, in any of the formats that images of labels come in.
 */
#pragma once

#include "Images/ImagePlace.h"
#include "TypedValues.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

struct ImageFile
{
  ImagePlace Place;
  /// Values are those of cells, and the origin is the corner of the first; else of points.
  bool IsOfCells = false;
  /// False where the whole image must be read to have a part of it.
  bool ReadsParts = true;
  /// Returns the values in a box of the image, without a name. Throws InputError without the path.
  std::function<TypedValues(const IndexBox& box)> Read;
};

/// By the end of its name. array: of a .dream3d file, the name of a cell array, or the end of its path. Throws InputError
/// without the path, as all that follows. Nothing here communicates.
ImageFile OpenImageFile(const std::string& path, const std::string& array);

/// Such as ".nii".
const std::vector<std::string>& GetImageSuffixes();
bool IsImageFile(const std::string& path);

/// NIfTI-1 and -2: millimetres, x to the right, y to the front, z up (RAS). The sform tells the place, or where there is none or it
/// is sheared, the qform, or the spacing alone. The order of slices of left-handed ones is turned.
ImageFile OpenNifti(const std::string& path);
/// NRRD: space directions and space origin, or spacings, in the space that the file names (mostly LPS). Raw and gzip.
ImageFile OpenNrrd(const std::string& path);
/// MetaImage: Offset, ElementSpacing and TransformMatrix, the coordinates of the file (mostly LPS). Raw, zlib and text.
ImageFile OpenMetaImage(const std::string& path);
/// TIFF: a page is a slice, x to the right, y up, z from page to page. Resolution gives x and y in millimetres; z as x.
ImageFile OpenTiff(const std::string& path);
/// DREAM.3D 6 and DREAM3D-NX: the cell array of an image geometry.
ImageFile OpenDream3d(const std::string& path, const std::string& array);

} // namespace vfm
