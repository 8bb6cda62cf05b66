#include "PlaceHostBoxes.h"

#include "Ranks/Agreement.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double PlaceTolerance = 1e-3;     // in cells
constexpr double MaximumCells = 2147483646; // per axis; nodes are counted by int
constexpr const char* AxisNames[3] = { "x", "y", "z" };

[[noreturn]] void Reject(const std::string& what, int axis, double value)
{
  std::ostringstream text;
  text << what << " along " << AxisNames[axis] << " (" << value << ").";
  throw InputError(text.str());
}

/// The grid of all boxes along an axis, in cells of level 0.
struct Axis
{
  double Origin, Spacing;
  Index Cells;
};

double WidthOf(const BoundedCells& box, int a)
{
  return (box.Upper[a] - box.Lower[a]) / box.Intervals[a];
}

/// Returns how accurately a box determines the width of cells of level 0. Boxes of coarser levels
/// rank first, then boxes with more cells.
double MeritOf(const BoundedCells& box, int a)
{
  return box.Intervals[a] - std::ldexp(box.Level, 31);
}

Axis FindAxis(const std::vector<BoundedCells>& mine, int a, Ranks& ranks)
{
  double lower = std::numeric_limits<double>::infinity(), upper = -lower, best = upper;
  for (const BoundedCells& box : mine)
  {
    lower = std::min(lower, box.Lower[a]);
    upper = std::max(upper, box.Upper[a]);
    best = std::max(best, MeritOf(box, a));
  }
  best = ranks.Max(best);
  double width = 0.0;
  for (const BoundedCells& box : mine)
  {
    if (MeritOf(box, a) == best)
    {
      width = std::max(width, std::ldexp(WidthOf(box, a), box.Level));
    }
  }
  lower = -ranks.Max(-lower);
  upper = ranks.Max(upper);
  const double cells = std::max(std::round((upper - lower) / ranks.Max(width)), 1.0);
  if (cells > MaximumCells)
  {
    Reject("The boxes of all ranks together have too many cells", a, cells);
  }
  return { lower, (upper - lower) / cells, static_cast<Index>(cells) };
}

/// Sets the range of cells of a box along an axis.
void PlaceAlong(const BoundedCells& box, int a, const Axis& axis, IndexBox& cells)
{
  const double spacing = std::ldexp(axis.Spacing, -box.Level);
  const double first = (box.Lower[a] - axis.Origin) / spacing;
  const double last = (box.Upper[a] - axis.Origin) / spacing;
  cells.Lower[a] = std::llround(first);
  cells.Upper[a] = std::llround(last);
  if (cells.Size(a) != box.Intervals[a])
  {
    Reject(box.Level == 0 ? "The cells of the ranks differ in size"
                          : "Cells of level " + std::to_string(box.Level) + " must be 1/" +
          std::to_string(Index(1) << box.Level) +
          " as wide as cells of level 0, an integer number of which must fill the grid; they are "
          "not",
      a, WidthOf(box, a));
  }
  if (std::abs(first - std::round(first)) > PlaceTolerance ||
    std::abs(last - std::round(last)) > PlaceTolerance)
  {
    Reject("A rank's box does not start and end on the grid of the others", a, box.Lower[a]);
  }
}

HostBox PlaceBox(const BoundedCells& cells, const std::array<Axis, 3>& axes)
{
  HostBox box{ {}, {}, cells.Level };
  for (int a = 0; a < 3; ++a)
  {
    PlaceAlong(cells, a, axes[a], box.Cells);
  }
  return box;
}

} // namespace

void CheckBoundedCells(const BoundedCells& cells)
{
  constexpr const char* intervals[3] = { "xint", "yint", "zint" };
  if (cells.Level < 0 || cells.Level > MaximumHostLevels)
  {
    throw InputError("The level of a block is " + std::to_string(cells.Level) +
      "; it must be 0, the coarsest, to " + std::to_string(MaximumHostLevels) + ".");
  }
  for (int a = 0; a < 3; ++a)
  {
    if (cells.Intervals[a] < 1)
    {
      throw InputError(std::string(intervals[a]) + " is " + std::to_string(cells.Intervals[a]) +
        ". A rank must have at least one cell along each axis.");
    }
    const double length = cells.Upper[a] - cells.Lower[a];
    if (!std::isfinite(length) || !(length > 0.0))
    {
      Reject("The bounding box has no finite length greater than 0", a, length);
    }
  }
}

HostGrid PlaceHostBoxes(const std::vector<BoundedCells>& mine, Ranks& ranks)
{
  HostGrid grid;
  grid.Boxes.resize(mine.size());
  std::array<Axis, 3> axes;
  for (int a = 0; a < 3; ++a)
  {
    axes[a] = FindAxis(mine, a, ranks);
    grid.Origin[a] = axes[a].Origin;
    grid.Spacing[a] = axes[a].Spacing;
    grid.Cells[a] = axes[a].Cells;
  }
  WorkTogether(ranks,
    [&]
    {
      for (std::size_t b = 0; b < mine.size(); ++b)
      {
        NameBlock(b, mine.size(), [&] { grid.Boxes[b] = PlaceBox(mine[b], axes); });
      }
    });
  return grid;
}

} // namespace vfm
