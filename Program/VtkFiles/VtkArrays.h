/**
 * VtkArrays: checks that an array of an XML file of VTK is as long as its grid requires.
 */
#pragma once

#include "VtkFiles/XmlOutline.h"

#include <optional>
#include <string>

namespace vfm
{

/// How a file stores its arrays.
struct VtkStorage
{
  std::string Path;
  std::string Encoding;      ///< of appended data: "raw" or "base64"
  std::int64_t Begin = 0;    ///< place of the appended data, bytes
  std::int64_t FileSize = 0; ///< bytes
  bool IsBigEndian = false;
  int HeaderSize = 4;        ///< bytes of each number in front of the values: 4 or 8
  bool IsPacked = false;     ///< arrays are compressed
  double LargestRatio = 0.0; ///< largest ratio of compression
};

/// Checks the values of an array.
/// @param array  element DataArray
/// @param tuples  number of tuples that the grid requires; nothing if it does not say
/// @throws InputError  if the type, number of components or place is invalid, or if there are fewer
///   values than the grid requires; the message does not contain the path
void CheckVtkArray(
  const OutlineElement& array, std::optional<std::int64_t> tuples, const VtkStorage& storage);

} // namespace vfm
