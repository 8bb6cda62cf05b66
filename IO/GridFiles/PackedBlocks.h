/**
 * PackedBlocks: unpacks the compressed values of an array of VTK's XML files.
 */
#pragma once

#include "GridFiles/StoredBytes.h"
#include "GridFiles/VtkStorage.h"

namespace vfm
{

/// Receives bytes of values in their order.
using TakeBytes = std::function<void(const unsigned char* bytes, std::size_t count)>;

/// Reads a number of the header of an array.
/// @throws InputError  if it is missing or too large
std::int64_t ReadVtkLength(StoredBytes& stored, const VtkStorage& storage);

/// Compressed blocks of an array. Their sizes are in front of them.
class PackedBlocks
{
public:
  /// Reads the sizes.
  /// @throws InputError  if they contradict each other, the file, or the largest ratio
  PackedBlocks(StoredBytes& stored, const VtkStorage& storage);

  /// Returns the size of the values, bytes.
  std::int64_t CountBytes() const { return this->Unpacked; }
  /// Unpacks the blocks, one after another.
  /// @throws InputError  if a block is damaged or cut off
  void Unpack(const TakeBytes& take);

private:
  void ReadSizes();

  StoredBytes& Stored;
  const VtkStorage& Storage;
  std::vector<std::int64_t> Sizes; // compressed
  std::int64_t Size = 0, Last = 0, Unpacked = 0;
};

} // namespace vfm
