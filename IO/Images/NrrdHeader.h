/**
 * NrrdHeader: reads the header of an NRRD file, which is a text.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <string>
#include <vector>

namespace vfm
{

/// Size, place and storage of the values of an NRRD file.
struct NrrdHeader
{
  Index3 Size{}; ///< number of values along each axis
  /// Vector from one value to the next along each axis.
  std::array<Vector3, 3> Steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  int Type = 0;           ///< one of ValueType
  bool IsRaw = false;     ///< true: raw, false: gzip
  bool IsSwapped = false; ///< values are not in the byte order of this machine
  Index Skip = 0;         ///< bytes of the data before the first value
  Index Length = 0;       ///< length of the header, bytes
  /// Files with the values, relative to the folder of the header; empty: values follow the header.
  std::vector<std::string> Files;
};

/// Reads the header of an NRRD file.
/// @throws InputError  if it is not the header of a three-dimensional image, or if the encoding is
///   neither raw nor gzip; the message does not contain the path
NrrdHeader ReadNrrdHeader(const std::string& path);

} // namespace vfm
