/**
 * Utf8: texts of files in UTF-8, and conversion of texts that are not.
 */
#pragma once

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

} // namespace vfm
