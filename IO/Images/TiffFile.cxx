#include "CellCount.h"
#include "Images/ImageFile.h"
#include "OpenFile.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <tiffio.h>
#include <vector>

namespace vfm
{
namespace
{

/// Format of a page, which must be equal for all pages of a stack.
struct Page
{
  std::uint32_t Width = 0, Height = 0;
  bool HasStrips = false;
  std::uint16_t Bits = 0, Format = 0, Samples = 0;

  explicit Page(TIFF* file)
  {
    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &this->Width);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &this->Height);
    TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &this->Bits);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &this->Format);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &this->Samples);
    std::uint32_t rows = 0;
    TIFFGetFieldDefaulted(file, TIFFTAG_ROWSPERSTRIP, &rows);
    this->HasStrips = rows > 0 && TIFFIsTiled(file) == 0;
  }
  bool operator!=(const Page& other) const
  {
    return this->Width != other.Width || this->Height != other.Height || this->Bits != other.Bits ||
      this->Format != other.Format || this->Samples != other.Samples || !this->HasStrips;
  }
};

/// Returns the number of images according to the description by ImageJ, or 1 without a description.
/// ImageJ may store all of them behind the first page, without pages of their own.
int CountDescribed(TIFF* file)
{
  constexpr const char* key = "\nimages=";
  const char* text = nullptr;
  const bool isImageJ =
    TIFFGetField(file, TIFFTAG_IMAGEDESCRIPTION, &text) && std::strncmp(text, "ImageJ=", 7) == 0;
  const char* found = isImageJ ? std::strstr(text, key) : nullptr;
  return found ? std::atoi(found + std::strlen(key)) : 1;
}

using TiffHandle = std::unique_ptr<TIFF, void (*)(TIFF*)>;

TiffHandle Open(const std::string& path)
{
  OpenFile(path);
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  TiffHandle file(TIFFOpen(path.c_str(), "r"), TIFFClose);
  if (!file)
  {
    throw InputError("it is not a TIFF file.");
  }
  return file;
}

/// Checks that all pages have the format of the first; returns their number.
int CheckPages(TIFF* file, const Page& first)
{
  if (first.Samples != 1 || (first.Bits != 8 && first.Bits != 16 && first.Bits != 32))
  {
    throw InputError("it has " + std::to_string(first.Samples) + " values of " +
      std::to_string(first.Bits) + " bits per point; one value of 8, 16 or 32 bits is required.");
  }
  if (!first.HasStrips)
  {
    throw InputError(
      "its values are not stored in strips of rows. It has tiles, which are not supported, or is "
      "damaged.");
  }
  const int described = CountDescribed(file);
  const int pages = TIFFNumberOfDirectories(file);
  if (pages < described)
  {
    throw InputError("ImageJ wrote " + std::to_string(described) + " images, but it has " +
      std::to_string(pages) + (pages == 1 ? " page" : " pages") +
      ". Save it as a stack with one page per image, or in another format.");
  }
  for (int page = 2; page <= pages; ++page)
  {
    if (!TIFFReadDirectory(file) || Page(file) != first)
    {
      throw InputError("page " + std::to_string(page) +
        " differs from the first in storage, size or type, or is damaged.");
    }
  }
  TIFFSetDirectory(file, 0);
  return pages;
}

int FindType(const Page& page)
{
  const bool isSigned = page.Format == SAMPLEFORMAT_INT;
  if (page.Bits == 8)
  {
    return isSigned ? ValueType::SignedChar : ValueType::UnsignedChar;
  }
  if (page.Bits == 16)
  {
    return isSigned ? ValueType::Short : ValueType::UnsignedShort;
  }
  return page.Format == SAMPLEFORMAT_IEEEFP ? ValueType::Float
    : isSigned                              ? ValueType::Int
                                            : ValueType::UnsignedInt;
}

/// Returns the widths of voxels in millimetres; 1 if the file does not contain them.
Vector3 FindSpacing(TIFF* file, int pages)
{
  std::uint16_t unit = 0;
  float x = 0.0F, y = 0.0F;
  TIFFGetFieldDefaulted(file, TIFFTAG_RESOLUTIONUNIT, &unit);
  const bool hasResolution = TIFFGetField(file, TIFFTAG_XRESOLUTION, &x) == 1 &&
    TIFFGetField(file, TIFFTAG_YRESOLUTION, &y) == 1 && x > 0.0F && y > 0.0F;
  const double length = unit == RESUNIT_INCH ? 25.4 : unit == RESUNIT_CENTIMETER ? 10.0 : 0.0;
  if (!hasResolution || length == 0.0)
  {
    return { { 1.0, 1.0, 1.0 } };
  }
  return { { length / x, length / y, pages > 1 ? length / x : 1.0 } };
}

/// Reads one page as VTK does: the first row of the file becomes the lowest; the last row does if
/// the orientation is not top left.
void ReadPage(TIFF* file, const Index3& size, Index width, char* to)
{
  std::uint16_t orientation = 0, meaning = PHOTOMETRIC_MINISBLACK;
  TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &orientation);
  TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &meaning);
  const Index length = size[0] * width;
  std::vector<char> row(std::max<std::size_t>(TIFFScanlineSize(file), length));
  for (Index j = 0; j < size[1]; ++j)
  {
    if (TIFFReadScanline(file, row.data(), static_cast<std::uint32_t>(j), 0) != 1)
    {
      throw InputError("its values cannot be read.");
    }
    const Index up = orientation == ORIENTATION_TOPLEFT ? j : size[1] - 1 - j;
    std::transform(row.begin(), row.begin() + length, to + up * length,
      [meaning](char c) { return meaning == PHOTOMETRIC_MINISWHITE ? static_cast<char>(~c) : c; });
  }
}

} // namespace

ImageFile OpenTiff(const std::string& path, const ImageRequest&)
{
  const TiffHandle file = Open(path);
  const Page first(file.get());
  const int pages = CheckPages(file.get(), first);
  ImageFile image;
  image.Place.Size = { first.Width, first.Height, pages };
  image.Place.Spacing = FindSpacing(file.get(), pages);
  CheckPlace(image.Place);
  const int type = FindType(first);
  const Index width = WidthOfType(type);
  const Index3 size = image.Place.Size;
  CheckLength(path, 0, CountCells(size) * width, true);
  image.ReadsParts = false;
  image.Read = [path, type, width, size](const IndexBox& box) // box of the whole image
  {
    TypedValues values = MakeValues("", type, box.NumberOfCells());
    const TiffHandle pagesOfFile = Open(path);
    for (Index page = 0; page < size[2]; ++page)
    {
      if (page > 0 && !TIFFReadDirectory(pagesOfFile.get()))
      {
        throw InputError("its values cannot be read.");
      }
      ReadPage(
        pagesOfFile.get(), size, width, values.Bytes.data() + page * size[0] * size[1] * width);
    }
    return values;
  };
  return image;
}

} // namespace vfm
