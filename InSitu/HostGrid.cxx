#include "HostGrid.h"

#include "Base/Runtime.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace vfm
{
namespace
{

constexpr const char* AxisNames[3] = { "x", "y", "z" };
constexpr Index EndOfInts = std::numeric_limits<int>::max(); // nodes too are counted by int

void CheckAxes(const HostGrid& grid)
{
  for (int a = 0; a < 3; ++a)
  {
    std::ostringstream text;
    if (!std::isfinite(grid.Origin[a]))
    {
      text << "The origin of the grid along " << AxisNames[a] << " is not finite.";
    }
    else if (!std::isfinite(grid.Spacing[a]) || !(grid.Spacing[a] > 0))
    {
      text << "The spacing of the grid along " << AxisNames[a] << " is " << grid.Spacing[a]
           << "; it must be finite and greater than 0.";
    }
    else if (grid.Cells[a] < 1 || grid.Cells[a] >= EndOfInts)
    {
      text << "The grid has " << grid.Cells[a] << " cells along " << AxisNames[a]
           << "; it must have at least 1 and fewer than " << EndOfInts << ".";
    }
    if (!text.str().empty())
    {
      throw InputError(text.str());
    }
  }
}

std::string NameBox(const HostBox& box)
{
  const IndexBox& cells = box.Cells;
  std::ostringstream text;
  text << "The box of cells [" << cells.Lower[0] << ", " << cells.Upper[0] << ") x ["
       << cells.Lower[1] << ", " << cells.Upper[1] << ") x [" << cells.Lower[2] << ", "
       << cells.Upper[2] << ")";
  if (box.Level != 0)
  {
    text << " of level " << box.Level;
  }
  return text.str();
}

void CheckArrays(const HostBox& box)
{
  const std::string name = NameBox(box);
  for (std::size_t i = 0; i < box.Arrays.size(); ++i)
  {
    const HostArray& array = box.Arrays[i];
    if (array.Name.empty())
    {
      throw InputError(name + " has an array without a name.");
    }
    if (!array.Values)
    {
      throw InputError(name + ": array '" + array.Name + "' has no values (null pointer).");
    }
    if (array.Components < 1)
    {
      throw InputError(name + ": array '" + array.Name + "' has " +
        std::to_string(array.Components) + " components; it must have at least 1.");
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if (box.Arrays[j].Name == array.Name)
      {
        throw InputError(name + " has two arrays named '" + array.Name + "'.");
      }
    }
  }
}

void CheckBox(const HostGrid& grid, const HostBox& box)
{
  if (box.Level < 0 || box.Level > MaximumHostLevels)
  {
    throw InputError(NameBox(box) + ": the level must be 0, the coarsest, to " +
      std::to_string(MaximumHostLevels) + ".");
  }
  for (int a = 0; a < 3; ++a)
  {
    const Index cells = grid.Cells[a] << box.Level;
    if (box.Cells.Size(a) < 1)
    {
      throw InputError(
        NameBox(box) + " is empty along " + AxisNames[a] + ". Leave out boxes without cells.");
    }
    if (box.Cells.Lower[a] < 0 || box.Cells.Upper[a] > cells)
    {
      throw InputError(NameBox(box) + " leaves the grid along " + AxisNames[a] + ", which has " +
        std::to_string(cells) + " cells there.");
    }
    if (box.Cells.Upper[a] >= EndOfInts)
    {
      throw InputError(NameBox(box) + " has cells with indices above " + std::to_string(EndOfInts) +
        " along " + AxisNames[a] + ". Use fewer levels.");
    }
  }
  CheckArrays(box);
}

} // namespace

void CheckHostGrid(const HostGrid& grid)
{
  CheckAxes(grid);
  for (const HostBox& box : grid.Boxes)
  {
    CheckBox(grid, box);
  }
}

Vector3 SpacingOf(const HostGrid& grid, int level)
{
  Vector3 spacing;
  for (int a = 0; a < 3; ++a)
  {
    spacing[a] = std::ldexp(grid.Spacing[a], -level);
  }
  return spacing;
}

} // namespace vfm
