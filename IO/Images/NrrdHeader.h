/**
 * NrrdHeader: the header of a NRRD file, a text.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <string>
#include <vector>

namespace vfm
{

struct NrrdHeader
{
  Index3 Size{};
  /// From value to value along each axis.
  std::array<Vector3, 3> Steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  int Type = 0;       ///< of ValueType
  bool IsRaw = false; ///< else gzip
  bool IsSwapped = false;
  Index Skip = 0;                 ///< bytes of the data before the first value
  Index Length = 0;               ///< of the header, in bytes
  std::vector<std::string> Files; ///< with the values, relative to the header; none: they follow it
};

/// Throws InputError, without the path, when it is no header of a three-dimensional image, and on encodings other than raw and gzip.
NrrdHeader ReadNrrdHeader(const std::string& path);

} // namespace vfm
