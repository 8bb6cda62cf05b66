#include "Report/HistogramSvg.h"

#include "Report/HtmlText.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

// Lengths in units of the viewBox. At a width of 400 pixels, a unit is almost one pixel.
constexpr double Right = 380.0, Top = 10.0, Bottom = 170.0, Height = 208.0;
constexpr double Width = 400.0, Gap = 1.0, LeastBar = 2.0;
constexpr double LabelBelow = 15.0, LabelLeft = 5.0, LabelMiddle = 4.0, TitleBelow = 33.0;
constexpr double LeastLeft = 40.0, DigitWidth = 6.8; // room for the labels of the vertical axis
constexpr int MostTicks = 5;                         // on the vertical axis

/// Returns 1, 2 or 5 times a power of ten, so that at most MostTicks steps reach a number.
Index FindStep(Index most)
{
  for (Index power = 1;; power *= 10)
  {
    for (Index step : { power, 2 * power, 5 * power })
    {
      if (most <= MostTicks * step)
      {
        return step;
      }
    }
  }
}

std::string PrintText(
  double x, double y, const char* anchor, const std::string& text, const char* kind = "tick")
{
  return "<text class=\"" + std::string(kind) + "\" x=\"" + PrintNumber(x) + "\" y=\"" +
    PrintNumber(y) + "\" text-anchor=\"" + anchor + "\">" + HtmlText(text) + "</text>\n";
}

/// Positions of the bars of a histogram.
class Frame
{
public:
  explicit Frame(const Histogram& histogram) : Bars(static_cast<double>(histogram.Counts.size()))
  {
    const Index most = *std::max_element(histogram.Counts.begin(), histogram.Counts.end());
    this->Step = FindStep(most);
    this->Steps = std::max<Index>((most + this->Step - 1) / this->Step, 1);
    const auto digits = static_cast<double>(PrintCount(this->Step * this->Steps).size());
    this->Left = std::max(LeastLeft, LabelLeft + DigitWidth * digits);
  }

  double GetLeft() const { return this->Left; }
  /// Returns the left end of a bar.
  double X(std::size_t bar) const
  {
    return this->Left + (Right - this->Left) * static_cast<double>(bar) / this->Bars;
  }
  /// Returns the upper end of a bar.
  double Y(Index count) const
  {
    const double share = static_cast<double>(count) / static_cast<double>(this->Step * this->Steps);
    return Bottom - (Bottom - Top) * share;
  }
  Index GetStep() const { return this->Step; }
  Index CountSteps() const { return this->Steps; }

private:
  double Bars, Left;
  Index Step, Steps; ///< count between labels of the vertical axis, and number of them
};

std::string DrawAxes(const Histogram& histogram, const HistogramTexts& texts, const Frame& frame)
{
  std::string drawn;
  for (Index step = 0; step <= frame.CountSteps(); ++step)
  {
    const Index count = step * frame.GetStep();
    const std::string y = PrintNumber(frame.Y(count));
    drawn += "<path class=\"grid\" d=\"M" + PrintNumber(frame.GetLeft()) + " " + y + "H" +
      PrintNumber(Right) + "\"/>\n" +
      PrintText(
        frame.GetLeft() - LabelLeft, frame.Y(count) + LabelMiddle, "end", PrintCount(count));
  }
  const std::size_t bars = histogram.Counts.size();
  const std::size_t every = bars % 4 == 0 ? bars / 4 : bars / 6; // five or seven labels
  for (std::size_t bar = 0; bar <= bars; bar += std::max<std::size_t>(every, 1))
  {
    const double value = histogram.Lower +
      (histogram.Upper - histogram.Lower) * static_cast<double>(bar) / static_cast<double>(bars);
    drawn +=
      PrintText(frame.X(bar), Bottom + LabelBelow, "middle", PrintNumber(value) + texts.Unit);
  }
  return drawn +
    PrintText(
      (frame.GetLeft() + Right) / 2.0, Bottom + TitleBelow, "middle", texts.Values, "title");
}

std::string DrawBar(
  const Histogram& histogram, const HistogramTexts& texts, const Frame& frame, std::size_t bar)
{
  const Index count = histogram.Counts[bar];
  const double x = frame.X(bar) + Gap / 2.0, width = frame.X(bar + 1) - frame.X(bar) - Gap;
  const double height = std::max(Bottom - frame.Y(count), LeastBar);
  return "<rect x=\"" + PrintNumber(x) + "\" y=\"" + PrintNumber(Bottom - height) + "\" width=\"" +
    PrintNumber(width) + "\" height=\"" + PrintNumber(height) + "\"><title>" +
    HtmlText(
      PrintInterval(histogram, bar, texts.Unit) + ": " + PrintCount(count) + " " + texts.Counts) +
    "</title></rect>\n";
}

} // namespace

std::string PrintInterval(const Histogram& histogram, std::size_t interval, const std::string& unit)
{
  const auto end = [&](std::size_t at)
  {
    const double share = static_cast<double>(at) / static_cast<double>(histogram.Counts.size());
    return PrintNumber(histogram.Lower + (histogram.Upper - histogram.Lower) * share) + unit;
  };
  return end(interval) + " to " + end(interval + 1);
}

std::string DrawHistogram(const Histogram& histogram, const HistogramTexts& texts)
{
  const Frame frame(histogram);
  std::string drawn = "<svg viewBox=\"0 0 " + PrintNumber(Width) + " " + PrintNumber(Height) +
    "\" role=\"img\" aria-label=\"" +
    HtmlText("Histogram: " + texts.Counts + " by " + texts.Values) + "\">\n" +
    DrawAxes(histogram, texts, frame);
  for (std::size_t bar = 0; bar < histogram.Counts.size(); ++bar)
  {
    drawn += histogram.Counts[bar] > 0 ? DrawBar(histogram, texts, frame, bar) : "";
  }
  return drawn + "</svg>\n";
}

} // namespace vfm
