/**
 * StoredValues: reads the values of an image from files, raw or compressed by zlib or gzip.
 */
#pragma once

#include "Base/IndexBox.h"
#include "TypedValues.h"

#include <string>
#include <vector>

namespace vfm
{

/// Storage of the values of an image, x fastest.
struct StoredValues
{
  std::vector<std::string> Files; ///< files in the order of their slices, equally many in each
  int Type = ValueType::UnsignedChar;
  Index Begin = 0; ///< place of the data in each file, bytes
  Index Skip = 0;  ///< bytes of the data, after decompression, before the first value
  bool AreCompressed = false, AreSwapped = false;

  /// Returns the size of all values of an image, bytes.
  double CountBytes(const Index3& size) const
  {
    return double(size[0]) * double(size[1]) * double(size[2]) * double(WidthOfType(this->Type));
  }
};

/// Returns the names of numbered files.
/// @param pattern  name with one integer format of printf, for instance "slice%03d.raw"
/// @param first,last,step  numbers of the files: first, first + step, ... up to last
/// @param most  largest number of files
/// @throws InputError  if the pattern is different, or if there are no files or too many
std::vector<std::string> ListNumberedFiles(
  const std::string& pattern, double first, double last, double step, Index most);

/// Checks the files of an image.
/// @throws InputError  if files are missing or too short, or if the number of slices is not a
///   multiple of the number of files
void CheckFiles(const StoredValues& stored, const Index3& size);

/// Reads the values in a box of an image.
/// @param size  number of values of the image along each axis
/// @return values in the box, x fastest, in the byte order of this machine, without a name
/// @throws InputError  if a file is truncated or damaged
TypedValues ReadStored(const StoredValues& stored, const Index3& size, const IndexBox& box);

} // namespace vfm
