#include "Options/ValueRanges.h"

#include "Base/ParseText.h"

#include <algorithm>
#include <limits>

namespace vfm
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Parses a limit; an empty text is no limit.
std::optional<double> ParseLimit(const std::string& text, double none)
{
  constexpr double largest = std::numeric_limits<double>::max();
  return text.empty() ? none : ParseNumber(text, -largest, largest);
}

std::optional<ValueRange> ParseRange(const std::string& text)
{
  const std::size_t colon = text.find(':');
  const bool hasHigh = colon != std::string::npos;
  const auto low = ParseLimit(TrimText(text.substr(0, colon)), -Infinity);
  const auto high = ParseLimit(hasHigh ? TrimText(text.substr(colon + 1)) : "", Infinity);
  const bool isLimited = low && high && (*low > -Infinity || *high < Infinity);
  return isLimited && *low < *high ? std::optional<ValueRange>({ *low, *high }) : std::nullopt;
}

} // namespace

std::optional<std::vector<ValueRange>> ParseRanges(const std::string& text)
{
  std::string list = text;
  std::replace(list.begin(), list.end(), ';', ',');
  std::vector<ValueRange> ranges;
  for (const std::string& part : text.empty() ? std::vector<std::string>() : SplitText(list))
  {
    const std::optional<ValueRange> range = ParseRange(part);
    const bool isNew = range &&
      std::none_of(ranges.begin(), ranges.end(),
        [&range](const ValueRange& other)
        { return range->Low < other.High && other.Low < range->High; });
    if (!isNew)
    {
      return std::nullopt;
    }
    ranges.push_back(*range);
  }
  return ranges;
}

} // namespace vfm
