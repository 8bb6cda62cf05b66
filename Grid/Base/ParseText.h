/**
 * ParseText: numbers, switches and choices from text, independent of the locale, and functions on
 * texts. The parsers use the whole text and return nothing if it does not hold an allowed value.
 */
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Returns a letter of ASCII in lower case, and any other character as it is.
constexpr char ToLower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string ToLower(std::string text);

/// Returns whether two texts are equal except for case and spaces, such as "Quadric
/// Surface" and "quadricsurface".
bool IsSameWord(const std::string& one, const std::string& other);

/// Returns the number or integer if it is in the range [least, most]; never NaN.
std::optional<double> ParseNumber(const std::string& text, double least, double most);
std::optional<int> ParseCount(const std::string& text, int least, int most);

/// Returns the finite number, which may have a plus sign. Numbers that are too small are 0 or
/// denormal.
std::optional<double> ParseReal(const std::string& text);

/// Returns true for on, true, yes and 1, and false for off, false, no and 0.
std::optional<bool> ParseSwitch(const std::string& text);

/// Returns the position of the text among the words. The text may also be the
/// position itself, from 0.
std::optional<int> ParseChoice(const std::string& text, const std::vector<std::string>& words);

/// Returns the shortest text from which ParseNumber reads the same number: 0.5, 1e-6.
std::string FormatNumber(double number);
std::string FormatNumber(float number);

/// Returns a name in snake case: iso_value for IsoValue.
std::string SnakeCase(const std::string& name);

/// Returns the text without spaces, tabs and line ends at its begin and end.
std::string TrimText(const std::string& text);

/// Returns the texts with the separator between them.
std::string JoinTexts(const std::vector<std::string>& texts, const std::string& separator = ", ");
/// Returns the parts between commas, trimmed, including empty parts. A part in double quotes may
/// contain commas.
std::vector<std::string> SplitText(const std::string& text);
/// Returns a name such that SplitText of names with commas between them returns the names.
std::string QuoteName(const std::string& name);

} // namespace vfm
