/**
 * HtmlText: writes texts, numbers and tables as HTML.
 */
#pragma once

#include "Base/IndexBox.h"

#include <string>
#include <vector>

namespace vfm
{

/// Returns a text with the escapes that content and quoted attributes require. Control characters
/// become U+FFFD, because HTML forbids them.
std::string HtmlText(const std::string& text);

/// Returns a number with commas between thousands: 46,070.
std::string PrintCount(Index count);
/// Returns a number with significant digits, in any locale with a point.
std::string PrintNumber(double number, int digits = 6);
/// Returns a number with decimals, in any locale with a point.
std::string PrintFixed(double number, int decimals);

/// A table. All cells are HTML: apply HtmlText to texts.
struct HtmlTable
{
  std::string Name;               ///< text that describes the table to screen readers
  std::vector<std::string> Heads; ///< titles of the columns
  std::vector<std::vector<std::string>> Rows;
  std::vector<std::string> Foot; ///< last row, such as totals; empty: none
  std::size_t TextColumns = 1;   ///< the first columns hold text, the others hold numbers
};

/// Returns a table that scrolls sideways on narrow screens, where its first column stays.
std::string PrintTable(const HtmlTable& table);

} // namespace vfm
