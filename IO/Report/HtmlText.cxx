#include "Report/HtmlText.h"

#include "Meshes/Vtk/VtuText.h"
#include "Report/UniqueNames.h"

#include <charconv>

namespace vfm
{
namespace
{

template <class... Format>
std::string Print(double number, Format... format)
{
  char text[400]; // all digits of the greatest double
  return std::string(text, std::to_chars(text, text + sizeof(text), number, format...).ptr);
}

/// Returns a row. The first cell of each row, and all cells of the head, are headers.
std::string PrintRow(const HtmlTable& table, const std::vector<std::string>& cells, bool isHead)
{
  std::string row = "<tr>";
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const bool isHeader = isHead || c == 0;
    const std::string scope = isHead ? " scope=\"col\"" : " scope=\"row\"";
    row += (isHeader ? "<th" + scope : "<td") + (c < table.TextColumns ? " class=\"text\">" : ">") +
      cells[c] + (isHeader ? "</th>" : "</td>");
  }
  return row + "</tr>\n";
}

} // namespace

std::string HtmlText(const std::string& text)
{
  std::string safe;
  for (char c : XmlText(text))
  {
    safe += c == '\x7f' ? UnknownCharacter : std::string(1, c);
  }
  return safe;
}

std::string PrintCount(Index count)
{
  constexpr std::size_t group = 3;
  std::string digits = std::to_string(count);
  const std::size_t first = count < 0 ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + group;)
  {
    at -= group;
    digits.insert(at, ",");
  }
  return digits;
}

std::string PrintNumber(double number, int digits)
{
  return Print(number, std::chars_format::general, digits);
}

std::string PrintFixed(double number, int decimals)
{
  return Print(number, std::chars_format::fixed, decimals);
}

std::string PrintTable(const HtmlTable& table)
{
  std::string text = "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" +
    HtmlText(table.Name) + "\">\n<table>\n<thead>\n" + PrintRow(table, table.Heads, true) +
    "</thead>\n<tbody>\n";
  for (const std::vector<std::string>& row : table.Rows)
  {
    text += PrintRow(table, row, false);
  }
  text += "</tbody>\n";
  if (!table.Foot.empty())
  {
    text += "<tfoot>\n" + PrintRow(table, table.Foot, false) + "</tfoot>\n";
  }
  return text + "</table>\n</div>\n";
}

} // namespace vfm
