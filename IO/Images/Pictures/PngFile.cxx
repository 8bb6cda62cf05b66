#include "CellCount.h"
#include "Images/Pictures/PixelStack.h"
#include "OpenFile.h"
#include "SwapBytes.h"

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <png.h>
#include <vector>

namespace vfm
{
namespace
{

/// Leaves libpng without its message on the terminal.
void FailPng(png_structp png, png_const_charp)
{
  png_longjmp(png, 1);
}

void IgnoreWarning(png_structp, png_const_charp) {}

/// Open PNG file. No object with a destructor is created between setjmp and longjmp.
class PngReader
{
public:
  explicit PngReader(const std::string& path) : File(nullptr, std::fclose)
  {
    OpenFile(path);
    this->File.reset(std::fopen(path.c_str(), "rb"));
    this->Png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, FailPng, IgnoreWarning);
    this->Info = this->Png ? png_create_info_struct(this->Png) : nullptr;
    if (!this->File || !this->Info || !this->ReadHeader())
    {
      png_destroy_read_struct(&this->Png, &this->Info, nullptr);
      throw InputError("it is not a PNG file, or it is damaged.");
    }
  }
  ~PngReader() { png_destroy_read_struct(&this->Png, &this->Info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Index Width() const { return png_get_image_width(this->Png, this->Info); }
  Index Height() const { return png_get_image_height(this->Png, this->Info); }
  int Channels() const { return png_get_channels(this->Png, this->Info); }
  bool IsWide() const { return png_get_bit_depth(this->Png, this->Info) == 16; }

  /// Reads all rows; values of less than 8 bits have a byte each.
  bool ReadRows(png_bytepp rows)
  {
    if (setjmp(png_jmpbuf(this->Png)))
    {
      return false;
    }
    png_read_image(this->Png, rows);
    png_read_end(this->Png, nullptr); // checks the end of the values
    return true;
  }

private:
  bool ReadHeader()
  {
    if (setjmp(png_jmpbuf(this->Png)))
    {
      return false;
    }
    png_init_io(this->Png, this->File.get());
    png_read_info(this->Png, this->Info);
    png_set_packing(this->Png);
    if (IsLittleEndian() && png_get_bit_depth(this->Png, this->Info) == 16)
    {
      png_set_swap(this->Png);
    }
    png_set_interlace_handling(this->Png);
    png_read_update_info(this->Png, this->Info);
    return true;
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> File;
  png_structp Png = nullptr;
  png_infop Info = nullptr;
};

/// Removes the opacity of grey values; transparent values become 0.
void RemoveOpacity(std::vector<char>& pixels, Index width)
{
  const Index count = static_cast<Index>(pixels.size()) / (2 * width);
  for (Index i = 0; i < count; ++i)
  {
    const char* from = pixels.data() + 2 * i * width;
    const bool isVisible = from[width] != 0 || from[2 * width - 1] != 0;
    std::memmove(pixels.data() + i * width, from, static_cast<std::size_t>(width));
    if (!isVisible)
    {
      std::memset(pixels.data() + i * width, 0, static_cast<std::size_t>(width));
    }
  }
}

/// Returns all pixels.
std::vector<char> ReadPixels(const std::string& path)
{
  PngReader reader(path);
  const Index width = reader.IsWide() ? 2 : 1, length = reader.Width() * reader.Channels() * width;
  std::vector<char> pixels(static_cast<std::size_t>(length * reader.Height()));
  std::vector<png_bytep> rows;
  for (Index j = 0; j < reader.Height(); ++j)
  {
    rows.push_back(reinterpret_cast<png_bytep>(pixels.data() + j * length));
  }
  if (!reader.ReadRows(rows.data()))
  {
    throw InputError("its values are truncated or damaged.");
  }
  if (reader.Channels() == 2)
  {
    RemoveOpacity(pixels, width);
  }
  return pixels;
}

} // namespace

PixelStack OpenPngStack(const std::string& path)
{
  const PngReader reader(path);
  PixelStack stack;
  stack.Place.Size = { reader.Width(), reader.Height(), 1 };
  CheckPlace(stack.Place);
  stack.Form = { reader.IsWide() ? ValueType::UnsignedShort : ValueType::UnsignedChar,
    reader.Channels() == 2 ? 1 : reader.Channels() };
  CheckLength(path, 0, CountCells(stack.Place.Size) * stack.Form.Width() / 8, true);
  stack.Visit = [path](Index first, Index last, const UsePixels& use)
  {
    if (first < last)
    {
      use(first, ReadPixels(path).data());
    }
  };
  return stack;
}

ImageFile OpenPng(const std::string& path, const ImageRequest&)
{
  return MakeImage(OpenPngStack(path));
}

} // namespace vfm
