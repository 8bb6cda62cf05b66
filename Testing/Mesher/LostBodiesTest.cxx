/// Thickness of bodies and lost parts of their surfaces, from the input to the messages.
#include "GivenSurfaces/LostSurface.h"

#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "Mesher.h"
#include "RankFields.h"
#include "Report/BodyFields.h"
#include "Report/MaterialTexts.h"
#include "Shapes/ShapesTriangles.h"
#include "SurfaceCases.h"
#include "WideCases.h"

#include <gtest/gtest.h>

#include <mutex>

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

/// Returns the fractions of bodies; where they overlap, later bodies give way. Bodies may overlap
/// only in whole cells.
MesherInput MakeBodies(const std::vector<ClosedSurface>& bodies, const Index3& cells, Ranks& ranks)
{
  const IndexBox own{ { { 0, 0, ranks.Rank() * cells[2] / ranks.Count() } },
    { { cells[0], cells[1], (ranks.Rank() + 1) * cells[2] / ranks.Count() } } };
  auto arrays = std::make_shared<PlainArrays>(own.NumberOfCells());
  auto surfaces = std::make_shared<InputSurfaces>();
  std::vector<double> left(own.NumberOfCells(), 1.0);
  std::vector<std::string> names;
  for (const ClosedSurface& body : bodies)
  {
    const TriangleSolid solid(PlaceTriangles(body));
    std::vector<double> fractions;
    ForCells(own,
      [&](const Index3& cell)
      {
        const Vector3 lower{ { double(cell[0]), double(cell[1]), double(cell[2]) } };
        const Vector3 upper = lower + Vector3{ { 1, 1, 1 } };
        double& rest = left[fractions.size()];
        const double volume = solid.MeasureVolume(lower, upper);
        fractions.push_back(std::min(rest, std::max(0.0, volume < 1e-9 ? 0.0 : volume)));
        rest -= fractions.back();
      });
    names.push_back("body" + std::to_string(names.size() + 1));
    arrays->Store(names.back(), ValueType::Double, std::move(fractions));
    surfaces->Bodies.push_back(
      { names.back(), body, std::vector<int>(body.Triangles.size(), 0), { "" } });
  }
  MesherInput input = MakeInput({ MakeBlock(own, { { 0, 0, 0 } }, 1.0, arrays) }, ranks);
  input.Arrays.Fractions = names;
  input.Surfaces = surfaces;
  return input;
}

struct Outcome
{
  std::vector<Body> Bodies;
  std::string Warnings;
  FieldArrays Materials;
};

Outcome MeshBodies(const std::vector<ClosedSurface>& bodies, const Index3& cells,
  bool keepsThin = true, ElementKind elements = ElementKind::Hexes)
{
  Runtime runtime;
  MesherInput input = MakeBodies(bodies, cells, runtime.Group());
  Outcome outcome;
  input.Warn = [&](const std::string& text) { outcome.Warnings += text + "\n"; };
  MesherOptions options;
  options.ThinParts = keepsThin;
  options.Elements = elements;
  MesherResult result = RunMesher(input, options, runtime);
  outcome.Bodies = result.Report.Bodies;
  outcome.Materials = result.MaterialFields;
  for (const Body& body : outcome.Bodies)
  {
    std::printf("t %.3g lost %.4g solids %d/%d whole %d part: area %.3g length %.3g t %.3g fragments %d\n",
      body.Thickness, body.LostShare, int(body.LostSolids), int(body.Solids), body.IsWhole,
      body.LostArea, body.LostLength, body.LostThickness,
      int(result.Report.Materials[body.Material].Fragments));
  }
  std::printf("%s", outcome.Warnings.c_str());
  return outcome;
}

TEST(LostBodies, Explore)
{
  const Vector3 at{ { 11.2, 11.4, 11.7 } };
  puts("sphere");
  MeshBodies({ SphereSurface(at, 8.3, 40) }, { { 24, 24, 24 } });
  MeshBodies({ SphereSurface(at, 8.3, 40) }, { { 24, 24, 24 } }, true, ElementKind::Tets);
  puts("cube");
  MeshBodies({ BoxSurface({ { 3.3, 3.4, 3.7 } }, { { 13.6, 13.9, 13.8 } }) }, { { 18, 18, 18 } });
  puts("cube aligned, full domain");
  MeshBodies({ BoxSurface({ { 0, 0, 0 } }, { { 10, 10, 10 } }) }, { { 10, 10, 10 } });
  puts("plate 1.6");
  MeshBodies({ BoxSurface({ { 3.3, 3.4, 3.7 } }, { { 13.6, 13.9, 5.3 } }) }, { { 18, 18, 10 } });
  puts("sphere at side");
  MeshBodies({ SphereSurface({ { 0.2, 11.4, 11.7 } }, 8.3, 40) }, { { 12, 24, 24 } });
  for (double thickness : { 0.2, 0.5, 1.0, 2.0 })
  {
    printf("fin %g\n", thickness);
    MeshBodies({ BlockWithFin(thickness, 10, 8) }, { { 26, 14, 24 } });
    MeshBodies({ BlockWithFin(thickness, 10, 8) }, { { 26, 14, 24 } }, false);
  }
  puts("fin small depth");
  MeshBodies({ BlockWithFin(0.3, 15, 0.3) }, { { 26, 8, 30 } });
  puts("mast");
  MeshBodies({ Together(BoxSurface({ { 2.2, 2.3, 2.4 } }, { { 22.2, 9.3, 8 } }),
               BoxSurface({ { 10.2, 4.3, 8 } }, { { 10.5, 4.6, 25 } })) },
    { { 25, 12, 28 } });
  for (double height : { 3.0, 6.0, 10.0 })
  {
    printf("wedge %g\n", height);
    MeshBodies({ Wedge(20, height, 12) }, { { 25, 17, 15 } });
  }
  puts("tube");
  MeshBodies({ TubeSurface({ { 2.3, 9.4, 9.2 } }, 20, 6, 6 - 0.79, 64) }, { { 25, 18, 18 } });
  MeshBodies({ TubeSurface({ { 2.3, 9.4, 9.2 } }, 20, 6, 6 - 0.79, 64) }, { { 25, 18, 18 } }, false);
  MeshBodies({ TubeSurface({ { 2.3, 9.4, 9.2 } }, 20, 6, 6 - 0.6, 64) }, { { 25, 18, 18 } }, false);
  puts("two overlapping");
  MeshBodies({ BoxSurface({ { 3, 3, 3 } }, { { 9, 9, 9 } }), BoxSurface({ { 6, 2, 2 } }, { { 15, 10, 10 } }) },
    { { 18, 13, 13 } });
  puts("cut in two");
  MeshBodies({ BoxSurface({ { 8, 0, 0 } }, { { 10, 13, 13 } }), BoxSurface({ { 2, 3, 3 } }, { { 16, 10, 10 } }) },
    { { 18, 13, 13 } });
}

} // namespace
