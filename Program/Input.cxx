#include "Input.h"

#include "Base/ParseText.h"
#include "Input/ArrayNames.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <cstdio>

namespace vfm
{
namespace
{

std::string Describe(const ArrayInfo& info)
{
  char values[80];
  std::snprintf(values, sizeof(values), "%g to %g", info.Least, info.Most);
  return info.Name + " (" + NameOfType(info.Type) + ", " +
    (info.Components == 1 ? values : std::to_string(info.Components) + " components") + ")";
}

std::string DescribeAll(const std::vector<ArrayInfo>& arrays)
{
  std::vector<std::string> texts;
  std::transform(arrays.begin(), arrays.end(), std::back_inserter(texts), Describe);
  return JoinTexts(texts);
}

CellsInfo DescribeBlock(const InputBlock& block, const ImageFrame& frame)
{
  CellsInfo info;
  info.Count = block.Kept.NumberOfCells();
  info.Box = block.Box;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 point;
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = block.Coordinates[a];
      point[a] = (corner >> a) & 1 ? x.back() : x.front();
      info.Widths[a] = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
    }
    point = frame.ToSpace(point);
    for (int a = 0; a < 3; ++a)
    {
      info.Lower[a] = corner == 0 ? point[a] : std::min(info.Lower[a], point[a]);
      info.Upper[a] = corner == 0 ? point[a] : std::max(info.Upper[a], point[a]);
    }
  }
  return info;
}

} // namespace

Input MakeInput(CollectedBlocks blocks, bool areOfImage)
{
  Input input;
  for (const InputBlock& block : blocks.Blocks)
  {
    const CellsInfo info = DescribeBlock(block, blocks.Reading.Frame);
    input.Pieces.push_back({ block.ArePoints ? nullptr : block.Arrays,
      block.ArePoints ? block.Arrays : nullptr, areOfImage, [info](ArrayPlace) { return info; } });
  }
  input.IsOne = areOfImage;
  input.Collect = [blocks = std::move(blocks)](const ArraysToRead&, Ranks&) { return blocks; };
  return input;
}

IndexBox FindSlab(const Index3& cells, const Ranks& ranks)
{
  IndexBox slab{ {}, cells };
  const auto axis = std::max_element(cells.begin(), cells.end()) - cells.begin();
  slab.Lower[axis] = cells[axis] * ranks.Rank() / ranks.Count();
  slab.Upper[axis] = cells[axis] * (ranks.Rank() + 1) / ranks.Count();
  return slab.NumberOfCells() > 0 ? slab : IndexBox();
}

ArrayLists ListsOf(const Input& input, ArrayPlace place)
{
  ArrayLists lists;
  for (const InputPiece& piece : input.Pieces)
  {
    const auto& arrays = place == ArrayPlace::Cells ? piece.Cells : piece.Points;
    if (arrays)
    {
      lists.push_back(arrays);
    }
  }
  return lists;
}

bool AreImages(const Input& input, Ranks& ranks)
{
  return !ranks.Any(std::any_of(input.Pieces.begin(), input.Pieces.end(),
    [](const InputPiece& piece) { return !piece.IsImage; }));
}

std::vector<ArrayInfo> FindArrays(const Input& input, ArrayPlace place, Ranks& ranks)
{
  std::vector<ArrayInfo> list;
  WorkTogether(ranks, [&] { list = ListArrays(ListsOf(input, place)); });
  list = UnionOfArrays(list, ranks);
  list.erase(std::remove_if(list.begin(), list.end(),
               [](const ArrayInfo& array) { return IsGhostName(array.Name); }),
    list.end());
  return list;
}

std::string DescribeArrays(const Input& input, Ranks& ranks)
{
  const std::string points = DescribeAll(FindArrays(input, ArrayPlace::Points, ranks));
  const std::string cells = DescribeAll(FindArrays(input, ArrayPlace::Cells, ranks));
  const char* which = AreImages(input, ranks)
    ? ""
    : ", which cannot be meshed, because points are the centres of cells only in images (.vti; "
      "STRUCTURED_POINTS in .vtk)";
  return "Its cell arrays: " + (cells.empty() ? "none" : cells) + "." +
    (points.empty() ? "" : std::string(" Its point arrays") + which + ": " + points + ".");
}

} // namespace vfm
