#include "Images/Pictures/TiffPage.h"

#include "OpenFile.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace vfm
{
namespace
{

constexpr int ByteBits = 8;

/// Writes values of a row of the file, of `bits` bits, into bytes; other values are copied.
void Unpack(const char* row, Index count, int bits, Index width, char* to)
{
  if (bits >= ByteBits)
  {
    std::memcpy(to, row, static_cast<std::size_t>(count * width));
    return;
  }
  const unsigned mask = (1U << bits) - 1U;
  for (Index i = 0; i < count; ++i)
  {
    const Index bit = i * bits;
    const unsigned byte = static_cast<unsigned char>(row[bit / ByteBits]);
    to[i] = static_cast<char>(byte >> (ByteBits - bits - bit % ByteBits) & mask);
  }
}

/// Reads the pixels in rows of the file, from strips.
void ReadStrips(TIFF* file, const TiffPage& page, Index width, char* to)
{
  std::vector<char> row(
    std::max<std::size_t>(TIFFScanlineSize(file), static_cast<std::size_t>(page.Width * width)));
  for (std::uint32_t j = 0; j < page.Height; ++j)
  {
    if (TIFFReadScanline(file, row.data(), j, 0) != 1)
    {
      throw InputError("its values cannot be read.");
    }
    Unpack(row.data(), page.Width, page.Bits, width, to + Index(j) * page.Width * width);
  }
}

/// Reads the pixels in rows of the file, from tiles.
void ReadTiles(TIFF* file, const TiffPage& page, Index width, char* to)
{
  std::uint32_t tileWidth = 0, tileHeight = 0;
  TIFFGetField(file, TIFFTAG_TILEWIDTH, &tileWidth);
  TIFFGetField(file, TIFFTAG_TILELENGTH, &tileHeight);
  const Index rowLength = TIFFTileRowSize(file), length = TIFFTileSize(file);
  const Index needed = (Index(tileWidth) * page.Bits * page.Samples + ByteBits - 1) / ByteBits;
  constexpr Index largest = Index(1) << 31;
  if (tileWidth == 0 || tileHeight == 0 || rowLength < needed || length > largest ||
    length < rowLength * tileHeight)
  {
    throw InputError("its tiles have no valid size.");
  }
  std::vector<char> tile(static_cast<std::size_t>(length));
  for (std::uint32_t y = 0; y < page.Height; y += tileHeight)
  {
    for (std::uint32_t x = 0; x < page.Width; x += tileWidth)
    {
      if (TIFFReadTile(file, tile.data(), x, y, 0, 0) < 0)
      {
        throw InputError("its values cannot be read.");
      }
      const Index columns = std::min(tileWidth, page.Width - x);
      const Index rows = std::min(tileHeight, page.Height - y);
      for (Index j = 0; j < rows; ++j)
      {
        Unpack(tile.data() + j * rowLength, columns, page.Bits, width,
          to + ((y + j) * page.Width + x) * width);
      }
    }
  }
}

/// Replaces the values of integers whose largest value is black.
void Invert(const TiffPage& page, char* pixels, Index bytes)
{
  const bool isWhiteFirst =
    page.Meaning == PHOTOMETRIC_MINISWHITE && page.Format != SAMPLEFORMAT_IEEEFP;
  const char mask = static_cast<char>(page.Bits < ByteBits ? (1 << page.Bits) - 1 : 0xff);
  std::transform(pixels, pixels + (isWhiteFirst ? bytes : 0), pixels,
    [mask](char c) { return static_cast<char>(c ^ mask); });
}

void TurnRows(char* pixels, Index length, Index rows)
{
  for (Index j = 0; j < rows / 2; ++j)
  {
    std::swap_ranges(
      pixels + j * length, pixels + (j + 1) * length, pixels + (rows - 1 - j) * length);
  }
}

/// Returns the type of integers; -1 if the number of bits is not supported.
int FindIntegerType(int bits, bool isSigned)
{
  switch (bits)
  {
    case 1:
    case 2:
    case 4:
      return isSigned ? -1 : ValueType::UnsignedChar;
    case 8:
      return isSigned ? ValueType::SignedChar : ValueType::UnsignedChar;
    case 16:
      return isSigned ? ValueType::Short : ValueType::UnsignedShort;
    case 32:
      return isSigned ? ValueType::Int : ValueType::UnsignedInt;
    case 64:
      return isSigned ? ValueType::LongLong : ValueType::UnsignedLongLong;
    default:
      return -1;
  }
}

/// Returns the type of values; -1 if it is not supported.
int FindType(const TiffPage& page)
{
  switch (page.Format)
  {
    case SAMPLEFORMAT_UINT:
    case SAMPLEFORMAT_VOID:
      return FindIntegerType(page.Bits, false);
    case SAMPLEFORMAT_INT:
      return FindIntegerType(page.Bits, true);
    case SAMPLEFORMAT_IEEEFP:
      return page.Bits == 32 ? ValueType::Float : page.Bits == 64 ? ValueType::Double : -1;
    default:
      return -1;
  }
}

} // namespace

TiffHandle OpenTiffHandle(const std::string& path)
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

TiffPage::TiffPage(TIFF* file)
{
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &this->Width);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &this->Height);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &this->Bits);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &this->Format);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &this->Samples);
  TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &this->Planar);
  this->Meaning = PHOTOMETRIC_MINISBLACK;
  TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &this->Meaning);
  std::uint32_t rows = 0;
  TIFFGetFieldDefaulted(file, TIFFTAG_ROWSPERSTRIP, &rows);
  this->IsTiled = TIFFIsTiled(file) != 0;
  this->HasRows = rows > 0 || this->IsTiled;
}

bool TiffPage::operator!=(const TiffPage& other) const
{
  return this->Width != other.Width || this->Height != other.Height || this->Bits != other.Bits ||
    this->Format != other.Format || this->Samples != other.Samples ||
    this->Planar != other.Planar || this->Meaning != other.Meaning || !this->HasRows;
}

PixelForm TiffPage::FindForm() const
{
  const int type = FindType(*this);
  const bool isValue = this->Samples == 1 && type >= 0;
  const bool isColour = (this->Samples == 3 || this->Samples == 4) &&
    this->Meaning == PHOTOMETRIC_RGB && this->Planar == PLANARCONFIG_CONTIG &&
    (type == ValueType::UnsignedChar || type == ValueType::UnsignedShort) && this->Bits >= ByteBits;
  if (!isValue && !isColour)
  {
    throw InputError("it has " + std::to_string(this->Samples) + " values of " +
      std::to_string(this->Bits) + " bits per point (format " + std::to_string(this->Format) +
      ", colour space " + std::to_string(this->Meaning) + ", planes " +
      std::to_string(this->Planar) +
      "). Supported: one integer of 1, 2, 4, 8, 16, 32 or 64 bits, one real number of 32 or 64 "
      "bits, or red, green and blue of 8 or 16 bits, not in separate planes.");
  }
  if (!this->HasRows)
  {
    throw InputError("its strips have no rows; the file is damaged.");
  }
  return { type, this->Samples };
}

void ReadTiffPage(TIFF* file, const TiffPage& page, char* to)
{
  const Index width = page.FindForm().Width();
  page.IsTiled ? ReadTiles(file, page, width, to) : ReadStrips(file, page, width, to);
  const Index length = page.Width * width;
  Invert(page, to, length * page.Height);
  std::uint16_t orientation = 0;
  TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &orientation);
  if (orientation != ORIENTATION_TOPLEFT)
  {
    TurnRows(to, length, page.Height);
  }
}

} // namespace vfm
