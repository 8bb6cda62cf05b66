#include "GivenSurfaces/SurfaceMatch.h"

#include "Elements/GridCoordinates.h"
#include "Surfaces/SurfaceFractions.h"

#include <cmath>

namespace vfm
{
namespace
{

constexpr Index MostLayers = 16;
constexpr double LargestDifference = 0.1;
constexpr double Scale = 0x1p30; // of sums that are equal for any ranks

/// Sums over the compared cells of one body.
struct BodySums
{
  std::int64_t Cut = 0;        ///< cells that its surface cuts
  std::int64_t Difference = 0; ///< of the fractions in them, in 1 / Scale
  std::int64_t Mixed = 0;      ///< cells with its material and others
};

/// Returns the layers to compare: all or MostLayers of the domain, evenly spread.
std::vector<Index> ChooseLayers(const IndexBox& domain)
{
  const Index size = domain.Size(2), count = std::min(size, MostLayers);
  std::vector<Index> layers;
  for (Index i = 0; i < count; ++i)
  {
    layers.push_back(domain.Lower[2] + (2 * i + 1) * size / (2 * count));
  }
  return layers;
}

void AddCell(double exact, double given, BodySums& sums)
{
  if (exact > 0.0 && exact < 1.0)
  {
    ++sums.Cut;
    sums.Difference += std::llround(Scale * std::fabs(exact - given));
  }
  sums.Mixed += given > 0.0 && given < 1.0;
}

} // namespace

std::vector<bool> FindMatches(const BodySurfaces& bodies, const CartesianGrid& grid,
  const FractionField& fractions, Runtime& runtime)
{
  std::vector<const ClosedSurface*> surfaces;
  for (const GivenBody& body : bodies.Bodies())
  {
    surfaces.push_back(&body.Boundary);
  }
  const std::array<std::vector<double>, 3> nodes = ToGrid(grid, grid.Coordinates());
  std::vector<BodySums> sums(surfaces.size());
  IndexBox box = grid.Owned();
  for (Index layer : ChooseLayers(grid.Domain()))
  {
    box.Lower[2] = layer;
    box.Upper[2] = layer + (layer >= grid.Owned().Lower[2] && layer < grid.Owned().Upper[2]);
    const std::vector<Buffer<double>> exact = FractionsOfSurfaces(nodes, box, surfaces, runtime);
    Index n = 0;
    ForCells(box,
      [&](const Index3& cell)
      {
        for (std::size_t b = 0; b < sums.size(); ++b)
        {
          AddCell(exact[b][n], fractions.Fraction(grid.Linear(cell), bodies.Bodies()[b].Material),
            sums[b]);
        }
        ++n;
      });
  }
  std::vector<std::int64_t> all;
  for (const BodySums& each : sums)
  {
    all.insert(all.end(), { each.Cut, each.Difference, each.Mixed });
  }
  runtime.Group().Sum(all);
  std::vector<bool> matches;
  for (std::size_t b = 0; b < sums.size(); ++b)
  {
    const double cut = static_cast<double>(all[3 * b]);
    const double difference = static_cast<double>(all[3 * b + 1]) / Scale;
    matches.push_back(cut > 0.0 ? difference <= LargestDifference * cut : all[3 * b + 2] == 0);
  }
  return matches;
}

} // namespace vfm
