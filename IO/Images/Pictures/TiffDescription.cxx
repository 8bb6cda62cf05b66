#include "Images/Pictures/TiffDescription.h"

#include "Base/ParseText.h"
#include "Images/XmlElements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace vfm
{
namespace
{

constexpr int MaximumCount = 1000000; // three of them do not exceed an Index

Index ParseSize(const std::string& text)
{
  return ParseCount(text, 1, MaximumCount).value_or(1);
}

/// Returns a length above 0; 0 for any other text. ImageJ may write a negative distance.
double ParseLength(const std::string& text)
{
  constexpr double largest = std::numeric_limits<double>::max();
  return std::abs(ParseNumber(text, -largest, largest).value_or(0.0));
}

/// Parses the lines "key=value" of ImageJ; channels change fastest, then slices.
TiffDescription ParseImageJ(const std::string& text)
{
  TiffDescription description;
  description.Program = "ImageJ";
  Index images = 1;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find('=');
    const std::string key = TrimText(line.substr(0, equals));
    const std::string value =
      equals == std::string::npos ? std::string() : TrimText(line.substr(equals + 1));
    images = key == "images" ? ParseSize(value) : images;
    description.Slices = key == "slices" ? ParseSize(value) : description.Slices;
    description.Channels = key == "channels" ? ParseSize(value) : description.Channels;
    description.Times = key == "frames" ? ParseSize(value) : description.Times;
    description.Distance = key == "spacing" ? ParseLength(value) : description.Distance;
    description.Unit = key == "unit" ? value : description.Unit;
  }
  if (description.CountImages() != images)
  {
    description.Slices = images;
    description.Channels = description.Times = 1;
  }
  description.SliceStep = description.Channels;
  description.TimeStep = description.Channels * description.Slices;
  return description;
}

/// Returns the length of a unit of OME in micrometres; nothing for other units.
std::optional<double> FindUnit(const std::string& name)
{
  const std::pair<const char*, double> units[] = { { "", 1.0 }, { "um", 1.0 }, { "\u00b5m", 1.0 },
    { "\u03bcm", 1.0 }, { "nm", 1e-3 }, { "pm", 1e-6 }, { "\u00c5", 1e-4 }, { "mm", 1e3 },
    { "cm", 1e4 }, { "dm", 1e5 }, { "m", 1e6 }, { "in", 25400.0 } };
  const auto* found = std::find_if(
    std::begin(units), std::end(units), [&name](const auto& unit) { return name == unit.first; });
  return found == std::end(units) ? std::nullopt : std::make_optional(found->second);
}

/// Returns a length in the unit of the width of pixels along x.
double ConvertLength(double length, const std::string& unit, const std::string& unitOfX)
{
  const std::optional<double> from = FindUnit(unit), to = FindUnit(unitOfX);
  return unit == unitOfX || (from && to && *from == *to) ? length
    : from && to                                         ? length * (*from / *to)
                                                         : 0.0;
}

/// Sets the steps between slices, channels and times.
/// @param order  axes, the fastest first, for instance "XYZCT"
void SetSteps(const std::string& order, TiffDescription& description)
{
  Index step = 1;
  for (char axis : order)
  {
    Index& count = axis == 'Z' ? description.Slices
      : axis == 'C'            ? description.Channels
                               : description.Times;
    Index& stepOfAxis = axis == 'Z' ? description.SliceStep
      : axis == 'C'                 ? description.ChannelStep
                                    : description.TimeStep;
    if (axis == 'Z' || axis == 'C' || axis == 'T')
    {
      stepOfAxis = step;
      step *= count;
    }
  }
}

TiffDescription ParseOme(const std::vector<XmlElement>& elements, int samples)
{
  TiffDescription description;
  const auto pixels = std::find_if(elements.begin(), elements.end(),
    [](const XmlElement& element) { return element.Name == "Pixels"; });
  if (pixels == elements.end())
  {
    return description;
  }
  const auto find = [&](const std::string& name)
  {
    const auto found = pixels->Attributes.find(name);
    return found == pixels->Attributes.end() ? std::string() : TrimText(found->second);
  };
  description.Program = "OME";
  description.Slices = ParseSize(find("SizeZ"));
  description.Channels = std::max<Index>(ParseSize(find("SizeC")) / std::max(samples, 1), 1);
  description.Times = ParseSize(find("SizeT"));
  SetSteps(find("DimensionOrder"), description);
  const std::string unit = find("PhysicalSizeXUnit");
  const auto length = [&](const std::string& axis)
  {
    const std::string name = "PhysicalSize" + axis;
    return ConvertLength(ParseLength(find(name)), find(name + "Unit"), unit);
  };
  description.Widths = { length("X"), length("Y") };
  description.Distance = length("Z");
  return description;
}

/// Makes the images of the only axis with several images slices.
void MakeSlices(TiffDescription& description)
{
  const Index count = description.CountImages();
  if (count == std::max({ description.Slices, description.Channels, description.Times }))
  {
    description.Slices = count;
    description.Channels = description.Times = description.SliceStep = 1;
  }
}

} // namespace

TiffDescription ParseTiffDescription(const std::string& text, int samples)
{
  TiffDescription description;
  if (text.compare(0, 7, "ImageJ=") == 0)
  {
    description = ParseImageJ(text);
  }
  else if (text.find("OME") != std::string::npos && TrimText(text).compare(0, 1, "<") == 0)
  {
    description =
      ParseOme(ListElements(TrimText(text)).value_or(std::vector<XmlElement>()), samples);
  }
  MakeSlices(description);
  return description;
}

} // namespace vfm
