#include "ListInput.h"

#include "ArrayMemory.h"
#include "Base/IndexBox.h"
#include "Base/ParseText.h"
#include "ChooseArrays.h"
#include "InputGrids.h"
#include "Ranks/WorkTogether.h"
#include "ReadInput.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeFractionToHex.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <ostream>

namespace vfm
{
namespace
{

constexpr double LevelTolerance = 0.01; // of the logarithm of a ratio of widths

/// A piece or block of the input, as it is sent.
struct GridInfo
{
  Index Cells = 0; ///< without copies of others'
  std::array<double, 6> Bounds{};
  std::array<int, 6> Extent{};    ///< of images and rectilinear grids, in cells
  std::array<double, 3> Widths{}; ///< of a mean cell of these; others: 0
};

Index CountCells(vtkDataSet* grid)
{
  const auto ghosts = InMemory(FindGhostTypes(grid, vtkDataObject::CELL));
  Index cells = grid->GetNumberOfCells();
  for (vtkIdType cell = 0; ghosts && cell < grid->GetNumberOfCells(); ++cell)
  {
    cells -= (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  }
  return cells;
}

/// Of an image of which each point is a cell.
GridInfo DescribePoints(vtkImageData* image)
{
  GridInfo info;
  image->GetExtent(info.Extent.data());
  for (int a = 0; a < 3; ++a)
  {
    info.Extent[2 * a + 1] += 1;
    info.Widths[a] = image->GetSpacing()[a];
  }
  info.Cells = image->GetNumberOfPoints();
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 index, point;
    for (int a = 0; a < 3; ++a)
    {
      index[a] = info.Extent[2 * a + ((corner >> a) & 1)] - 0.5;
    }
    image->TransformContinuousIndexToPhysicalPoint(index.data(), point.data());
    box.AddPoint(point.data());
  }
  box.GetBounds(info.Bounds.data());
  return info;
}

GridInfo Describe(vtkDataSet* grid, ArrayPlace place)
{
  if (place == ArrayPlace::Points)
  {
    return DescribePoints(vtkImageData::SafeDownCast(grid));
  }
  GridInfo info;
  info.Cells = CountCells(grid);
  grid->GetBounds(info.Bounds.data());
  if (auto* image = vtkImageData::SafeDownCast(grid))
  {
    image->GetExtent(info.Extent.data());
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    rectilinear->GetExtent(info.Extent.data());
  }
  for (int a = 0; a < 3; ++a)
  {
    const int cells = info.Extent[2 * a + 1] - info.Extent[2 * a];
    info.Widths[a] = cells > 0 ? (info.Bounds[2 * a + 1] - info.Bounds[2 * a]) / cells : 0.0;
  }
  return info;
}

/// Around all.
template <class Value>
std::array<Value, 6> Unite(
  const std::vector<GridInfo>& grids, std::array<Value, 6> GridInfo::*member)
{
  std::array<Value, 6> united = grids[0].*member;
  for (const GridInfo& grid : grids)
  {
    for (int a = 0; a < 3; ++a)
    {
      united[2 * a] = std::min(united[2 * a], (grid.*member)[2 * a]);
      united[2 * a + 1] = std::max(united[2 * a + 1], (grid.*member)[2 * a + 1]);
    }
  }
  return united;
}

template <class... Values>
std::string Print(const char* format, Values... values)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

struct LevelInfo
{
  std::array<double, 3> Widths{};
  std::size_t Blocks = 0;
  Index Cells = 0;
};

/// By level, the coarsest first; nothing when the widths are not those of levels (InputLevels.h).
std::map<long, LevelInfo> FindLevels(const std::vector<GridInfo>& grids)
{
  std::array<double, 3> widest{};
  for (const GridInfo& grid : grids)
  {
    for (int a = 0; a < 3; ++a)
    {
      widest[a] = std::max(widest[a], grid.Widths[a]);
    }
  }
  std::map<long, LevelInfo> levels;
  for (const GridInfo& grid : grids)
  {
    const double finer = std::log2(widest[0] / grid.Widths[0]); // NaN where they are not known
    for (int a = 0; a < 3; ++a)
    {
      if (!(std::abs(std::log2(widest[a] / grid.Widths[a]) - std::round(finer)) < LevelTolerance))
      {
        return {};
      }
    }
    LevelInfo& level = levels[std::lround(finer)];
    level.Widths = grid.Widths;
    ++level.Blocks;
    level.Cells += grid.Cells;
  }
  return levels;
}

std::string CountOf(std::size_t count, const char* what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void PrintBlocks(const std::vector<GridInfo>& grids, std::ostream& to)
{
  const std::map<long, LevelInfo> levels = FindLevels(grids);
  to << CountOf(grids.size(), "block")
     << (levels.size() > 1 ? " of " + CountOf(levels.size(), "level") : "") << "\n";
  for (const auto& level : levels)
  {
    if (levels.size() > 1)
    {
      const LevelInfo& info = level.second;
      to << "  level " << level.first << ": " << CountOf(info.Blocks, "block") << ", " << info.Cells
         << Print(" cells of %g x %g x %g\n", info.Widths[0], info.Widths[1], info.Widths[2]);
    }
  }
}

/// isOne: the pieces of one grid, else its blocks.
void PrintGrid(const std::vector<GridInfo>& grids, bool isOne, bool isOfPoints, std::ostream& to)
{
  Index cells = 0;
  for (const GridInfo& grid : grids)
  {
    cells += grid.Cells;
  }
  const std::array<int, 6> extent =
    grids.empty() ? std::array<int, 6>() : Unite(grids, &GridInfo::Extent);
  if (isOne && isOfPoints) // pieces share points
  {
    cells = Index(extent[1] - extent[0]) * (extent[3] - extent[2]) * (extent[5] - extent[4]);
  }
  to << cells << " cells" << (isOfPoints ? " around points" : "");
  if (cells == 0)
  {
    to << "\n";
    return;
  }
  if (isOne && extent[1] > extent[0])
  {
    to << ", " << extent[1] - extent[0] << " x " << extent[3] - extent[2] << " x "
       << extent[5] - extent[4];
  }
  const std::array<double, 6> b = Unite(grids, &GridInfo::Bounds);
  to << Print("\nx %g to %g, y %g to %g, z %g to %g\n", b[0], b[1], b[2], b[3], b[4], b[5]);
  if (!isOne)
  {
    PrintBlocks(grids, to);
  }
}

void PrintTimes(const Input& input, std::ostream& to)
{
  if (input.Times.empty())
  {
    to << "no times\n";
    return;
  }
  to << CountOf(input.Times.size(), "time") << "\n";
  for (std::size_t step = 0; step < input.Times.size(); ++step)
  {
    to << Print("%8zu  %.10g%s\n", step, input.Times[step],
      input.Times[step] == *input.Time ? "  (of which the values are)" : "");
  }
}

void PrintArrays(const std::vector<ArrayInfo>& arrays, const char* what, std::ostream& to)
{
  std::size_t width = 28;
  for (const ArrayInfo& array : arrays)
  {
    width = std::max(width, array.Name.size() + 2);
  }
  const int w = static_cast<int>(width);
  to << "\n" << Print("%-*s%-20s%11s%14s%14s\n", w, what, "type", "components", "least", "most");
  for (const ArrayInfo& array : arrays)
  {
    std::string name = array.Name;
    name.resize(width, ' ');
    to << name << Print("%-20s%11d", vtkImageScalarTypeNameMacro(array.Type), array.Components)
       << (array.Components == 1 ? Print("%14.6g%14.6g", array.Least, array.Most) : "") << "\n";
  }
}

void PrintMaterials(const ChosenArrays& arrays, const std::vector<int>& labels, std::ostream& to)
{
  to << "\nmaterials";
  if (arrays.Fractions.empty() && arrays.Labels.empty())
  {
    to << ": none is found; name their arrays (--fractions A,B,.. or --labels ARRAY)\n";
    return;
  }
  to << " from " << (arrays.Labels.empty() ? JoinTexts(arrays.Fractions) : arrays.Labels) << " ("
     << arrays.How << ")\n";
  for (std::size_t m = 0; m < arrays.Fractions.size(); ++m)
  {
    to << Print("%8zu  ", m + 1) << arrays.Fractions[m] << "\n";
  }
  for (int label : labels)
  {
    to << Print("%8d\n", label);
  }
}

} // namespace

void ListInput(const Arguments& arguments, Ranks& ranks, std::ostream& to)
{
  const Input input = ReadInput(arguments, ranks);
  vtkNew<vtkVolumeFractionToHex> mesher; // for its default
  const ChosenArrays arrays =
    FindMaterials(input.Data, arguments, mesher->GetFractionTolerance(), ranks);
  const std::vector<ArrayInfo> cells = FindArrays(input.Data, ArrayPlace::Cells, ranks);
  const std::vector<ArrayInfo> points = AreImages(input.Data, ranks)
    ? FindArrays(input.Data, ArrayPlace::Points, ranks)
    : std::vector<ArrayInfo>();
  const bool isOfPoints = arrays.Place == ArrayPlace::Points && !points.empty();
  std::vector<GridInfo> mine;
  WorkInStage(ranks, ErrorCode::InternalError,
    [&]
    {
      for (vtkDataSet* grid : GetGrids(input.Data))
      {
        mine.push_back(Describe(grid, isOfPoints ? ArrayPlace::Points : ArrayPlace::Cells));
      }
    });
  const std::vector<GridInfo> grids = GatherItems(ranks, mine);
  const bool isOne = !ranks.Any(vtkCompositeDataSet::SafeDownCast(input.Data) != nullptr);
  const std::vector<int> labels =
    arrays.Labels.empty() ? std::vector<int>() : FindLabels(input.Data, arrays, ranks);
  if (ranks.Rank() > 0)
  {
    return;
  }
  to << arguments.Input << "\n";
  PrintTimes(input, to);
  PrintGrid(grids, isOne, isOfPoints, to);
  if (!cells.empty() || points.empty())
  {
    PrintArrays(cells, "cell array", to);
  }
  if (!points.empty())
  {
    PrintArrays(points, "point array", to);
  }
  PrintMaterials(arrays, labels, to);
  to << (arrays.Warning.empty() ? "" : arrays.Warning + "\n");
}

} // namespace vfm
