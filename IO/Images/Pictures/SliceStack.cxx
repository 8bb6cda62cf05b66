#include "FileSuffix.h"
#include "Images/Pictures/PixelStack.h"
#include "Ranks/Errors.h"

#include <filesystem>

namespace vfm
{
namespace
{

std::string NameOf(const std::string& path)
{
  return std::filesystem::path(path).filename().string();
}

PixelStack OpenSlice(const std::string& path)
{
  PixelStack slice;
  PrefixErrors("slice " + NameOf(path) + ": ",
    [&]
    {
      slice =
        HasSuffix(path, ".png") ? OpenPngStack(path) : OpenTiffStack(path, ImageRequest(), true);
      if (slice.Place.Size[2] != 1)
      {
        throw InputError("it has " + std::to_string(slice.Place.Size[2]) +
          " pages; each file of a slice must have one.");
      }
    });
  return slice;
}

std::string DescribeForm(const PixelStack& slice)
{
  return std::to_string(slice.Place.Size[0]) + " x " + std::to_string(slice.Place.Size[1]) +
    " pixels (" + NameOfType(slice.Form.Type) + ", " + std::to_string(slice.Form.Samples) +
    (slice.Form.Samples == 1 ? " value)" : " values)");
}

} // namespace

PixelStack OpenSlices(const std::vector<std::string>& files)
{
  PixelStack stack = OpenSlice(files.at(0));
  stack.Place.Size[2] = static_cast<Index>(files.size());
  const PixelStack first = stack;
  stack.Visit = [files, first](Index begin, Index end, const UsePixels& use)
  {
    for (Index layer = begin; layer < end; ++layer)
    {
      const std::string& path = files[static_cast<std::size_t>(layer)];
      const PixelStack slice = OpenSlice(path);
      if (slice.Place.Size[0] != first.Place.Size[0] ||
        slice.Place.Size[1] != first.Place.Size[1] || slice.Form != first.Form)
      {
        throw InputError("slice " + NameOf(path) + " has " + DescribeForm(slice) +
          ", but the first slice, " + NameOf(files[0]) + ", has " + DescribeForm(first) +
          ". All slices must have the same size and type.");
      }
      PrefixErrors("slice " + NameOf(path) + ": ",
        [&] { slice.Visit(0, 1, [&](Index, const char* pixels) { use(layer, pixels); }); });
    }
  };
  return stack;
}

} // namespace vfm
