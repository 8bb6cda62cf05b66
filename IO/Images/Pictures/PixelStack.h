/**
 * PixelStack: layers of pixels of a picture, of the pages of a file or of several files, and their
 * conversion to an image of one value per point.
 */
#pragma once

#include "Images/ImageFile.h"

#include <functional>
#include <string>

namespace vfm
{

/// Form of the values of a pixel.
struct PixelForm
{
  int Type = ValueType::UnsignedChar; ///< one of ValueType; for colours of one or two bytes
  int Samples = 1;                    ///< 1: one value; 3: red, green, blue; 4: also opacity

  Index Width() const { return this->Samples * WidthOfType(this->Type); } ///< bytes
  bool operator!=(const PixelForm& other) const
  {
    return this->Type != other.Type || this->Samples != other.Samples;
  }
};

/// Receives the pixels of a layer, x fastest.
using UsePixels = std::function<void(Index layer, const char* pixels)>;

/// Layers of pixels.
struct PixelStack
{
  ImagePlace Place; ///< place of the values; Size[2] is the number of layers
  PixelForm Form;
  Index Volumes = 1; ///< number of stacks in the file
  /// True: the file contains the widths of pixels, or the distance of layers.
  bool HasWidths = false, HasDistance = false;
  /// Reads the layers from `first` up to, not including, `last`.
  std::function<void(Index first, Index last, const UsePixels& use)> Visit;
};

/// Opens a TIFF file, see OpenTiff.
/// @param isSlice  the file is one slice of several; ImageJ then describes the whole stack in it
PixelStack OpenTiffStack(
  const std::string& path, const ImageRequest& request, bool isSlice = false);
/// Opens a PNG file, see OpenPng.
PixelStack OpenPngStack(const std::string& path);
/// Opens files with one layer each, in natural order of their names.
/// @throws InputError  if the first file cannot be read; Visit throws if another file cannot be
///   read or differs in size or type. The message contains the name of the file.
PixelStack OpenSlices(const std::vector<std::string>& files);

/// Makes an image of layers. Colours become labels: black and transparent pixels are 0, the other
/// colours are numbered from 1 in ascending order of red, then green, then blue.
/// @throws InputError  if there are more than 255 other colours
ImageFile MakeImage(PixelStack stack);

} // namespace vfm
