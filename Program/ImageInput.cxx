#include "ImageInput.h"

#include "FileSuffix.h"
#include "Images/ImageSource.h"
#include "Images/Pictures/SliceFiles.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "Ranks/WorkTogether.h"
#include "ReaderSteps.h"

namespace vfm
{
namespace
{

ImageSource OpenSource(const Arguments& arguments)
{
  if (!IsVoxelFile(arguments.Input))
  {
    const Vector3 spacing = arguments.Spacing.value_or(Vector3{});
    ImageRequest request;
    request.Array = arguments.Labels.empty() ? request.Array : arguments.Labels;
    request.Volume = arguments.Volume;
    request.TakesFirst = arguments.Task == Command::List;
    return OpenImage(arguments.Input, spacing, request);
  }
  const std::array<int, 3> cells = arguments.Dimensions.value_or(std::array<int, 3>{});
  return OpenVoxels(arguments.Input, { { cells[0], cells[1], cells[2] } },
    arguments.Origin.value_or(Vector3{}), arguments.Spacing.value_or(Vector3{ { 1.0, 1.0, 1.0 } }),
    static_cast<AxisOrder>(arguments.AxisOrder.value_or(0)),
    !arguments.Mesher.Threshold.empty() || arguments.Task == Command::List);
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
  block.ArePoints = !source.IsOfCells;
  block.Box = slab;
  block.Coordinates = EvenCoordinates(
    frame.OriginOf(source.Place.Origin), source.Place.Spacing, slab, block.ArePoints);
  FinishBlock(block, -1, ranks);
  auto arrays = std::make_shared<PlainArrays>(slab.NumberOfCells());
  for (TypedValues& own : values)
  {
    arrays->Store(own.Name, own.Type, std::move(own.Bytes));
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
  return HasSuffix(path, GetVoxelSuffixes());
}

Input ReadImage(const Arguments& arguments, Ranks& ranks)
{
  CollectedBlocks blocks;
  LabelNames names;
  std::string warning;
  Index volumes = 1;
  bool isPicture = false;
  const auto read = [&]
  {
    const ImageSource source = OpenSource(arguments);
    const IndexBox slab = FindSlab(source.Place.Size, ranks);
    std::vector<TypedValues> values = source.Read(slab, ranks);
    names = source.Names;
    warning = source.Warning;
    volumes = source.Volumes;
    isPicture = source.Place.Size[2] == 1 &&
      (AreSlices(arguments.Input) || HasSuffix(arguments.Input, GetSliceSuffixes()));
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
      if (!AreSlices(arguments.Input))
      {
        CheckInputFile(arguments.Input);
      }
      ChooseTime(arguments, {});
      CheckInput(arguments.Input, read, "Cannot read ");
    });
  Input input = MakeInput(std::move(blocks), true);
  input.Names = std::move(names);
  input.Volumes = volumes;
  input.IsPicture = isPicture;
  input.Warning = warning.empty() ? "" : arguments.Input + ": " + warning;
  return input;
}

} // namespace vfm
