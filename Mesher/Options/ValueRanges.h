/**
 * ValueRanges: ranges of the values of an array, the option Threshold.
 */
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// The values above Low, up to and including High.
struct ValueRange
{
  double Low, High;

  bool Holds(double value) const { return value > this->Low && value <= this->High; }
};

/// Parses ranges: "LOW:HIGH", "LOW" or "LOW:" without upper limit, ":HIGH" without lower limit,
/// with commas or semicolons between them.
/// @return nothing if the text has another form, or if a range is empty or overlaps another;
/// no ranges if the text is empty
std::optional<std::vector<ValueRange>> ParseRanges(const std::string& text);

} // namespace vfm
