#include "Options/CellWidths.h"

#include "Base/ParseText.h"
#include "Fractions/CellOverlaps.h"

#include <cstdio>
#include <limits>

namespace vfm
{
namespace
{

/// Returns a number with four digits.
std::string FormatShort(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", number);
  return text;
}

/// Describes cells of equal widths; empty if a count is unknown.
std::string DescribeCounts(const Index3& counts, const Vector3& lengths)
{
  if (std::find(counts.begin(), counts.end(), 0) != counts.end())
  {
    return "";
  }
  std::vector<std::string> numbers, sizes;
  for (int a = 0; a < 3; ++a)
  {
    numbers.push_back(std::to_string(counts[a]));
    sizes.push_back(FormatShort(lengths[a] / static_cast<double>(counts[a])));
  }
  const bool isCube = sizes[0] == sizes[1] && sizes[0] == sizes[2];
  return JoinTexts(numbers, " x ") + " of " +
    (isCube ? "width " + sizes[0] : JoinTexts(sizes, " x "));
}

} // namespace

std::optional<Vector3> ParseWidths(const std::string& text)
{
  std::string list = TrimText(text);
  if (list.empty())
  {
    return Vector3{};
  }
  if (list.find(',') == std::string::npos)
  {
    std::replace(list.begin(), list.end(), ' ', ',');
  }
  std::vector<double> widths;
  for (const std::string& part : SplitText(list))
  {
    const auto width = ParseNumber(part, 0.0, std::numeric_limits<double>::max());
    if (!width)
    {
      return std::nullopt;
    }
    widths.push_back(*width);
  }
  if (widths.size() == 1)
  {
    widths.resize(3, widths[0]);
  }
  return widths.size() == 3 ? std::optional<Vector3>({ widths[0], widths[1], widths[2] })
                            : std::nullopt;
}

std::string DescribeCells(const std::string& widths, const Vector3& lengths, const Index3& cells)
{
  const std::optional<Vector3> parsed = ParseWidths(widths);
  if (!parsed)
  {
    return "not a width";
  }
  Index3 counts = cells;
  for (int a = 0; a < 3; ++a)
  {
    counts[a] = (*parsed)[a] > 0.0 ? CountEqualCells(lengths[a], (*parsed)[a]) : cells[a];
  }
  const auto exceeds = [&](int a) { return cells[a] > 0 && counts[a] > cells[a]; };
  if (exceeds(0) || exceeds(1) || exceeds(2))
  {
    return "narrower than " + DescribeCounts(cells, lengths);
  }
  return DescribeCounts(counts, lengths);
}

bool HasCellWidth(const MesherOptions& options)
{
  return ParseWidths(options.CellWidth).value_or(Vector3{}) != Vector3{};
}

} // namespace vfm
