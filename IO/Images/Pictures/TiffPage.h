/**
 * TiffPage: form of a page of a TIFF file, and its pixels.
 */
#pragma once

#include "Images/Pictures/PixelStack.h"

#include <cstdint>
#include <memory>
#include <string>
#include <tiffio.h>

namespace vfm
{

using TiffHandle = std::unique_ptr<TIFF, void (*)(TIFF*)>;

/// Opens a TIFF file at its first page.
/// @throws InputError  if it is not a TIFF file
TiffHandle OpenTiffHandle(const std::string& path);

/// Form of a page, which must be equal for all pages of a stack.
struct TiffPage
{
  explicit TiffPage(TIFF* file);
  bool operator!=(const TiffPage& other) const;

  /// Returns the form of the pixels as Read sets them: values of less than 8 bits have 8.
  /// @throws InputError  if the form is not supported
  PixelForm FindForm() const;

  std::uint32_t Width = 0, Height = 0;
  std::uint16_t Bits = 0, Format = 0, Samples = 0, Planar = 0, Meaning = 0;
  bool IsTiled = false, HasRows = false;
};

/// Reads the pixels of the current page. The first row of the file becomes the first row, except
/// if the orientation is not top left: then the last row does.
/// @param page  form of the page
/// @param to  memory of all pixels, x fastest
void ReadTiffPage(TIFF* file, const TiffPage& page, char* to);

} // namespace vfm
