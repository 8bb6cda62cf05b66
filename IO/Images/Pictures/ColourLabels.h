/**
 * ColourLabels: labels of the colours of pictures.
 */
#pragma once

#include "Images/Pictures/PixelStack.h"

#include <cstdint>
#include <map>

namespace vfm
{

/// Numbers the colours of pixels with 3 or 4 samples. Call Add for all pixels, then Number.
class ColourLabels
{
public:
  explicit ColourLabels(const PixelForm& form) : Form(form) {}

  /// Adds the colours of pixels.
  /// @throws InputError  if there are more than 255 colours except black
  void Add(const char* pixels, Index count);
  /// Numbers the colours and returns their names, for instance "rgb 255 0 0". If all are grey, up
  /// to 255, the numbers are their values, without names.
  LabelNames Number();
  /// Sets the label of each pixel.
  void Convert(const char* pixels, Index count, unsigned char* labels) const;

private:
  bool AreGrey() const;
  std::uint64_t TakeColour(const char* pixel) const;

  PixelForm Form;
  std::map<std::uint64_t, unsigned char> Labels{ { 0, 0 } }; ///< black is 0
};

} // namespace vfm
