/// When the surfaces of the input are used.
#include "Phases/PlaceSurfaces.h"

#include "../GivenSurfaces/GivenCases.h"
#include "../SurfaceRuns.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns the number of bodies that a run uses, and sets the warnings.
std::size_t CountBodies(
  MesherInput input, const MesherOptions& options, std::string* warnings = nullptr)
{
  Runtime runtime;
  input.Warn = [&](const std::string& text)
  {
    if (warnings)
    {
      *warnings += text;
    }
  };
  const MesherJob job{ input, options, runtime };
  const std::unique_ptr<Cells> cells = ReadCells(job);
  MatchSurfaces(job, *cells);
  const std::unique_ptr<const BodySurfaces> bodies = PlaceSurfaces(job, *cells);
  return bodies ? bodies->Bodies().size() : 0;
}

const SurfaceCase TwoBoxes{ { { 12, 12, 12 } },
  MakeBodies({ BoxSurface({ { 3, 3, 3 } }, { { 9, 9, 7.4 } }),
    BoxSurface({ { 3, 3, 7.4 } }, { { 9, 9, 10 } }) }) };

} // namespace

TEST(PlaceSurfaces, OnlyIfTheyAreThereAndUsed)
{
  Runtime runtime;
  MesherInput input = MakeSurfaceInput(TwoBoxes, runtime.Group());
  MesherOptions on, off;
  off.UseSurfaces = false;
  EXPECT_EQ(CountBodies(input, on), 2u);
  EXPECT_EQ(CountBodies(input, off), 0u);
  input.Surfaces = nullptr;
  EXPECT_EQ(CountBodies(input, on), 0u);
}

TEST(PlaceSurfaces, OthersThanThoseOfTheFractionsAreNamed)
{
  Runtime runtime;
  MesherInput input = MakeSurfaceInput(TwoBoxes, runtime.Group());
  auto moved = std::make_shared<InputSurfaces>(*input.Surfaces);
  for (Vector3& point : moved->Bodies[1].Boundary.Points)
  {
    point[1] += 0.5;
  }
  input.Surfaces = moved;
  std::string warnings;
  EXPECT_EQ(CountBodies(input, MesherOptions(), &warnings), 1u);
  EXPECT_NE(
    warnings.find("The fractions are not those of the surfaces of 2, which"), std::string::npos)
    << warnings;
}
