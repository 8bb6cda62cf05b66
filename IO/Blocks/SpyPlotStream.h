/**
 * SpyPlotStream: reads numbers, texts and run-length coded values of a SpyPlot file.
 *
 * Numbers are big endian, file positions are doubles, values have 4 bytes. Run-length code: a byte
 * n < 128 is followed by one value, which is repeated n times; a byte 128 + n by n values.
 */
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace vfm
{

/// Stream of the items of a SpyPlot file. It never reads past the end of the file.
/// @throws InputError  if the file ends early or an item is invalid; contains path, Place, position
class SpyPlotStream
{
public:
  explicit SpyPlotStream(const std::string& path);

  [[noreturn]] void Fail(const std::string& problem) const;
  std::int64_t GetPosition() const { return this->Position; }
  void Seek(std::int64_t position);
  void Skip(std::int64_t count);
  int Int() { return static_cast<std::int32_t>(this->Number(4)); }
  double Double();
  /// Reads a position in the file.
  std::int64_t Offset();
  /// Reads `size` bytes and returns the text before the first 0 in them.
  std::string Text(int size);
  /// Reads a chunk, which begins with its length in bytes and must hold `count` values.
  std::vector<float> Values(std::int64_t count);
  /// Reads a chunk of node coordinates: a float that is not used, the spacing, and run-length coded
  /// offsets. Node i is its offset plus i times the spacing.
  std::vector<float> Nodes(std::int64_t count);
  /// Skips a chunk without decoding its values.
  void SkipChunk() { this->Skip(this->Int()); }

  std::string Place = "the header"; ///< place in the file, for messages

private:
  std::vector<unsigned char> Bytes(std::int64_t count);
  void Reserve(std::int64_t count) const;
  std::uint64_t Number(int size);
  std::vector<float> Decode(
    const std::vector<unsigned char>& code, std::size_t first, std::int64_t count) const;

  std::string Path;
  std::ifstream Stream;
  std::int64_t Size = 0, Position = 0;
};

} // namespace vfm
