/// Refinement that thin places of surfaces request, from cells to meshes on ranks.
#include "Levels/ThinPlaces.h"

#include "../GivenSurfaces/GivenCases.h"
#include "../SurfaceRuns.h"

#include <gtest/gtest.h>

#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

std::vector<ChosenBox> FindPlaces(const ClosedSurface& surface, Index cells, int most = 3)
{
  GivenCase c(cells, { surface });
  return FindThinPlaces(c.Surfaces, c.Grid, c.Fractions, 2.0, most, c.Run);
}

/// A block with a fin of 1.2 cells, oblique to the grid.
ClosedSurface BlockWithFin()
{
  const ClosedSurface block = BoxSurface({ { 4, 4, 4 } }, { { 14, 14, 9 } });
  const ClosedSurface fin = BoxSurface({ { 5, 8.4, 9.5 } }, { { 13, 9.6, 15 } });
  return Turned(Together(block, fin), { { 9, 9, 9 } }, { { 7, 5, 9 } });
}

MesherOptions Refined()
{
  MesherOptions options;
  options.Refinement = RefinementMode::Automatic;
  options.MaximumLevel = 1;
  options.FineInterfaces = false;
  return options;
}

Index CountElements(const SurfaceMesh& made)
{
  return static_cast<Index>(made.Merged.Elements.size());
}

} // namespace

TEST(ThinPlaces, ThickWallsRequestNothing)
{
  EXPECT_TRUE(FindPlaces(BoxSurface({ { 3, 3, 3 } }, { { 9, 9, 9 } }), 12).empty());
  EXPECT_TRUE(FindPlaces(BoxSurface({ { 3, 3, 3.1 } }, { { 9, 9, 5.0 } }), 12).empty());
}

TEST(ThinPlaces, WallsAndGapsRequestHalvings)
{
  for (const auto& [thickness, halvings] :
    { std::pair(1.5, Index(1)), std::pair(0.7, Index(2)), std::pair(0.2, Index(3)) })
  {
    const ClosedSurface plate =
      BoxSurface({ { 3.2, 3.2, 5.1 } }, { { 8.8, 8.8, 5.1 + thickness } });
    const ClosedSurface blocks = Together(BoxSurface({ { 3.2, 3.2, 2.2 } }, { { 8.8, 8.8, 5.1 } }),
      BoxSurface({ { 3.2, 3.2, 5.1 + thickness } }, { { 8.8, 8.8, 9.3 } }));
    for (const ClosedSurface& surface : { plate, blocks })
    {
      std::set<Index3> cells;
      for (const ChosenBox& place : FindPlaces(surface, 12))
      {
        EXPECT_EQ(place.Halvings, halvings);
        ForCells(place.Cells, [&](const Index3& p) { cells.insert(p); });
      }
      for (Index j = 3; j < 9; ++j)
      {
        for (Index i = 3; i < 9; ++i)
        {
          EXPECT_EQ(cells.count({ { i, j, 5 } }), 1u) << i << " " << j << " " << thickness;
        }
      }
    }
  }
}

TEST(ThinPlaces, TubeOfOneCellAndAHalf)
{
  const ClosedSurface tube = TubeSurface({ { 2.3, 8, 8 } }, 10.0, 5.0, 3.5, 48);
  std::set<Index3> cells;
  for (const ChosenBox& place : FindPlaces(tube, 16))
  {
    EXPECT_EQ(place.Halvings, 1);
    ForCells(place.Cells, [&](const Index3& p) { cells.insert(p); });
  }
  EXPECT_EQ(cells.count({ { 6, 8, 12 } }), 1u);
  EXPECT_EQ(cells.count({ { 6, 12, 8 } }), 1u);
  EXPECT_EQ(cells.count({ { 6, 8, 8 } }), 0u); // inside
}

TEST(ThinPlaces, MeshesAreEqualOnRanks)
{
  const SurfaceCase c{ { { 18, 18, 19 } }, MakeBodies({ BlockWithFin() }) };
  const SurfaceMesh alone = MeshSurfaces(c, Refined());
  MesherOptions coarse;
  const Index before = CountElements(MeshSurfaces(c, coarse));
  EXPECT_GT(CountElements(alone), before * 3 / 2);
  EXPECT_LT(CountElements(alone), before * 5);
  for (int ranks : { 2, 3 })
  {
    const SurfaceMesh made = MeshSurfaces(c, Refined(), ranks);
    EXPECT_EQ(FindGeometryDifference(made.Merged, alone.Merged), "") << ranks;
    EXPECT_EQ(CountDifferences(made.Merged.Points, alone.Merged.Points), 0u) << ranks;
    EXPECT_EQ(CountDifferences(made.Merged.Elements, alone.Merged.Elements), 0u) << ranks;
  }
}
