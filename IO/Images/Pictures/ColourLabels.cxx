#include "Images/Pictures/ColourLabels.h"

#include "Ranks/Errors.h"

#include <algorithm>
#include <cstring>

namespace vfm
{
namespace
{

constexpr std::size_t MaximumColours = 255;
constexpr int SampleBits = 16;
// A grey colour has three equal samples: it is the sample times this number.
constexpr std::uint64_t OfGrey = (std::uint64_t(1) << 2 * SampleBits) + (1 << SampleBits) + 1;

} // namespace

/// Returns red, green and blue in one number; 0 if the pixel is transparent.
std::uint64_t ColourLabels::TakeColour(const char* pixel) const
{
  std::uint64_t samples[4] = { 0, 0, 0, 1 };
  for (int s = 0; s < this->Form.Samples; ++s)
  {
    std::uint16_t wide = 0;
    unsigned char narrow = 0;
    if (this->Form.Type == ValueType::UnsignedShort)
    {
      std::memcpy(&wide, pixel + 2 * s, 2);
    }
    else
    {
      std::memcpy(&narrow, pixel + s, 1);
    }
    samples[s] = std::uint64_t(wide) + narrow;
  }
  return samples[3] == 0 ? 0
                         : (samples[0] << 2 * SampleBits) + (samples[1] << SampleBits) + samples[2];
}

void ColourLabels::Add(const char* pixels, Index count)
{
  const Index width = this->Form.Width();
  std::uint64_t last = 0;
  for (Index i = 0; i < count; ++i)
  {
    const std::uint64_t colour = this->TakeColour(pixels + i * width);
    if (colour == last)
    {
      continue;
    }
    last = colour;
    this->Labels.emplace(colour, 0);
    if (this->Labels.size() > MaximumColours + 1)
    {
      throw InputError("it has more than " + std::to_string(MaximumColours) +
        " colours. A picture of labels has one colour per material. Save it without blended "
        "colours at the borders, or with one integer per pixel.");
    }
  }
}

bool ColourLabels::AreGrey() const
{
  return std::all_of(this->Labels.begin(), this->Labels.end(),
    [](const auto& entry)
    { return entry.first % OfGrey == 0 && entry.first / OfGrey <= MaximumColours; });
}

LabelNames ColourLabels::Number()
{
  LabelNames names;
  if (this->AreGrey())
  {
    for (auto& [colour, number] : this->Labels)
    {
      number = static_cast<unsigned char>(colour >> 2 * SampleBits);
    }
    return names;
  }
  int label = 0;
  for (auto& [colour, number] : this->Labels)
  {
    number = static_cast<unsigned char>(label);
    constexpr std::uint64_t mask = (1 << SampleBits) - 1;
    if (label > 0)
    {
      AddLabelName(names, label,
        "rgb " + std::to_string(colour >> 2 * SampleBits) + " " +
          std::to_string(colour >> SampleBits & mask) + " " + std::to_string(colour & mask));
    }
    ++label;
  }
  return names;
}

void ColourLabels::Convert(const char* pixels, Index count, unsigned char* labels) const
{
  const Index width = this->Form.Width();
  std::uint64_t last = 0;
  unsigned char label = 0;
  for (Index i = 0; i < count; ++i)
  {
    const std::uint64_t colour = this->TakeColour(pixels + i * width);
    if (colour != last)
    {
      const auto found = this->Labels.find(colour);
      if (found == this->Labels.end())
      {
        throw InputError("its values changed while it was read.");
      }
      last = colour;
      label = found->second;
    }
    labels[i] = label;
  }
}

} // namespace vfm
