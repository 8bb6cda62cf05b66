#include "Images/ImageFile.h"
#include "Images/VtkImageFile.h"
#include "OpenFile.h"
#include "Ranks/Errors.h"

#include "vtkNew.h"
#include "vtkTIFFReader.h"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <tiffio.h>

namespace vfm
{
namespace
{

/// What the pages of a stack must have in common.
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

/// How many images ImageJ says that it wrote; it may have put them all behind the first page. 1: it says nothing.
int CountDescribed(TIFF* file)
{
  constexpr const char* key = "\nimages=";
  const char* text = nullptr;
  const bool isImageJ =
    TIFFGetField(file, TIFFTAG_IMAGEDESCRIPTION, &text) && std::strncmp(text, "ImageJ=", 7) == 0;
  const char* found = isImageJ ? std::strstr(text, key) : nullptr;
  return found ? std::atoi(found + std::strlen(key)) : 1;
}

/// VTK's reader trusts that all pages are like the first, and reads what it does not know as colours.
void CheckPages(const std::string& path)
{
  OpenFile(path);
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  const std::unique_ptr<TIFF, void (*)(TIFF*)> file(TIFFOpen(path.c_str(), "r"), TIFFClose);
  if (!file)
  {
    throw InputError("it is no TIFF file.");
  }
  const Page first(file.get());
  if (first.Samples != 1 || (first.Bits != 8 && first.Bits != 16 && first.Bits != 32))
  {
    throw InputError("it has " + std::to_string(first.Samples) + " values of " +
      std::to_string(first.Bits) + " bits a point; wanted is one of 8, 16 or 32 bits.");
  }
  if (!first.HasStrips)
  {
    throw InputError(
      "its values are not stored in strips of rows (but in tiles, or it is damaged).");
  }
  const int described = CountDescribed(file.get());
  const int pages = TIFFNumberOfDirectories(file.get());
  if (pages < described)
  {
    throw InputError("ImageJ wrote " + std::to_string(described) + " images, but it has " +
      std::to_string(pages) + (pages == 1 ? " page" : " pages") +
      ". Save it as a stack with a page an image, or in another format.");
  }
  for (int page = 2; page <= pages; ++page)
  {
    if (!TIFFReadDirectory(file.get()) || Page(file.get()) != first)
    {
      throw InputError("page " + std::to_string(page) +
        " is stored otherwise than the first, of another size or type, or damaged.");
    }
  }
}

} // namespace

std::unique_ptr<ImageFile> OpenTiff(const std::string& path)
{
  CheckPages(path);
  vtkNew<vtkTIFFReader> reader;
  reader->SetIgnoreColorMap(true); // a palette colours labels
  return std::make_unique<VtkImageFile>(path, reader);
}

} // namespace vfm
