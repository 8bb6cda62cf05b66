#include "ImageInput.h"

#include "FileSuffix.h"
#include "Images/ImageSource.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "Ranks/WorkTogether.h"
#include "ReaderSteps.h"

#include <algorithm>

namespace vfm
{
namespace
{

ImageSource OpenSource(const Arguments& arguments)
{
  if (!IsVoxelFile(arguments.Input))
  {
    const Vector3 spacing = arguments.Spacing.value_or(Vector3{});
    return arguments.Labels.empty() ? OpenImage(arguments.Input, spacing)
                                    : OpenImage(arguments.Input, spacing, arguments.Labels);
  }
  const std::array<int, 3> cells = arguments.Dimensions.value_or(std::array<int, 3>{});
  return OpenVoxels(arguments.Input, { { cells[0], cells[1], cells[2] } },
    arguments.Origin.value_or(Vector3{}), arguments.Spacing.value_or(Vector3{ { 1.0, 1.0, 1.0 } }),
    static_cast<AxisOrder>(arguments.AxisOrder.value_or(0)));
}

/// This rank's part of an image, across its longest axis; empty where there are more ranks than layers.
IndexBox FindSlab(const Index3& size, const Ranks& ranks)
{
  IndexBox slab{ {}, size };
  const auto axis = std::max_element(size.begin(), size.end()) - size.begin();
  slab.Lower[axis] = size[axis] * ranks.Rank() / ranks.Count();
  slab.Upper[axis] = size[axis] * (ranks.Rank() + 1) / ranks.Count();
  return slab.NumberOfCells() > 0 ? slab : IndexBox();
}

ImageFrame FrameOf(const ImagePlace& image)
{
  std::array<double, 9> axes;
  for (int i = 0; i < 9; ++i)
  {
    axes[i] = image.Axes[i % 3][i / 3];
  }
  return MakeImageFrame(axes, image.Origin, "The input");
}

InputBlock MakeBlock(const ImageSource& source, const IndexBox& slab,
  std::vector<TypedValues> values, const ImageFrame& frame, const Ranks& ranks)
{
  InputBlock block;
  block.Name = NameBlock(-1, ranks.Rank(), ranks.Count() == 1);
  block.ArePoints = !source.IsOfCells;
  block.Box = slab;
  const Vector3 origin = frame.OriginOf(source.Place.Origin);
  for (int a = 0; a < 3; ++a)
  {
    const double spacing = source.Place.Spacing[a];
    const double start = block.ArePoints ? origin[a] - 0.5 * spacing : origin[a];
    block.Coordinates[a] =
      EvenNodes(start, spacing, static_cast<int>(slab.Lower[a]), static_cast<int>(slab.Upper[a]));
  }
  CheckCoordinates(block);
  KeepAllCells(block);
  auto arrays = std::make_shared<PlainArrays>(slab.NumberOfCells());
  for (TypedValues& own : values)
  {
    arrays->Keep(own.Name, own.Type, std::move(own.Bytes));
  }
  block.Arrays = arrays;
  return block;
}

} // namespace

std::vector<std::string> GetVoxelSuffixes()
{
  return { ".spn", ".npy" };
}

bool IsVoxelFile(const std::string& path)
{
  return HasSuffix(path, ".spn") || HasSuffix(path, ".npy");
}

Input ReadImage(const Arguments& arguments, Ranks& ranks)
{
  CollectedBlocks blocks;
  const auto read = [&]
  {
    const ImageSource source = OpenSource(arguments);
    const IndexBox slab = FindSlab(source.Place.Size, ranks);
    std::vector<TypedValues> values = source.Read(slab, ranks);
    blocks.Reading = { !source.IsOfCells, FrameOf(source.Place) };
    if (slab.NumberOfCells() > 0)
    {
      blocks.Blocks.push_back(
        MakeBlock(source, slab, std::move(values), blocks.Reading.Frame, ranks));
    }
  };
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      CheckInputFile(arguments.Input);
      ChooseTime(arguments, {});
      CheckInput(arguments.Input, read, "Cannot read ");
    });
  return MakeInput(std::move(blocks), true);
}

} // namespace vfm
