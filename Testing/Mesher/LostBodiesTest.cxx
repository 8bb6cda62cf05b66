/// Thickness of bodies and lost parts of their surfaces, from the input to the messages.
#include "GivenSurfaces/LostSurface.h"

#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "Materials/MaterialTexts.h"
#include "Mesher.h"
#include "Phases/BodyFields.h"
#include "RankFields.h"
#include "SurfaceCases.h"
#include "Surfaces/SurfaceFractions.h"
#include "WideCases.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Body = MeshReport::Body;

/// A prism along y of the profile of a plate that stands on a block: an upside-down T.
ClosedSurface BlockWithFin(double thickness, double height, double depth)
{
  const double left = 10.0 - 0.5 * thickness, right = 10.0 + 0.5 * thickness;
  const double profile[8][2] = { { 0, 0 }, { 20, 0 }, { 20, 8 }, { right, 8 },
    { right, 8 + height }, { left, 8 + height }, { left, 8 }, { 0, 8 } };
  const int caps[6][3] = { { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 6 }, { 0, 6, 7 }, { 3, 4, 5 },
    { 3, 5, 6 } };
  ClosedSurface surface;
  for (double y : { 0.0, depth })
  {
    for (const auto& x : profile)
    {
      surface.Points.push_back(Vector3{ { x[0], y, x[1] } } + Vector3{ { 2.3, 2.4, 2.2 } });
    }
  }
  for (const auto& cap : caps)
  {
    surface.Triangles.push_back({ { cap[0], cap[1], cap[2] } });
    surface.Triangles.push_back({ { 8 + cap[0], 8 + cap[2], 8 + cap[1] } });
  }
  for (Index p = 0; p < 8; ++p)
  {
    const Index next = (p + 1) % 8;
    surface.Triangles.push_back({ { p, p + 8, next + 8 } });
    surface.Triangles.push_back({ { p, next + 8, next } });
  }
  return CloseSurface(surface.Points, surface.Triangles);
}

ClosedSurface Wedge(double length, double height, double depth)
{
  std::vector<Vector3> points;
  for (double y : { 0.0, depth })
  {
    points.push_back({ { 2.3, 2.4 + y, 2.2 } });
    points.push_back({ { 2.3 + length, 2.4 + y, 2.2 + 0.5 * height } });
    points.push_back({ { 2.3, 2.4 + y, 2.2 + height } });
  }
  return CloseSurface(points,
    { { { 0, 1, 2 } }, { { 3, 5, 4 } }, { { 0, 3, 4 } }, { { 0, 4, 1 } }, { { 1, 4, 5 } },
      { { 1, 5, 2 } }, { { 2, 5, 3 } }, { { 2, 3, 0 } } });
}

/// Returns the fractions of bodies in cells of width 1, in slabs along z per rank.
MesherInput MakeBodies(const std::vector<ClosedSurface>& bodies, const Index3& cells, Ranks& ranks)
{
  auto surfaces = std::make_shared<InputSurfaces>();
  for (const ClosedSurface& body : bodies)
  {
    surfaces->Bodies.push_back({ "body" + std::to_string(surfaces->Bodies.size() + 1), body,
      std::vector<int>(body.Triangles.size(), 0), { "" } });
  }
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= cells[a]; ++i)
    {
      coordinates[a].push_back(static_cast<double>(i));
    }
  }
  const IndexBox own{ { { 0, 0, ranks.Rank() * cells[2] / ranks.Count() } },
    { { cells[0], cells[1], (ranks.Rank() + 1) * cells[2] / ranks.Count() } } };
  Runtime runtime;
  std::vector<Buffer<double>> fractions = FractionsOfSurfaces(coordinates, own, *surfaces, runtime);
  auto arrays = std::make_shared<PlainArrays>(own.NumberOfCells());
  std::vector<std::string> names;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    names.push_back(surfaces->Bodies[b].Name);
    arrays->Store(names[b], ValueType::Double, std::move(fractions[b]));
  }
  MesherInput input = MakeInput({ MakeBlock(own, { { 0, 0, 0 } }, 1.0, arrays) }, ranks);
  input.Arrays.Fractions = names;
  input.Surfaces = surfaces;
  return input;
}

struct Outcome
{
  std::vector<Body> Bodies;
  std::vector<Index> Fragments; ///< of the bodies
  std::string Warnings;
  FieldArrays Materials;
};

Outcome MeshBodies(const std::vector<ClosedSurface>& bodies, const Index3& cells,
  const MesherOptions& options, Ranks& ranks)
{
  RankRuntime runtime(ranks);
  MesherInput input = MakeBodies(bodies, cells, ranks);
  Outcome outcome;
  input.Warn = [&](const std::string& text) { outcome.Warnings += text + "\n"; };
  MesherResult result = RunMesher(input, options, runtime);
  outcome.Bodies = result.Report.Bodies;
  outcome.Materials = result.MaterialFields;
  for (const Body& body : outcome.Bodies)
  {
    outcome.Fragments.push_back(result.Report.Materials[body.Material].Fragments);
  }
  return outcome;
}

Outcome MeshBodies(const std::vector<ClosedSurface>& bodies, const Index3& cells,
  ElementKind elements = ElementKind::Hexes, bool keepsThin = true)
{
  MesherOptions options;
  options.Elements = elements;
  options.ThinParts = keepsThin;
  Ranks alone;
  return MeshBodies(bodies, cells, options, alone);
}

constexpr const char* Loses = "loses parts that are thinner than its cells";

/// Expects a body whose surface is kept.
void ExpectKept(const Outcome& outcome, double thickness)
{
  ASSERT_FALSE(outcome.Bodies.empty());
  for (const Body& body : outcome.Bodies)
  {
    EXPECT_LT(body.LostShare, 3e-3);
    EXPECT_EQ(body.LostArea, 0.0);
    EXPECT_EQ(body.LostSolids, 0);
  }
  EXPECT_NEAR(outcome.Bodies[0].Thickness, thickness, 0.03 * thickness);
  EXPECT_EQ(outcome.Warnings.find(Loses), std::string::npos) << outcome.Warnings;
}

const ClosedSurface Cube = BoxSurface({ { 3.3, 3.4, 3.7 } }, { { 13.6, 13.9, 13.8 } });

TEST(MaterialTexts, NumbersAreShort)
{
  EXPECT_NEAR(RoundDown(0.12345), 0.123, 1e-12);
  EXPECT_EQ(RoundDown(98765.0), 98700.0);
  EXPECT_EQ(PercentOf(0.0456), "4.6 %");
  EXPECT_EQ(CountMaterials(2, "loses", "lose"), "2 materials lose");
}

TEST(LostBodies, ResolvedBodiesAreKept)
{
  const ClosedSurface sphere = SphereSurface({ { 11.2, 11.4, 11.7 } }, 8.3, 40);
  ExpectKept(MeshBodies({ sphere }, { { 24, 24, 24 } }), 16.6);
  ExpectKept(MeshBodies({ sphere }, { { 24, 24, 24 } }, ElementKind::Tets), 16.6);
  ExpectKept(MeshBodies({ Cube }, { { 18, 18, 18 } }), 10.1);
  ExpectKept(MeshBodies({ BlockWithFin(2.0, 10.0, 8.0) }, { { 26, 14, 24 } }), 2.0);
  // Only edges of the fin recede.
  ExpectKept(MeshBodies({ BlockWithFin(1.0, 10.0, 8.0) }, { { 26, 14, 24 } }), 1.0);
  ExpectKept(MeshBodies({ BoxSurface({ { 0, 0, 0 } }, { { 8, 8, 8 } }) }, { { 8, 8, 8 } }), 8.0);
}

TEST(LostBodies, PartsOutsideTheDomainOrInOtherBodiesAreNotLost)
{
  const Outcome half =
    MeshBodies({ SphereSurface({ { 0.2, 11.4, 11.7 } }, 8.3, 40) }, { { 12, 24, 24 } });
  ExpectKept(half, 16.6);
  EXPECT_FALSE(half.Bodies[0].IsWhole);
  // The first body cuts the second one in two.
  const Outcome cut = MeshBodies({ BoxSurface({ { 8, 0, 0 } }, { { 10, 13, 13 } }),
                                   BoxSurface({ { 2, 3, 3 } }, { { 16, 10, 10 } }) },
    { { 18, 13, 13 } });
  ExpectKept(cut, 2.0);
  EXPECT_EQ(cut.Fragments, (std::vector<Index>{ 1, 2 }));
}

TEST(LostBodies, SurfacesInsideTheBodyAreNotLost)
{
  const Outcome crossed =
    MeshBodies({ Together(Cube, BoxSurface({ { 6.2, 6.3, 5.4 } }, { { 9.3, 9.8, 19.6 } })) },
      { { 18, 18, 24 } });
  ExpectKept(crossed, 3.1);
  EXPECT_EQ(crossed.Bodies[0].Solids, 2);
  EXPECT_FALSE(crossed.Bodies[0].IsWhole);
}

TEST(LostBodies, EdgesOfWedgesMayRecede)
{
  const Outcome wedge = MeshBodies({ Wedge(20.0, 6.0, 12.0) }, { { 25, 17, 12 } });
  EXPECT_GT(wedge.Bodies[0].LostShare, 0.01);
  EXPECT_EQ(wedge.Bodies[0].LostArea, 0.0);
  EXPECT_EQ(wedge.Warnings.find(Loses), std::string::npos) << wedge.Warnings;
}

TEST(LostBodies, LargeShareIsNamed)
{
  const Outcome wedge = MeshBodies({ Wedge(20.0, 3.0, 12.0) }, { { 25, 17, 9 } });
  EXPECT_GT(wedge.Bodies[0].LostShare, 0.05);
  EXPECT_NE(wedge.Warnings.find(Loses), std::string::npos);
}

TEST(LostBodies, MastIsNamed)
{
  const ClosedSurface hull = BoxSurface({ { 2.2, 2.3, 2.4 } }, { { 22.2, 9.3, 8.0 } });
  const auto withMast = [&](double width)
  {
    return Together(
      hull, BoxSurface({ { 10.2, 4.3, 8.0 } }, { { 10.2 + width, 4.3 + width, 25.0 } }));
  };
  const Outcome lost = MeshBodies({ withMast(0.307) }, { { 25, 12, 28 } });
  ASSERT_EQ(lost.Bodies.size(), 1u);
  const Body& body = lost.Bodies[0];
  EXPECT_NEAR(body.LostArea, 19.6, 1.2);
  EXPECT_NEAR(body.LostLength, 16.0, 0.5);
  EXPECT_NEAR(body.LostThickness, 0.307, 1e-6);
  EXPECT_NEAR(body.LostPlace[0], 10.35, 0.2);
  EXPECT_NEAR(body.LostPlace[2], 17.0, 0.6);
  EXPECT_EQ(body.Solids, 2);
  EXPECT_NE(lost.Warnings.find(Loses), std::string::npos);
  EXPECT_NE(lost.Warnings.find("it is 0.307 thick. A cell width of 0.122 or less should keep"),
    std::string::npos)
    << lost.Warnings;
  EXPECT_NEAR(ValuesOf<std::vector<double>>(lost.Materials, "LostSurface")[0], body.LostShare, 0.0);
  ExpectKept(MeshBodies({ withMast(2.5) }, { { 25, 12, 28 } }), 2.5);
}

TEST(LostBodies, SolidsWithoutElementsAreCounted)
{
  const Outcome lost =
    MeshBodies({ Together(Cube, BoxSurface({ { 3.3, 3.3, 17.2 } }, { { 3.6, 3.6, 17.5 } })) },
      { { 18, 18, 20 } });
  ASSERT_EQ(lost.Bodies.size(), 1u);
  EXPECT_EQ(lost.Bodies[0].Solids, 2);
  EXPECT_EQ(lost.Bodies[0].LostSolids, 1);
  EXPECT_NE(lost.Warnings.find("1 of its 2 solids have no elements"), std::string::npos)
    << lost.Warnings;
}

TEST(LostBodies, TubeInPieces)
{
  const ClosedSurface tube = TubeSurface({ { 2.3, 9.4, 9.2 } }, 20.0, 6.0, 6.0 - 0.79, 64);
  const Outcome outcome = MeshBodies({ tube }, { { 25, 18, 18 } }, ElementKind::Hexes, false);
  ASSERT_EQ(outcome.Bodies.size(), 1u);
  EXPECT_EQ(outcome.Bodies[0].Solids, 1);
  ASSERT_GT(outcome.Fragments[0], 1);
  EXPECT_NE(outcome.Warnings.find("it has " + std::to_string(outcome.Fragments[0]) +
              " fragments instead of 1. A cell width of 0.315 or less should keep"),
    std::string::npos)
    << outcome.Warnings;
  EXPECT_NEAR(
    ValuesOf<std::vector<double>>(outcome.Materials, "SuggestedWidth")[0], 0.79 / 2.5, 0.002);
  EXPECT_EQ(ValuesOf<std::vector<Index>>(outcome.Materials, "Solids"), std::vector<Index>{ 1 });
}

TEST(LostBodies, EqualOnRanks)
{
  const ClosedSurface fin = BlockWithFin(0.2, 10.0, 8.0);
  const auto numbers = [](const Outcome& outcome)
  {
    std::vector<double> all;
    for (const Body& body : outcome.Bodies)
    {
      all.insert(all.end(),
        { body.Thickness, body.LostShare, double(body.Solids), double(body.LostSolids),
          double(body.IsWhole), body.LostArea, body.LostLength, body.LostThickness,
          body.LostPlace[0], body.LostPlace[1], body.LostPlace[2] });
    }
    return all;
  };
  MesherOptions options;
  options.ThinParts = false;
  Ranks alone;
  const Outcome expected = MeshBodies({ fin, Cube }, { { 26, 18, 24 } }, options, alone);
  EXPECT_GT(expected.Bodies[0].LostArea, 100.0);
  for (int count : { 2, 3, 8 })
  {
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const Outcome outcome = MeshBodies({ fin, Cube }, { { 26, 18, 24 } }, options, ranks);
        EXPECT_EQ(numbers(outcome), numbers(expected)) << count;
        EXPECT_EQ(outcome.Warnings, ranks.Rank() == 0 ? expected.Warnings : "");
      });
  }
}

} // namespace
