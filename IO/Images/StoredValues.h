/**
 * StoredValues: reads the values of an image from files, raw or compressed by zlib or gzip.
 */
#pragma once

#include "Base/IndexBox.h"
#include "CellCount.h"
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
  bool AreDetached = false; ///< the files are not the header; messages name them

  /// Returns the size of all values of an image, bytes.
  Index CountBytes(const Index3& size) const { return CountCells(size) * WidthOfType(this->Type); }
  /// Returns the size of `volume` images of the same size, bytes. Throws InputError if it is too
  /// large.
  Index CountBytes(const Index3& size, Index volume) const
  {
    return this->CountBytes({ { size[0], size[1], size[2] * volume } });
  }
};

/// Sets the files that a header names, relative to its folder.
/// @param header  path of the header, which holds the values if `names` is empty
/// @param length  length of the header, bytes; 0 if it has no end
/// @throws InputError  if a file is outside of the folder of the header (FindNamedFile), or if the
///   header has neither files nor an end
void SetFiles(const std::string& header, Index length, const std::vector<std::string>& names,
  StoredValues& stored);

/// Sets the place of values that are at the end of their only file.
/// @throws InputError  if there are several files, or if the file is too short
void PlaceAtEnd(const Index3& size, StoredValues& stored);

/// Returns the names of numbered files.
/// @param pattern  name with one integer format of printf, for instance "slice%03d.raw"
/// @param first,last,step  numbers of the files: first, first + step, ... up to last
/// @param most  largest number of files
/// @throws InputError  if the pattern is different, or if there are no files or too many
std::vector<std::string> ListNumberedFiles(
  const std::string& pattern, Index first, Index last, Index step, Index most);

/// Checks the files of an image.
/// @throws InputError  if files are missing, not regular or too short, or if the number of slices
///   is not a multiple of the number of files
void CheckFiles(const StoredValues& stored, const Index3& size);

/// Reads the values in a box of an image.
/// @param size  number of values of the image along each axis
/// @return values in the box, x fastest, in the byte order of this machine, without a name
/// @throws InputError  if a file is truncated or damaged
TypedValues ReadStored(const StoredValues& stored, const Index3& size, const IndexBox& box);

} // namespace vfm
