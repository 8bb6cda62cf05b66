#include "Images/Pictures/PixelStack.h"

#include "Base/ParseText.h"
#include "Images/Pictures/ColourLabels.h"

#include <cstring>
#include <memory>

namespace vfm
{
namespace
{

/// Returns a warning about a spacing that the file does not contain, or "".
std::string WarnOfSpacing(const PixelStack& stack)
{
  const ImagePlace& place = stack.Place;
  if (place.Size[2] == 1 || stack.HasDistance)
  {
    return "";
  }
  const std::string x = FormatNumber(place.Spacing[0]), y = FormatNumber(place.Spacing[1]);
  return (stack.HasWidths ? "it contains the size of pixels, " + x + " x " + y +
               ", but not the distance of slices; " + FormatNumber(place.Spacing[2])
                          : std::string("it contains no size of voxels; 1 x 1 x 1")) +
    " is assumed. Set --spacing or Spacing.";
}

/// Copies a box of one layer, with `width` bytes per pixel.
void CopyBox(const char* layer, const Index3& size, const IndexBox& box, Index width, char* to)
{
  const Index length = box.Size(0) * width;
  for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
  {
    std::memcpy(to, layer + (j * size[0] + box.Lower[0]) * width, length);
    to += length;
  }
}

TypedValues ReadValuesOf(const PixelStack& stack, const IndexBox& box)
{
  TypedValues values = MakeValues("", stack.Form.Type, box.NumberOfCells());
  const Index width = stack.Form.Width(), area = box.Size(0) * box.Size(1) * width;
  stack.Visit(box.Lower[2], box.Upper[2],
    [&](Index layer, const char* pixels)
    {
      CopyBox(
        pixels, stack.Place.Size, box, width, values.Bytes.data() + (layer - box.Lower[2]) * area);
    });
  return values;
}

TypedValues ReadLabelsOf(const PixelStack& stack, const ColourLabels& labels, const IndexBox& box)
{
  TypedValues values = MakeValues("", ValueType::UnsignedChar, box.NumberOfCells());
  const Index3& size = stack.Place.Size;
  std::vector<unsigned char> layerLabels(static_cast<std::size_t>(size[0] * size[1]));
  stack.Visit(box.Lower[2], box.Upper[2],
    [&](Index layer, const char* pixels)
    {
      labels.Convert(pixels, size[0] * size[1], layerLabels.data());
      CopyBox(reinterpret_cast<const char*>(layerLabels.data()), size, box, 1,
        values.Bytes.data() + (layer - box.Lower[2]) * box.Size(0) * box.Size(1));
    });
  return values;
}

} // namespace

ImageFile MakeImage(PixelStack stack)
{
  ImageFile image;
  image.Place = stack.Place;
  image.Volumes = stack.Volumes;
  image.SpacingWarning = WarnOfSpacing(stack);
  if (stack.Form.Samples == 1)
  {
    image.Read = [stack](const IndexBox& box) { return ReadValuesOf(stack, box); };
    return image;
  }
  ColourLabels labels(stack.Form);
  const Index3& size = stack.Place.Size;
  stack.Visit(
    0, size[2], [&](Index, const char* pixels) { labels.Add(pixels, size[0] * size[1]); });
  image.Names = labels.Number();
  image.Read = [stack, labels](const IndexBox& box) { return ReadLabelsOf(stack, labels, box); };
  return image;
}

} // namespace vfm
