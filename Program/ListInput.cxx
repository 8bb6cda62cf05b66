#include "ListInput.h"

#include "Base/ParseText.h"
#include "ChooseArrays.h"
#include "Ranks/ItemRoute.h"
#include "Ranks/PrintableText.h"
#include "Ranks/WorkTogether.h"
#include "ReadInput.h"
#include "SurfaceInput.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <ostream>

namespace vfm
{
namespace
{

constexpr double LevelTolerance = 0.01; // tolerance of log2 of a ratio of widths

/// Returns the bounds, box, largest widths and total number of cells of all pieces.
CellsInfo UnionOverRanks(const std::vector<CellsInfo>& pieces)
{
  CellsInfo all = pieces[0];
  all.Count = 0;
  for (const CellsInfo& piece : pieces)
  {
    all.Count += piece.Count;
    for (int a = 0; a < 3; ++a)
    {
      all.Lower[a] = std::min(all.Lower[a], piece.Lower[a]);
      all.Upper[a] = std::max(all.Upper[a], piece.Upper[a]);
      all.Box.Lower[a] = std::min(all.Box.Lower[a], piece.Box.Lower[a]);
      all.Box.Upper[a] = std::max(all.Box.Upper[a], piece.Box.Upper[a]);
      all.Widths[a] = std::max(all.Widths[a], piece.Widths[a]);
    }
  }
  return all;
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
  Vector3 Widths{};
  std::size_t Blocks = 0;
  Index Cells = 0;
};

/// Returns the levels, the coarsest first; none if widths do not differ by common powers of two.
/// @param widest  widths of the coarsest cells
std::map<long, LevelInfo> FindLevels(const std::vector<CellsInfo>& blocks, const Vector3& widest)
{
  std::map<long, LevelInfo> levels;
  for (const CellsInfo& block : blocks)
  {
    const double finer = std::log2(widest[0] / block.Widths[0]); // NaN if widths are unknown
    for (int a = 0; a < 3; ++a)
    {
      if (!(std::abs(std::log2(widest[a] / block.Widths[a]) - std::round(finer)) < LevelTolerance))
      {
        return {};
      }
    }
    LevelInfo& level = levels[std::lround(finer)];
    level.Widths = block.Widths;
    ++level.Blocks;
    level.Cells += block.Count;
  }
  return levels;
}

std::string CountOf(std::size_t count, const char* what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void PrintBlocks(const std::vector<CellsInfo>& blocks, const Vector3& widest, std::ostream& to)
{
  const std::map<long, LevelInfo> levels = FindLevels(blocks, widest);
  to << CountOf(blocks.size(), "block")
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

/// Prints the number of cells and the bounds.
/// @param isOne  true: pieces of one grid, false: blocks
void PrintGrid(const std::vector<CellsInfo>& pieces, bool isOne, bool isOfPoints, std::ostream& to)
{
  const CellsInfo all = pieces.empty() ? CellsInfo() : UnionOverRanks(pieces);
  const IndexBox& box = all.Box;
  // Pieces share points, so their numbers cannot be added.
  const Index cells = isOne && isOfPoints ? box.NumberOfCells() : all.Count;
  to << cells << " cells" << (isOfPoints ? " around points" : "");
  if (cells == 0)
  {
    to << "\n";
    return;
  }
  if (isOne && box.Size(0) > 0)
  {
    to << ", " << box.Size(0) << " x " << box.Size(1) << " x " << box.Size(2);
  }
  to << Print("\nx %g to %g, y %g to %g, z %g to %g\n", all.Lower[0], all.Upper[0], all.Lower[1],
    all.Upper[1], all.Lower[2], all.Upper[2]);
  if (!isOne)
  {
    PrintBlocks(pieces, all.Widths, to);
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
      input.Times[step] == *input.Time ? "  (time of the values below)" : "");
  }
}

void PrintArrays(const std::vector<ArrayInfo>& arrays, const std::vector<ContentOfArray>& contents,
  const char* what, std::ostream& to)
{
  std::size_t width = 28;
  for (const ArrayInfo& array : arrays)
  {
    width = std::max(width, MakePrintable(array.Name).size() + 2);
  }
  const int w = static_cast<int>(width);
  to << "\n" << Print("%-*s%-20s%11s%14s%14s\n", w, what, "type", "components", "least", "most");
  for (const ArrayInfo& array : arrays)
  {
    std::string name = MakePrintable(array.Name);
    name.resize(width, ' ');
    to << name << Print("%-20s%11d", NameOfType(array.Type), array.Components)
       << (array.Components == 1 ? Print("%14.6g%14.6g", array.Least, array.Most) : "") << "\n";
  }
  to << "\n" << Print("%-*s%s\n", w, what, "content");
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    std::string name = arrays[a].Name;
    name.resize(width, ' ');
    to << name << NameOfContent(contents[a].Content) << ": " << contents[a].Reason << "\n";
  }
}

void PrintMaterials(const ChosenArrays& arrays, const std::vector<int>& labels, std::ostream& to)
{
  to << "\nmaterials";
  if (arrays.Fractions.empty() && arrays.Labels.empty())
  {
    to << ": none found; name their arrays (--fractions A,B,.., --labels ARRAY, or --threshold)\n";
    to << arrays.Problem << (arrays.Problem.empty() ? "" : "\n");
    return;
  }
  to << " from "
     << MakePrintable(arrays.Labels.empty() ? JoinTexts(arrays.Fractions) : arrays.Labels) << " ("
     << arrays.How << ")\n";
  for (std::size_t m = 0; m < arrays.Fractions.size(); ++m)
  {
    to << Print("%8zu  ", m + 1) << MakePrintable(arrays.Fractions[m]) << "\n";
  }
  for (int label : labels)
  {
    to << Print("%8d\n", label);
  }
}

} // namespace

void ListInput(const Arguments& arguments, Ranks& ranks, std::ostream& to)
{
  if (!arguments.SurfaceFiles.empty())
  {
    ListSurfaces(arguments, ranks, to);
    return;
  }
  const Input input = ReadInput(arguments, ranks);
  const ChosenArrays arrays =
    FindMaterials(input, arguments, MesherOptions().FractionTolerance, ranks);
  const std::vector<ArrayInfo> cells = FindArrays(input, ArrayPlace::Cells, ranks);
  const std::vector<ArrayInfo> points = AreImages(input, ranks)
    ? FindArrays(input, ArrayPlace::Points, ranks)
    : std::vector<ArrayInfo>();
  const bool isOfPoints = arrays.Place == ArrayPlace::Points && !points.empty();
  std::vector<CellsInfo> mine;
  WorkInStage(ranks, ErrorCode::InternalError,
    [&]
    {
      for (const InputPiece& piece : input.Pieces)
      {
        mine.push_back(piece.Describe(isOfPoints ? ArrayPlace::Points : ArrayPlace::Cells));
      }
    });
  const std::vector<CellsInfo> pieces = // of all ranks, on rank 0
    ItemRoute(std::vector<int>(mine.size(), 0), ranks).Send(mine);
  const std::vector<int> labels = arrays.Labels.empty()
    ? std::vector<int>()
    : FindLabels(ListsOf(input, arrays.Place), arrays.Labels, ranks);
  if (ranks.Rank() > 0)
  {
    return;
  }
  to << MakePrintable(arguments.Input) << "\n";
  PrintTimes(input, to);
  if (input.Volumes > 1)
  {
    to << input.Volumes << " volumes, selected by --volume, from 0; the values below are of volume "
       << arguments.Volume.value_or(0) << "\n";
  }
  PrintGrid(pieces, input.IsOne, isOfPoints, to);
  if (!cells.empty() || points.empty())
  {
    PrintArrays(cells, DescribeContents(cells, ArrayPlace::Cells, arguments), "cell array", to);
  }
  if (!points.empty())
  {
    PrintArrays(points, DescribeContents(points, ArrayPlace::Points, arguments), "point array", to);
  }
  PrintMaterials(arrays, labels, to);
  to << (arrays.Warning.empty() ? "" : arrays.Warning + "\n");
}

} // namespace vfm
