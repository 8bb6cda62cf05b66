#include "Levels/ThinPlaces.h"

#include "Surfaces/SurfaceThickness.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr double SamplesPerFace = 4.0; // of a cell: half a cell apart
constexpr double DepthOfCell = 1e-3;   // of the points below and above a sample, in cells

/// Sample with the cells below and above the surface.
struct PlacedSample
{
  SurfaceSample Sample;
  std::array<Index3, 2> Cells;
};

/// Returns the samples of a body at cells of this rank.
std::vector<PlacedSample> PlaceSamples(
  const GivenBody& body, const CartesianGrid& grid, const FractionField& fractions)
{
  const Vector3 origin = grid.NodePoint({ { 0, 0, 0 } });
  std::vector<PlacedSample> placed;
  for (const SurfaceSample& sample : SampleSurface(body.Boundary, FindComponents(body.Boundary),
         static_cast<int>(SamplesPerFace * MeasureArea(body.Boundary)) + 1))
  {
    const auto cellAt = [&](double height)
    { return grid.CellAt(origin + grid.MeanWidth() * (sample.Point + height * sample.Normal)); };
    const std::array<Index3, 2> cells{ { cellAt(-DepthOfCell), cellAt(DepthOfCell) } };
    const bool isHere = grid.Owned().Contains(cells[0]) || grid.Owned().Contains(cells[1]);
    if (isHere && grid.Local().Contains(cells[0]) &&
      fractions.Fraction(grid.Linear(cells[0]), body.Material) > 0.0)
    {
      placed.push_back({ sample, cells });
    }
  }
  return placed;
}

} // namespace

std::vector<ChosenBox> FindThinPlaces(const BodySurfaces& bodies, const CartesianGrid& grid,
  const FractionField& fractions, double thinCells, int most, Runtime& runtime)
{
  std::vector<ChosenBox> places;
  for (const GivenBody& body : bodies.Bodies())
  {
    const std::vector<PlacedSample> placed = PlaceSamples(body, grid, fractions);
    std::vector<SurfaceSample> samples;
    for (const PlacedSample& sample : placed)
    {
      samples.push_back(sample.Sample);
    }
    const TriangleSearch search(PlaceTriangles(body.Boundary), runtime);
    for (BallSide side : { BallSide::Inner, BallSide::Outer })
    {
      const std::vector<double> thickness =
        MeasureThicknessTo(thinCells, samples, search, side, runtime);
      for (std::size_t s = 0; s < placed.size(); ++s)
      {
        const int halvings = HalvingsFor(thinCells / thickness[s], most);
        for (const Index3& cell : placed[s].Cells)
        {
          if (halvings > 0 && grid.Owned().Contains(cell))
          {
            places.push_back({ BoxOfCell(cell), halvings });
          }
        }
      }
    }
  }
  return places;
}

} // namespace vfm
