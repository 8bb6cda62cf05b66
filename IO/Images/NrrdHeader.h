/**
 * NrrdHeader: what VTK's reader of NRRD leaves out of its image.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <optional>
#include <string>

namespace vfm
{

struct NrrdHeader
{
  Index3 Size{};
  /// From value to value along each axis.
  std::array<Vector3, 3> Steps{ { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } },
    { { 0.0, 0.0, 1.0 } } } };
  Vector3 Origin{ { 0.0, 0.0, 0.0 } };
  bool IsRaw = false; ///< else gzip
  Index Length = 0;   ///< of the header, in bytes
  /// The file that holds them, or a list or pattern of files; empty: they follow the header.
  std::string Values;
};

/// Throws InputError, without the path, when it is no header of a three-dimensional image, and on encodings other than raw and gzip.
NrrdHeader ReadNrrdHeader(const std::string& path);

} // namespace vfm
