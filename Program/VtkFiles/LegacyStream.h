/**
 * LegacyStream: walks through the items of a file in VTK's legacy format, text or binary.
 */
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <string>

namespace vfm
{

constexpr std::int64_t MostLegacyValues = std::int64_t(1) << 40; // values of an array

/// Rejects the file.
/// @throws InputError  always; the message does not contain the path
[[noreturn]] void RejectLegacyFile(const std::string& problem);

/// Returns a word of a file in quotes, for messages.
std::string QuoteWord(std::string word);

/// Items of a legacy file, text or binary.
class LegacyStream
{
public:
  explicit LegacyStream(const std::string& path);

  bool IsBinary = false;

  /// Returns the next line without its end.
  std::string Line();
  /// Returns the next word; an empty text at the end of the file.
  std::string Word();
  /// Returns the next word in lower case.
  std::string Keyword();
  /// Returns the next word, an integer.
  std::int64_t Int(std::int64_t least, std::int64_t most, const std::string& what);
  /// Skips the values of an array; binary values begin in the next line.
  void SkipValues(const std::string& type, std::int64_t count, const std::string& name);
  /// Reads integers; calls visit(value) for each of them.
  void ReadInts(
    std::int64_t count, const std::string& name, const std::function<void(std::int64_t)>& visit);
  /// Skips the description of an array that may follow its values.
  void SkipMetadata();
  /// Skips lines up to an empty one.
  void SkipDescription();

private:
  void SkipBytes(std::int64_t count, const std::string& name);
  void SkipStrings(std::int64_t count, const std::string& name);

  std::ifstream Stream;
  std::int64_t Size;
};

} // namespace vfm
