/**
 * LegacyStream: walks through the items of a file in VTK's legacy format, text or binary.
 */
#pragma once

#include "GridFiles/VtkNumbers.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace vfm
{

constexpr std::int64_t MostLegacyValues = std::int64_t(1) << 40; // values of an array

/// Rejects the file.
/// @throws InputError  always; the message does not contain the path
[[noreturn]] void RejectLegacyFile(const std::string& problem);

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
  /// Reads three finite numbers.
  void Numbers(const std::string& what);
  /// Reads the values of an array; binary values begin in the next line.
  /// @param visit  receives each value, if not empty
  void ReadValues(const std::string& type, std::int64_t count, const std::string& name,
    const VisitVtkValue& visit = nullptr);
  /// Skips the description of an array that may follow its values.
  void SkipMetadata();
  /// Skips lines up to an empty one.
  void SkipDescription();

  /// Returns the array that was read last, as "after its array 'a'"; empty if there is none.
  std::string AfterArray() const { return this->Last.empty() ? "" : " after its " + this->Last; }

private:
  void ReadWords(
    const VtkType& type, std::int64_t count, const std::string& name, const VisitVtkValue& visit);
  void ReadBytes(
    const VtkType& type, std::int64_t count, const std::string& name, const VisitVtkValue& visit);
  void SkipStrings(std::int64_t count, const std::string& name);

  std::ifstream Stream;
  std::int64_t Size;
  std::string Last; // name of an array
};

} // namespace vfm
