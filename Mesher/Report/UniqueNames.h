/**
 * UniqueNames: names of groups in files: in UTF-8, printable, and each once by an ending _2, _3.
 */
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace vfm
{

/// Character in place of bytes without a meaning, U+FFFD.
constexpr const char* UnknownCharacter = "\xef\xbf\xbd";

/// Returns whether a text is valid UTF-8 (RFC 3629).
bool IsUtf8(std::string_view text);

/// Returns a text in UTF-8. A text that is not valid is converted from Windows-1252, which contains
/// Latin-1; its five bytes without a character become UnknownCharacter.
std::string ToUtf8(const std::string& text);

/// Returns a name in UTF-8 (ToUtf8) in which control characters are replaced by _.
std::string PrintableName(const std::string& name);
/// Returns a PrintableName in which also quotes and backslashes are replaced by _.
std::string PlainName(const std::string& name);

/// List of names that were given.
class UniqueNames
{
public:
  /// @param longest  bytes of a name, 10 or more
  explicit UniqueNames(std::size_t longest = 1000) : Longest(longest) {}

  /// Returns a name that was not returned before: the given one, cut to the longest length between
  /// characters of UTF-8. If it was returned, an ending _2, _3 and so on is added.
  std::string Add(const std::string& name);

private:
  std::size_t Longest;
  std::set<std::string> Used;
};

} // namespace vfm
