/**
 * HistogramSvg: draws a histogram as an inline SVG element of an HTML page.
 */
#pragma once

#include "Report/QualityDistribution.h"

#include <string>

namespace vfm
{

/// Texts of a histogram.
struct HistogramTexts
{
  std::string Values; ///< what the horizontal axis shows, such as "scaled Jacobian"
  std::string Counts; ///< what is counted, such as "hexahedra"
  std::string Unit;   ///< unit of the values, printed after them, or empty
};

/// Draws one bar per interval. Each bar has its interval and its count as a tooltip. An interval
/// with values has a bar of visible height, so that a single bad element among millions is seen.
/// @param histogram at least one interval
/// @return the svg element
std::string DrawHistogram(const Histogram& histogram, const HistogramTexts& texts);

/// Returns the interval of a bar: "0.05 to 0.1".
std::string PrintInterval(
  const Histogram& histogram, std::size_t interval, const std::string& unit);

} // namespace vfm
