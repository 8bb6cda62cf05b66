/**
 * VtkStorage: how an XML file of VTK stores its arrays.
 */
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace vfm
{

/// Unpacks a block by a compressor of VTK. Returns whether the block is intact and has the size of
/// the result.
using UnpackVtkBlock = std::function<bool(const std::string& compressor,
  const std::vector<unsigned char>& packed, std::vector<unsigned char>& unpacked)>;

/// How a file stores its arrays.
struct VtkStorage
{
  std::string Path;          ///< empty if Bytes are given
  std::string Encoding;      ///< of appended data: "raw" or "base64"
  std::int64_t Begin = 0;    ///< place of the appended data, bytes
  std::int64_t FileSize = 0; ///< bytes
  bool IsBigEndian = false;
  int HeaderSize = 4;        ///< bytes of each number in front of the values: 4 or 8
  std::string Compressor;    ///< empty without compression
  double LargestRatio = 0.0; ///< largest ratio of compression
  UnpackVtkBlock Unpack;
  std::string Bytes{}; ///< the file itself, if it is in memory

  /// Returns the file as a stream at its begin.
  std::unique_ptr<std::istream> Open() const
  {
    if (this->Path.empty())
    {
      return std::make_unique<std::istringstream>(this->Bytes);
    }
    return std::make_unique<std::ifstream>(this->Path, std::ios::binary);
  }
};

} // namespace vfm
