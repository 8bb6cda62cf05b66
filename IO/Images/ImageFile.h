/**
 * ImageFile: opens a file of an image, with one value per point or cell: NIfTI, MGH, NRRD,
 * MetaImage, TIFF, PNG and DREAM.3D, or files of slices. Nothing here communicates.
 */
#pragma once

#include "Images/ImagePlace.h"
#include "Input/LabelNames.h"
#include "TypedValues.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Selection of the data to read from an image file.
struct ImageRequest
{
  /// Name of a cell array of a .dream3d file, or the end of its path.
  std::string Array = "FeatureIds";
  /// Number of an image, from 0, in a file that holds several.
  std::optional<int> Volume;
  bool TakesFirst = false; ///< of several images the first is read, if none is requested
  /// Files of one slice each, which are read in natural order instead of the path; mostly empty.
  std::vector<std::string> Slices;
};

/// Open image file: its place in space and a function that reads its values.
struct ImageFile
{
  ImagePlace Place;
  /// True: values belong to cells, and the origin is the corner of the first cell. False: values
  /// belong to points, and the origin is the first point.
  bool IsOfCells = false;
  /// False: Read accepts only the box of the whole image.
  bool ReadsParts = true;
  Index Volumes = 1;          ///< number of images in the file
  LabelNames Names;           ///< names of labels that the file contains
  std::string Warning;        ///< about the names or missing slices; empty: none
  std::string SpacingWarning; ///< about a spacing that the file does not contain; empty: none
  /// Returns the values in a box of the image, x fastest, without a name. Throws InputError; the
  /// message does not contain the path.
  std::function<TypedValues(const IndexBox& box)> Read;
};

/// Opens an image file, the slices in a folder, or the slices that match a pattern (AreSlices). The
/// suffix determines the format.
/// @throws InputError  if the suffix is unknown, if the file cannot be read, is damaged or is not
///   supported, or if it does not contain the requested image; the message does not contain the
///   path
ImageFile OpenImageFile(const std::string& path, const ImageRequest& request = {});

/// Returns the number of the image to read, from 0.
/// @param volumes  number of images in the file
/// @param kinds  description of the images, for the message
/// @throws InputError  if the requested image is missing, or if there are several and none is
///   requested
Index SelectVolume(const ImageRequest& request, Index volumes, const std::string& kinds = "");

/// Adds the name of a label that an image file contains. Names without visible text are ignored,
/// and spaces around them are removed. Control characters become spaces. A name that another label
/// has is followed by the label in parentheses, because names of materials must differ.
void AddLabelName(LabelNames& names, int label, const std::string& name);

/// Returns all supported suffixes, for instance ".nii".
const std::vector<std::string>& GetImageSuffixes();
/// Tests whether a path has a supported suffix, in lower or upper case, or names slices
/// (AreSlices).
bool IsImageFile(const std::string& path);

/// Opens a NIfTI-1 or NIfTI-2 file. Coordinates are in millimetres, x to the right, y to the front,
/// z up (RAS). They are taken from the sform; if it is missing or sheared, from the qform; without
/// both, from the spacing. If the axes are left-handed, the order of the slices is reversed.
/// @throws InputError  same conditions as OpenImageFile, also below
ImageFile OpenNifti(const std::string& path, const ImageRequest& request);
/// Opens an NRRD file, encoding raw or gzip. Coordinates are taken from space directions and space
/// origin, or from spacings, in the space that the file names (mostly LPS).
ImageFile OpenNrrd(const std::string& path, const ImageRequest& request);
/// Opens a MetaImage file, raw, zlib or text. Offset, ElementSpacing and TransformMatrix give the
/// coordinates, in the space of the file (mostly LPS).
ImageFile OpenMetaImage(const std::string& path, const ImageRequest& request);
/// Opens an MGH file of FreeSurfer. Coordinates are in millimetres, RAS.
ImageFile OpenMgh(const std::string& path, const ImageRequest& request);
/// Opens a TIFF file. Each page is a slice: x to the right, y from row to row, z from page to page.
/// The spacing is that of the description by ImageJ or OME, in its unit. Otherwise the resolution
/// gives the spacing in x and y, millimetres, and the spacing in z equals that in x.
ImageFile OpenTiff(const std::string& path, const ImageRequest& request);
/// Opens a PNG file, one layer: x to the right, y from row to row. The spacing is 1.
ImageFile OpenPng(const std::string& path, const ImageRequest& request);
/// Opens a cell array of an image geometry of DREAM.3D 6 or DREAM3D-NX.
ImageFile OpenDream3d(const std::string& path, const ImageRequest& request);

} // namespace vfm
