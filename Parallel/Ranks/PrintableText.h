/**
 * PrintableText: text of files in a form that does not act on a terminal.
 */
#pragma once

#include <string>

namespace vfm
{

/// Returns a text in one line of valid UTF-8 without control characters. Line ends and tabs become
/// spaces. Other control characters, characters that change the direction of writing, and bytes
/// that are not UTF-8 become \xHH.
std::string MakePrintable(const std::string& text);

} // namespace vfm
