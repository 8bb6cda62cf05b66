/**
 * NrrdHeader: reads the header of an NRRD file, which is a text.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Images/NrrdFields.h"

#include <array>
#include <string>
#include <vector>

namespace vfm
{

/// Size, place and storage of the values of an NRRD file.
struct NrrdHeader
{
  Index3 Size{};              ///< number of values along each axis in space
  Index Layers = 1;           ///< number of images
  bool HasLayersFirst = true; ///< the layers of a point follow one another; otherwise the images do
  /// Vector from one value to the next along each axis.
  std::array<Vector3, 3> Steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  int Type = 0;           ///< one of ValueType
  bool IsRaw = false;     ///< true: raw, false: gzip
  bool IsSwapped = false; ///< values are not in the byte order of this machine
  Index Skip = 0;         ///< bytes of the data before the first value; -1: values are at the end
  NrrdFields Fields;
  /// Files with the values, relative to the folder of the header; empty: values follow the header.
  std::vector<std::string> Files;

  /// Returns the size of the stored values. Layers extend the first or the last axis.
  Index3 StoredSize() const
  {
    Index3 size = this->Size;
    size[this->HasLayersFirst ? 0 : 2] *= this->Layers;
    return size;
  }
};

/// Reads the header of an NRRD file.
/// @throws InputError  if it is not the header of three-dimensional images, or if the encoding is
///   neither raw nor gzip; the message does not contain the path
NrrdHeader ReadNrrdHeader(const std::string& path);

} // namespace vfm
