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

constexpr double MostCells = std::numeric_limits<int>::max() - 1.0; // along one axis
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
  return Centre(bounds, { { width, width, width } }, cells);
}

GridPlace PlaceCells(const PlaceBounds& bounds, Index cells)
{
  const GridPlace cube = PlaceCells(bounds, Index3{ { cells, cells, cells } });
  Index3 counts;
  for (int a = 0; a < 3; ++a)
  {
    counts[a] = std::min(
      cells, static_cast<Index>(CountCells(bounds.Upper[a] - bounds.Lower[a], cube.Widths[a])));
  }
  return Centre(bounds, cube.Widths, counts);
}

GridPlace PlaceCellsOfWidth(const PlaceBounds& bounds, const Vector3& widths)
{
  CheckExtent(bounds);
  Index3 counts;
  for (int a = 0; a < 3; ++a)
  {
    const double count = CountCells(bounds.Upper[a] - bounds.Lower[a], widths[a]);
    if (!(count <= MostCells))
    {
      throw InputError("Cells of width " + FormatNumber(widths[a]) +
        " are too many: the surfaces "
        "are " +
        FormatNumber(bounds.Upper[a] - bounds.Lower[a]) + " long.");
    }
    counts[a] = static_cast<Index>(count);
  }
  return Centre(bounds, widths, counts);
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
