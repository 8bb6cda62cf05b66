#include "CellCount.h"
#include "Images/Pictures/TiffDescription.h"
#include "Images/Pictures/TiffPage.h"
#include "Images/StoredValues.h"
#include "OpenFile.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <vector>

namespace vfm
{
namespace
{

TiffDescription DescribeStack(TIFF* file, const TiffPage& first)
{
  const char* text = nullptr;
  const bool isDescribed = TIFFGetField(file, TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text;
  return ParseTiffDescription(isDescribed ? text : "", first.Samples);
}

/// Counts the pages, which must have the form of the first.
Index CountPages(TIFF* file, const TiffPage& first)
{
  const int pages = TIFFNumberOfDirectories(file);
  for (int page = 2; page <= pages; ++page)
  {
    if (!TIFFReadDirectory(file) || TiffPage(file) != first)
    {
      throw InputError("page " + std::to_string(page) +
        " differs from the first in storage, size or type, or is damaged.");
    }
  }
  if (!TIFFLastDirectory(file))
  {
    throw InputError(
      "its list of pages is damaged or truncated after page " + std::to_string(pages) + ".");
  }
  TIFFSetDirectory(file, 0);
  return pages;
}

/// Finds the place of all images of ImageJ, which stores them behind each other if the file has
/// more than 4 GB. Only the first image then has a page.
/// @throws InputError  if they are stored in another way
StoredValues FindImagesWithoutPages(
  TIFF* file, const std::string& path, const TiffDescription& description, const PixelForm& form)
{
  std::uint16_t compression = 0, bits = 0;
  TIFFGetFieldDefaulted(file, TIFFTAG_COMPRESSION, &compression);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits);
  const bool isContiguous = compression == COMPRESSION_NONE && bits >= 8 && form.Samples == 1 &&
    TIFFIsTiled(file) == 0 && TIFFNumberOfStrips(file) == 1 && TIFFNumberOfDirectories(file) == 1;
  if (description.Program != "ImageJ" || !isContiguous)
  {
    throw InputError(description.Program + " describes " +
      std::to_string(description.CountImages()) + " images, but it has " +
      std::to_string(TIFFNumberOfDirectories(file)) +
      " pages. Save it as a stack with one page per image in one file, or in another format.");
  }
  StoredValues stored{ { path }, form.Type };
  stored.Begin = static_cast<Index>(TIFFGetStrileOffset(file, 0));
  stored.AreSwapped = TIFFIsByteSwapped(file) != 0;
  return stored;
}

/// Returns 1 if ImageJ names the unit of lengths, otherwise the length of the unit of the
/// resolution in millimetres; 0 if the file has no unit.
double FindUnit(TIFF* file, const TiffDescription& description)
{
  constexpr double inch = 25.4, centimetre = 10.0;
  if (!description.Unit.empty())
  {
    return 1.0;
  }
  std::uint16_t number = 0;
  TIFFGetFieldDefaulted(file, TIFFTAG_RESOLUTIONUNIT, &number);
  return number == RESUNIT_INCH ? inch : number == RESUNIT_CENTIMETER ? centimetre : 0.0;
}

/// Returns whether the resolution is per centimetre but the description names micrometres, as
/// ImageJ writes and reads it.
bool IsScaledToMicrometres(TIFF* file, const TiffDescription& description)
{
  const std::string names[] = { "um", "micron", "microns", "micrometer", "micrometre", "\\u00B5m",
    "\xC2\xB5m", "\xCE\xBCm", "\xB5m" };
  std::uint16_t number = 0;
  TIFFGetFieldDefaulted(file, TIFFTAG_RESOLUTIONUNIT, &number);
  return number == RESUNIT_CENTIMETER &&
    std::find(std::begin(names), std::end(names), description.Unit) != std::end(names);
}

/// Sets the spacing from the description or the resolution; what is missing is 1 for pixels, and
/// the width of pixels for the distance of slices.
void SetSpacing(TIFF* file, const TiffDescription& description, PixelStack& stack)
{
  float x = 0.0F, y = 0.0F;
  const bool hasResolution = TIFFGetField(file, TIFFTAG_XRESOLUTION, &x) == 1 &&
    TIFFGetField(file, TIFFTAG_YRESOLUTION, &y) == 1 && x > 0.0F && y > 0.0F;
  const double unit = FindUnit(file, description);
  const std::array<double, 2>& widths = description.Widths;
  Vector3& spacing = stack.Place.Spacing;
  if (widths[0] > 0.0 && widths[1] > 0.0)
  {
    spacing = { { widths[0], widths[1], 0.0 } };
    stack.HasWidths = true;
  }
  else if (hasResolution && unit > 0.0)
  {
    const double micrometres = IsScaledToMicrometres(file, description) ? 1e4 : 1.0;
    spacing = { { micrometres * unit / x, micrometres * unit / y, 0.0 } };
    stack.HasWidths = true;
  }
  stack.HasDistance = description.Distance > 0.0;
  const double scale = stack.HasWidths && widths[0] == 0.0 ? unit : 1.0;
  spacing[2] = stack.HasDistance ? scale * description.Distance : spacing[0];
}

/// Calls `use` for layers of a stack with one page per image.
void VisitPages(const std::string& path, const TiffPage& page, const TiffDescription& description,
  Index volume, Index first, Index last, const UsePixels& use)
{
  const TiffHandle file = OpenTiffHandle(path);
  const Index width = page.FindForm().Width();
  std::vector<char> pixels(static_cast<std::size_t>(Index(page.Width) * page.Height * width));
  Index at = 0;
  for (Index layer = first; layer < last; ++layer)
  {
    for (const Index next = description.FindPage(volume, layer); at < next; ++at)
    {
      if (!TIFFReadDirectory(file.get()))
      {
        throw InputError("its values cannot be read.");
      }
    }
    ReadTiffPage(file.get(), page, pixels.data());
    use(layer, pixels.data());
  }
}

/// Calls `use` for layers of a stack that is stored without pages.
void VisitStored(const StoredValues& stored, const Index3& size, const TiffDescription& description,
  Index volume, Index first, Index last, const UsePixels& use)
{
  for (Index layer = first; layer < last; ++layer)
  {
    const Index image = description.FindPage(volume, layer);
    const IndexBox box{ { { 0, 0, image } }, { { size[0], size[1], image + 1 } } };
    const TypedValues values = ReadStored(stored, size, box);
    use(layer, values.Bytes.data());
  }
}

} // namespace

PixelStack OpenTiffStack(const std::string& path, const ImageRequest& request, bool isSlice)
{
  const TiffHandle file = OpenTiffHandle(path);
  const TiffPage page(file.get());
  PixelStack stack;
  stack.Form = page.FindForm();
  TiffDescription description = DescribeStack(file.get(), page);
  const Index pages = CountPages(file.get(), page);
  const Index length = CountCells({ page.Width, page.Height, description.CountImages() }) *
    (stack.Form.Samples * page.Bits) / 8;
  const bool isPart = isSlice && pages < description.CountImages() && GetFileLength(path) < length;
  if (pages > description.CountImages() || isPart)
  {
    description.Slices = pages;
    description.Channels = description.Times = description.SliceStep = 1;
  }
  stack.Volumes = description.CountVolumes();
  const Index volume = SelectVolume(request, stack.Volumes,
    std::to_string(description.Channels) + " channels, " + std::to_string(description.Times) +
      " times");
  stack.Place.Size = { page.Width, page.Height, description.Slices };
  SetSpacing(file.get(), description, stack);
  CheckPlace(stack.Place);
  Index3 all = stack.Place.Size;
  all[2] = description.CountImages();
  CheckLength(path, 0, CountCells(all) * (stack.Form.Samples * page.Bits) / 8, true);
  if (pages < description.CountImages())
  {
    const StoredValues stored = FindImagesWithoutPages(file.get(), path, description, stack.Form);
    CheckFiles(stored, all);
    stack.Visit = [=](Index first, Index last, const UsePixels& use)
    { VisitStored(stored, all, description, volume, first, last, use); };
    return stack;
  }
  stack.Visit = [=](Index first, Index last, const UsePixels& use)
  { VisitPages(path, page, description, volume, first, last, use); };
  return stack;
}

ImageFile OpenTiff(const std::string& path, const ImageRequest& request)
{
  return MakeImage(OpenTiffStack(path, request));
}

} // namespace vfm
