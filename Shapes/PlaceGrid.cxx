#include "Shapes/PlaceGrid.h"

#include "Base/ParseText.h"
#include "Base/Vector3.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfm
{
namespace
{

constexpr double MostCells = 1e7;          // along one axis: each rank has the nodes of all axes
constexpr double MostCellsInAll = 1e12;    // whose numbers times those of levels are in 64 bits
constexpr double RoundingTolerance = 1e-9; // of a number of cells that need not be rounded up

void CheckExtent(const PlaceBounds& bounds)
{
  double most = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const double extent = bounds.Upper[a] - bounds.Lower[a];
    most = extent >= 0.0 ? std::max(most, extent) : std::numeric_limits<double>::infinity();
  }
  if (!(most > 0.0 && std::isfinite(most)))
  {
    throw InputError("The surfaces have no extent, or points that are not finite.");
  }
}

/// Returns how many cells an extent needs, with the margin.
double CountCells(double extent, double width)
{
  return std::ceil(extent / width * (1.0 - RoundingTolerance)) + 2 * PlaceMargin;
}

void CheckCells(const Vector3& counts)
{
  if (!(std::max({ counts[0], counts[1], counts[2] }) <= MostCells &&
        counts[0] * counts[1] * counts[2] <= MostCellsInAll))
  {
    throw InputError("A grid of " + FormatNumber(counts[0]) + " x " + FormatNumber(counts[1]) +
      " x " + FormatNumber(counts[2]) +
      " cells around the surfaces is too large: at most 1e7 cells along an axis and 1e12 in all "
      "are possible. Use fewer or wider cells.");
  }
}

/// Returns the width of cubic cells.
double FindWidth(const PlaceBounds& bounds, const Index3& cells)
{
  CheckExtent(bounds);
  double width = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    if (cells[a] < LeastPlacedCells)
    {
      throw InputError("A grid around surfaces needs at least " + std::to_string(LeastPlacedCells) +
        " cells along every axis.");
    }
    width = std::max(
      width, (bounds.Upper[a] - bounds.Lower[a]) / static_cast<double>(cells[a] - 2 * PlaceMargin));
  }
  return width;
}

Index3 ToCells(const Vector3& counts)
{
  CheckCells(counts);
  return { { static_cast<Index>(counts[0]), static_cast<Index>(counts[1]),
    static_cast<Index>(counts[2]) } };
}

/// Places the centre of the cells at that of the bounds.
GridPlace Centre(const PlaceBounds& bounds, const Vector3& widths, const Index3& cells)
{
  GridPlace place{ {}, widths, cells };
  for (int a = 0; a < 3; ++a)
  {
    place.Origin[a] =
      0.5 * (bounds.Lower[a] + bounds.Upper[a]) - 0.5 * widths[a] * static_cast<double>(cells[a]);
  }
  return place;
}

} // namespace

PlaceBounds FindBounds(const InputSurfaces& surfaces)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  PlaceBounds bounds{ { { Infinity, Infinity, Infinity } },
    { { -Infinity, -Infinity, -Infinity } } };
  for (const BodySurface& body : surfaces.Bodies)
  {
    for (const PointTriangle& triangle : body.Boundary.Triangles)
    {
      for (Index p : triangle)
      {
        for (int a = 0; a < 3; ++a)
        {
          bounds.Lower[a] = std::min(bounds.Lower[a], body.Boundary.Points[p][a]);
          bounds.Upper[a] = std::max(bounds.Upper[a], body.Boundary.Points[p][a]);
        }
      }
    }
  }
  if (bounds.Lower[0] > bounds.Upper[0])
  {
    throw InputError("There is no surface with triangles.");
  }
  return bounds;
}

GridPlace PlaceCells(const PlaceBounds& bounds, const Index3& cells)
{
  const double width = FindWidth(bounds, cells);
  CheckCells({ { static_cast<double>(cells[0]), static_cast<double>(cells[1]),
    static_cast<double>(cells[2]) } });
  return Centre(bounds, { { width, width, width } }, cells);
}

GridPlace PlaceCells(const PlaceBounds& bounds, Index cells)
{
  const double width = FindWidth(bounds, { { cells, cells, cells } });
  Vector3 counts;
  for (int a = 0; a < 3; ++a)
  {
    counts[a] =
      std::min(static_cast<double>(cells), CountCells(bounds.Upper[a] - bounds.Lower[a], width));
  }
  return Centre(bounds, { { width, width, width } }, ToCells(counts));
}

GridPlace PlaceCellsOfWidth(const PlaceBounds& bounds, const Vector3& widths)
{
  CheckExtent(bounds);
  Vector3 counts;
  for (int a = 0; a < 3; ++a)
  {
    counts[a] = CountCells(bounds.Upper[a] - bounds.Lower[a], widths[a]);
  }
  return Centre(bounds, widths, ToCells(counts));
}

std::array<std::vector<double>, 3> ListNodes(const GridPlace& place)
{
  std::array<std::vector<double>, 3> nodes;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= place.Cells[a]; ++i)
    {
      nodes[a].push_back(place.Origin[a] + static_cast<double>(i) * place.Widths[a]);
    }
  }
  return nodes;
}

} // namespace vfm
