#include "PlaceHostBox.h"

#include "Agreement.h"
#include "Base/Runtime.h"

#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double PlaceTolerance = 1e-3;  // of a cell
constexpr double MostCells = 2147483646; // along an axis, as VTK counts them
constexpr const char* AxisNames[3] = { "x", "y", "z" };

[[noreturn]] void Refuse(const std::string& what, int axis, double value)
{
  std::ostringstream text;
  text << what << " along " << AxisNames[axis] << " (" << value << ").";
  throw InputError(text.str());
}

/// The grid of all boxes along an axis.
struct Axis
{
  double Origin, Spacing;
  Index Cells;
};

Axis FindAxis(const BoundedCells& mine, int a, Ranks& ranks)
{
  const double lower = -ranks.Max(-mine.Lower[a]), upper = ranks.Max(mine.Upper[a]);
  const double width = ranks.Max((mine.Upper[a] - mine.Lower[a]) / mine.Intervals[a]);
  const double cells = std::round((upper - lower) / width);
  if (cells > MostCells)
  {
    Refuse("The boxes of all ranks together have too many cells", a, cells);
  }
  return { lower, (upper - lower) / cells, static_cast<Index>(cells) };
}

/// The cells of a box along an axis.
void PlaceBox(const BoundedCells& mine, int a, const Axis& axis, IndexBox& box)
{
  const double first = (mine.Lower[a] - axis.Origin) / axis.Spacing;
  const double last = (mine.Upper[a] - axis.Origin) / axis.Spacing;
  box.Lower[a] = std::llround(first);
  box.Upper[a] = std::llround(last);
  if (box.Size(a) != mine.Intervals[a])
  {
    Refuse("The cells of the ranks differ in size", a,
      (mine.Upper[a] - mine.Lower[a]) / mine.Intervals[a]);
  }
  if (std::abs(first - std::round(first)) > PlaceTolerance ||
    std::abs(last - std::round(last)) > PlaceTolerance)
  {
    Refuse("A rank's box does not start and end on the grid of the others", a, mine.Lower[a]);
  }
}

} // namespace

void CheckBoundedCells(const BoundedCells& cells)
{
  constexpr const char* intervals[3] = { "xint", "yint", "zint" };
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
      Refuse("The bounding box has no finite length greater than 0", a, length);
    }
  }
}

HostGrid PlaceHostBox(const BoundedCells& mine, Ranks& ranks)
{
  HostGrid grid;
  grid.Boxes.resize(1);
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
      for (int a = 0; a < 3; ++a)
      {
        PlaceBox(mine, a, axes[a], grid.Boxes[0].Cells);
      }
    });
  return grid;
}

} // namespace vfm
