/**
 * SpyPlotStream: numbers, texts and run-length coded values of a SpyPlot file.
 *
 * Numbers are big endian, file positions are doubles. Run-length code: a byte n < 128 and a value that
 * counts n times, or 128 + n and n values, of 4 bytes.
 */
#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace vfm
{

/// Never reads past the end of the file. Every error is an InputError that names Place and the position.
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
  /// Reads that many bytes, and returns those before the first 0.
  std::string Text(int size);
  /// Reads a chunk, its length first, that holds that many values.
  std::vector<float> Values(std::int64_t count);
  /// Reads a chunk of node coordinates: first node, step, and what to add to each node's steps.
  std::vector<float> Nodes(std::int64_t count);
  /// Skips a chunk without a look at its values.
  void SkipChunk() { this->Skip(this->Int()); }

  std::string Place = "the header"; ///< for messages

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
