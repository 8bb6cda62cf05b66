/**
 * StoredValues: how the values of an image lie in files, raw or compressed by zlib or gzip.
 */
#pragma once

#include "Base/IndexBox.h"
#include "TypedValues.h"

#include <string>
#include <vector>

namespace vfm
{

struct StoredValues
{
  std::vector<std::string> Files; ///< each holds as many slices
  int Type = ValueType::UnsignedChar;
  Index Begin = 0; ///< of the data in each file, in bytes
  Index Skip = 0;  ///< bytes of the data, after decompression, before the first value
  bool AreCompressed = false, AreSwapped = false;

  /// Bytes of all values.
  double CountBytes(const Index3& size) const
  {
    return double(size[0]) * double(size[1]) * double(size[2]) * double(WidthOfType(this->Type));
  }
};

/// Returns the names of files that a pattern of printf such as "slice%03d.raw" makes of first, first + step .. last. Throws
/// InputError on other patterns and on more than most names.
std::vector<std::string> ListNumberedFiles(
  const std::string& pattern, double first, double last, double step, Index most);

/// Throws InputError when files are missing, do not share the slices, or are too short.
void CheckFiles(const StoredValues& stored, const Index3& size);

/// Returns the values in a box of an image. Throws InputError on files that are cut or damaged.
TypedValues ReadStored(const StoredValues& stored, const Index3& size, const IndexBox& box);

} // namespace vfm
