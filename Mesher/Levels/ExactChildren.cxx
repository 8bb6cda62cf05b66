#include "Levels/ExactChildren.h"

#include "Elements/GridCoordinates.h"
#include "Fractions/RefineCells.h"
#include "Surfaces/RowSums.h"
#include "Surfaces/SurfaceFractions.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

constexpr double LargestRounding = 1e-7;       // of a fraction, if the input has floats
constexpr Index LargestArray = Index(1) << 23; // values of all bodies that are computed together

/// Fractions of all bodies in a box of half cells.
struct HalfCells
{
  IndexBox Box;
  std::vector<Buffer<double>> Fractions; ///< of each body

  /// Returns the fractions of a body in the halves of a cell; of void for -1.
  std::vector<double> Find(const Index3& cell, int body) const
  {
    std::vector<double> halves;
    for (int c = 0; c < 8; ++c)
    {
      const Index half = IndexInBox(this->Box, ChildOfCell(cell, c));
      double all = 0.0;
      for (const Buffer<double>& values : this->Fractions)
      {
        all += values[half];
      }
      halves.push_back(body < 0 ? Snapped(1.0 - all) : this->Fractions[body][half]);
    }
    return halves;
  }
};

double MeanOf(const std::vector<double>& halves)
{
  double sum = 0.0;
  for (double fraction : halves)
  {
    sum += 0.125 * fraction;
  }
  return sum;
}

/// Returns the fractions of the parts of a cell in its halves; nothing if their means differ from
/// the fractions, or if the bodies have other parts there.
std::vector<std::vector<double>> FindHalves(const HalfCells& exact, const BodySurfaces& bodies,
  const Index3& cell, FractionField::Range parts)
{
  std::vector<std::vector<double>> halves;
  for (int body = -1; body < static_cast<int>(exact.Fractions.size()); ++body)
  {
    const int material = body < 0 ? 0 : bodies.Bodies()[body].Material;
    const double given = FractionField::FractionOf(parts, material);
    const double mean = MeanOf(exact.Find(cell, body));
    if (std::fabs(mean - given) > LargestRounding || (given == 0.0 && mean > 0.0))
    {
      return {};
    }
  }
  for (const FractionField::Part& part : parts)
  {
    halves.push_back(exact.Find(cell, part.Material == 0 ? -1 : bodies.Find(part.Material)));
  }
  return halves;
}

/// Returns the mixed cells whose materials all have bodies.
std::vector<Index> FindCellsOfBodies(
  const BodySurfaces& bodies, const CartesianGrid& grid, const FractionField& fractions)
{
  std::vector<Index> cells;
  ForCells(grid.Extended(GhostLayers / 2),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      if (fractions.IsMixed(cell))
      {
        const FractionField::Range parts = fractions.Parts(cell);
        if (std::all_of(parts.begin(), parts.end(),
              [&](const FractionField::Part& part)
              { return part.Material == 0 || bodies.Find(part.Material) >= 0; }))
        {
          cells.push_back(cell);
        }
      }
    });
  return cells;
}

/// Returns the smallest box of some cells.
IndexBox BoxAround(const CartesianGrid& grid, const std::vector<Index>& cells)
{
  IndexBox box = BoxOfCell(grid.Position(cells[0]));
  for (Index cell : cells)
  {
    const Index3 p = grid.Position(cell);
    for (int a = 0; a < 3; ++a)
    {
      box.Lower[a] = std::min(box.Lower[a], p[a]);
      box.Upper[a] = std::max(box.Upper[a], p[a] + 1);
    }
  }
  return box;
}

} // namespace

ExactChildren::ExactChildren(const BodySurfaces& bodies, const CartesianGrid& unit,
  const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime) :
  Grid(grid)
{
  const std::vector<Index> cells = FindCellsOfBodies(bodies, grid, fractions);
  if (cells.empty())
  {
    return;
  }
  const std::array<std::vector<double>, 3> nodes = ToGrid(unit, HalveWidths(grid.Coordinates()));
  const IndexBox box = BoxAround(grid, cells);
  const Index ofLayer = 8 * box.Size(0) * box.Size(1) * static_cast<Index>(bodies.Bodies().size());
  const Index layers = std::max<Index>(1, LargestArray / ofLayer);
  for (auto first = cells.begin(); first != cells.end();)
  {
    const Index end = grid.Position(*first)[2] + layers;
    const auto last =
      std::find_if(first, cells.end(), [&](Index cell) { return grid.Position(cell)[2] >= end; });
    this->AddLayers(nodes, bodies, fractions, { first, last }, runtime);
    first = last;
  }
}

void ExactChildren::AddLayers(const std::array<std::vector<double>, 3>& nodes,
  const BodySurfaces& bodies, const FractionField& fractions, const std::vector<Index>& cells,
  Runtime& runtime)
{
  HalfCells exact{ ChangeLevel(BoxAround(this->Grid, cells), 1), {} };
  std::vector<const ClosedSurface*> boundaries;
  for (const GivenBody& body : bodies.Bodies())
  {
    boundaries.push_back(&body.Boundary);
  }
  exact.Fractions = FractionsOfSurfaces(nodes, exact.Box, boundaries, runtime);
  std::vector<std::vector<std::vector<double>>> halves(cells.size());
  ForEach(runtime, cells.size(),
    [&](Index i)
    {
      halves[i] =
        FindHalves(exact, bodies, this->Grid.Position(cells[i]), fractions.Parts(cells[i]));
    });
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (!halves[i].empty())
    {
      this->Cells.push_back(cells[i]);
      this->Halves.push_back(std::move(halves[i]));
    }
  }
}

std::vector<std::vector<double>> ExactChildren::Find(const Index3& cell) const
{
  const Index number = this->Grid.Linear(cell);
  const auto found = std::lower_bound(this->Cells.begin(), this->Cells.end(), number);
  return found != this->Cells.end() && *found == number ? this->Halves[found - this->Cells.begin()]
                                                        : std::vector<std::vector<double>>();
}

} // namespace vfm
