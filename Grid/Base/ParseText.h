/**
 * ParseText: values from the words of a file, a command line or a host, whole and in any locale, or nothing.
 */
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Equal but for case and spaces: "Quadric Surface" is "quadricsurface".
bool IsSameWord(const std::string& one, const std::string& other);

/// From least to most, both included; never infinite or NaN.
std::optional<double> ParseNumber(const std::string& text, double least, double most);
std::optional<int> ParseCount(const std::string& text, int least, int most);

/// on, true, yes, 1; off, false, no, 0.
std::optional<bool> ParseSwitch(const std::string& text);

/// The place of the text among the words, or the number it is, from 0.
std::optional<int> ParseChoice(const std::string& text, const std::vector<std::string>& words);

/// The shortest text that ParseNumber makes the same number of: 0.5, 1e-6.
std::string FormatNumber(double number);

/// IsoValue: iso_value.
std::string SnakeCase(const std::string& name);

/// Without the spaces, tabs and ends of lines around it.
std::string TrimText(const std::string& text);

/// With the separator between them.
std::string JoinTexts(const std::vector<std::string>& texts, const std::string& separator = ", ");
/// The parts between the commas, without the spaces around them; empty ones too.
std::vector<std::string> SplitText(const std::string& text);

} // namespace vfm
