/**
 * StoredBytes: reads the bytes of an array of VTK's XML files, raw or as text in base64.
 */
#pragma once

#include "GridFiles/VtkStorage.h"

#include <cstdint>
#include <istream>
#include <memory>

namespace vfm
{

/// Bytes of a file from a place on. Only a buffer is in memory.
class StoredBytes
{
public:
  /// @param place  place of the first byte, or of white space before the text
  StoredBytes(const VtkStorage& storage, std::int64_t place, bool isBase64);

  /// Reads bytes. Returns their number, which is smaller at the end of the file or of the text.
  /// @throws InputError  if the text is not base64; the message names the letter and its place
  std::size_t Read(unsigned char* to, std::size_t count);
  /// Begins another text in base64, because each ends with a whole group of four letters.
  void BeginText() { this->Held = this->Used = 0; }
  /// Skips raw bytes, or decodes them. Returns whether they are there.
  bool Skip(std::int64_t count);
  /// Returns the most bytes that can follow.
  std::int64_t CountLeft();
  /// Checks that an element ends here.
  /// @throws InputError  if other text follows
  void CheckEnd();

private:
  int Letter();
  void ReadGroup();

  std::unique_ptr<std::istream> Stream;
  std::int64_t Size, Letters = 0;
  bool IsBase64;
  unsigned char Group[3] = {};
  int Held = 0, Used = 0; // bytes of the group
};

} // namespace vfm
