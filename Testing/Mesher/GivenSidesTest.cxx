/// Sides of interfaces from the surfaces of bodies.
#include "Geometry/GivenSides.h"

#include "Geometry/DivideInterfaces.h"
#include "Geometry/FacetValues.h"
#include "PartCases.h"
#include "SurfaceRuns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Method
{
  const char* Name;
  ElementKind Elements;
  TetMethod Tets;
};

constexpr Method Methods[] = { { "Hexes", ElementKind::Hexes, TetMethod::Lattice },
  { "Lattice", ElementKind::Tets, TetMethod::Lattice },
  { "Cells", ElementKind::Tets, TetMethod::Cells } };

MesherOptions OptionsOf(const Method& method)
{
  MesherOptions options;
  options.Elements = method.Elements;
  options.Method = method.Tets;
  return options;
}

SurfaceCase MakeBracket()
{
  return { { { 24, 24, 20 } },
    { { Turned(BracketBody("bracket", 14.3, 4.2, 9.1), { { 9.7, 5.2, 2.3 } }) } } };
}

SurfaceCase MakePlate()
{
  return { { { 28, 28, 20 } },
    { { Turned(PlateBody("plate", 2, 2, 9.0, 2.5, 3.6, 48), { { 12.3, 4.1, 2.6 } }) } } };
}

/// Returns the areas of named surfaces; those of one name are added.
std::map<std::string, double> AreasByName(const GeometryTables& tables)
{
  std::map<std::string, double> areas;
  for (std::size_t s = 0; s < tables.PatchNames.size(); ++s)
  {
    areas[tables.PatchNames[s]] += tables.SurfaceAreas[s];
  }
  return areas;
}

/// Expects a surface per patch.
/// @return largest relative error of the area of a patch
double ExpectPatches(const SurfaceCase& c, const SurfaceMesh& made)
{
  const BodySurface& body = c.Surfaces.Bodies[0];
  const GeometryTables& tables = made.Merged.Tables;
  EXPECT_EQ(tables.SurfaceAreas.size(), body.PatchNames.size());
  std::map<std::string, double> areas = AreasByName(tables);
  const std::vector<double> exact = AreasOfPatches(body);
  double largest = 0.0;
  for (std::size_t p = 0; p < exact.size(); ++p)
  {
    const double error = areas[body.PatchNames[p]] / exact[p] - 1.0;
    if (std::getenv("VFM_PRINT"))
    {
      std::printf("%-10s %8.3f %8.4f\n", body.PatchNames[p].c_str(), exact[p], error);
    }
    largest = std::max(largest, std::fabs(error));
  }
  return largest;
}

class GivenSides : public ::testing::TestWithParam<Method>
{
};

TEST_P(GivenSides, OfABracket)
{
  const SurfaceCase c = MakeBracket();
  EXPECT_LT(ExpectPatches(c, MeshSurfaces(c, OptionsOf(GetParam()))), 0.02);
}

TEST_P(GivenSides, OfAPlateWithHoles)
{
  const SurfaceCase c = MakePlate();
  EXPECT_LT(ExpectPatches(c, MeshSurfaces(c, OptionsOf(GetParam()))), 0.3);
}

TEST_P(GivenSides, OfASlice)
{
  const SurfaceCase c{ { { 28, 28, 20 } },
    { { Turned(SliceBody("slice", 13.0, 7.0, 60), { { 12.3, 6.1, 2.6 } }) } } };
  EXPECT_LT(ExpectPatches(c, MeshSurfaces(c, OptionsOf(GetParam()))), 0.02);
}

TEST_P(GivenSides, AreEqualOnRanks)
{
  for (const SurfaceCase& c : { MakeBracket(), MakePlate() })
  {
    const SurfaceMesh alone = MeshSurfaces(c, OptionsOf(GetParam()));
    for (int ranks : { 2, 3, 8 })
    {
      const SurfaceMesh made = MeshSurfaces(c, OptionsOf(GetParam()), ranks);
      EXPECT_EQ(FindGeometryDifference(made.Merged, alone.Merged), "") << ranks;
      EXPECT_EQ(made.Merged.Tables.PatchNames, alone.Merged.Tables.PatchNames);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, GivenSides, ::testing::ValuesIn(Methods),
  [](const ::testing::TestParamInfo<Method>& info) { return info.param.Name; });

} // namespace
