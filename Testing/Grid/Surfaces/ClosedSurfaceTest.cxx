/// Closed surfaces from the triangles of files: a table of broken inputs, each with its volume or
/// message.
#include "Surfaces/ClosedSurface.h"

#include "LooseTriangles.h"
#include "Ranks/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const LooseTriangles Cube = MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } });

struct Result
{
  double Volume = 0.0;
  std::string Note;
};

Result Close(const LooseTriangles& input)
{
  Result result;
  result.Volume = MeasureVolume(CloseSurface(input.Points, input.Triangles, nullptr, &result.Note));
  return result;
}

void ExpectVolume(const LooseTriangles& input, double volume, const std::string& note)
{
  const Result result = Close(input);
  EXPECT_NEAR(result.Volume, volume, 1e-5 * volume);
  EXPECT_NE(result.Note.find(note), std::string::npos) << "'" << result.Note << "'";
  EXPECT_EQ(result.Note.empty(), note.empty()) << result.Note;
}

void ExpectProblem(const LooseTriangles& input, const std::string& text)
{
  try
  {
    CloseSurface(input.Points, input.Triangles);
    ADD_FAILURE() << "no error with '" << text << "'";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

/// Returns the points moved by up to a distance along each axis.
LooseTriangles Shake(LooseTriangles input, double distance)
{
  std::mt19937 random(7);
  for (Vector3& point : input.Points)
  {
    for (double& x : point)
    {
      x += distance * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0);
    }
  }
  return input;
}

/// Returns a cube whose upper side has a corner in the middle of one edge, which the side next to
/// it lacks.
LooseTriangles WithCornerOnEdge()
{
  LooseTriangles cube = Cube;
  cube.Points.push_back({ { 0.5, 0, 1 } });
  for (PointTriangle& t : cube.Triangles)
  {
    if (t == PointTriangle{ { 4, 5, 7 } })
    {
      t = { { 4, 8, 7 } };
    }
  }
  cube.Triangles.push_back({ { 8, 5, 7 } });
  return cube;
}

/// Returns two tetrahedra with a common edge.
LooseTriangles TetrahedraAtEdge(bool isSecondTurned)
{
  LooseTriangles both{ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0.5, 1, 0 } }, { { 0.5, 0.5, 1 } },
                         { { 0.5, -1, 0 } }, { { 0.5, -0.5, 1 } } },
    { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 0, 3, 2 } }, { { 0, 1, 4 } },
      { { 0, 5, 1 } }, { { 1, 5, 4 } }, { { 0, 4, 5 } } } };
  for (std::size_t t = 4; t < 8 && isSecondTurned; ++t)
  {
    std::swap(both.Triangles[t][1], both.Triangles[t][2]);
  }
  return both;
}

TEST(ClosedSurface, PointsWithoutTrianglesNeedNotBeFinite)
{
  std::vector<Vector3> points{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  std::vector<PointTriangle> triangles;
  for (Index i = 0; i < 200; ++i) // copies of the corners, and points that are not used
  {
    const Index first = static_cast<Index>(points.size());
    points.push_back({ { NAN, static_cast<double>(i % 7), NAN } });
    points.push_back(points[i % 4]);
    triangles.push_back({ { i % 4, first + 1, i % 4 } });
  }
  for (const PointTriangle& triangle : { PointTriangle{ { 0, 2, 1 } }, PointTriangle{ { 0, 1, 3 } },
         PointTriangle{ { 1, 2, 3 } }, PointTriangle{ { 0, 3, 2 } } })
  {
    triangles.push_back(triangle);
  }
  EXPECT_EQ(CloseSurface(points, triangles).Triangles.size(), 4u);
}

TEST(ClosedSurface, RepairsPointsAndTriangles)
{
  ExpectVolume(Cube, 1.0, "");
  ExpectVolume(Separate(Cube), 1.0, "");
  ExpectVolume(Shake(Separate(Cube), 1e-7), 1.0, "28 points are merged");
  ExpectVolume(Join(Cube, Cube), 1.0, "12 repeated triangles are dropped");
  ExpectVolume(WithCornerOnEdge(), 1.0, "1 triangles are divided");
  ExpectVolume(Shake(Separate(WithCornerOnEdge()), 1e-7), 1.0, "1 triangles are divided");
}

TEST(ClosedSurface, TurnsComponentsByTheirNesting)
{
  const LooseTriangles second = MakeBox({ { 3, 0, 0 } }, { { 4, 1, 1 } });
  const LooseTriangles turned = MakeBox({ { 3, 0, 0 } }, { { 4, 1, 1 } }, true);
  ExpectVolume(MakeBox({ { 0, 0, 0 } }, { { 1, 1, 1 } }, true), 1.0, "");
  ExpectVolume(Join(Cube, second), 2.0, "");
  ExpectVolume(Join(Cube, turned), 2.0, "1 components of the surface that faced inwards");
  ExpectVolume(Join(turned, Cube), 2.0, "(3, 0, 0)");
  LooseTriangles mixed = Cube;
  std::swap(mixed.Triangles[5][0], mixed.Triangles[5][1]);
  ExpectVolume(mixed, 1.0, "1 triangles that faced the other way");
}

TEST(ClosedSurface, CavitiesHaveAnyTurn)
{
  for (bool isOuterTurned : { false, true })
  {
    const LooseTriangles outer = MakeBox({ { 0, 0, 0 } }, { { 4, 4, 4 } }, isOuterTurned);
    for (bool isInnerTurned : { false, true })
    {
      const LooseTriangles inner = MakeBox({ { 1, 1, 1 } }, { { 3, 3, 3 } }, isInnerTurned);
      const bool isPlain = isInnerTurned != isOuterTurned;
      ExpectVolume(Join(outer, inner), 56.0, isPlain ? "" : "1 components inside of others");
      const LooseTriangles core = MakeBox({ { 1.5, 1.5, 1.5 } }, { { 2.5, 2.5, 2.5 } });
      EXPECT_NEAR(Close(Join(Join(outer, inner), core)).Volume, 57.0, 1e-12);
    }
  }
  // a box in a notch, which is inside of the box around the other body, but outside of the body
  LooseTriangles notched = MakeBox({ { 0, 0, 0 } }, { { 4, 1, 4 } });
  notched.Add(MakeBox({ { 0, 1, 0 } }, { { 1, 4, 4 } }));
  ExpectVolume(Join(notched, MakeBox({ { 1, 1, 1 } }, { { 2, 2, 2 } })), 16 + 12 + 1, "");
  ExpectVolume(Join(notched, MakeBox({ { 2, 2, 2 } }, { { 3, 3, 3 } })), 16 + 12 + 1, "");
}

TEST(ClosedSurface, PartsMayTouch)
{
  const LooseTriangles beside = MakeBox({ { 1, 0, 0 } }, { { 2, 1, 1 } });
  const LooseTriangles turned = MakeBox({ { 1, 0, 0 } }, { { 2, 1, 1 } }, true);
  ExpectVolume(Join(Cube, MakeBox({ { 1, 1, 0 } }, { { 2, 2, 1 } })), 2.0, ""); // an edge
  ExpectVolume(Join(Cube, MakeBox({ { 1, 1, 0 } }, { { 2, 2, 1 } }, true)), 2.0, "12 triangles");
  ExpectVolume(Join(Cube, MakeBox({ { 1, 1, 1 } }, { { 2, 2, 2 } })), 2.0, ""); // a corner
  ExpectVolume(TetrahedraAtEdge(false), 1.0 / 3.0, "");
  ExpectVolume(TetrahedraAtEdge(true), 1.0 / 3.0, "4 triangles that faced");
  ExpectVolume(Join(Cube, beside), 2.0, "4 triangles that lie back to back");
  ExpectVolume(Join(Cube, turned), 2.0, "4 triangles that lie back to back");
}

TEST(ClosedSurface, MessagesNameAPlace)
{
  LooseTriangles open = Cube;
  open.Triangles.pop_back();
  ExpectProblem(open, "3 edges belong to one triangle only, the first from (0, 0, 1) to (0, 1, 1)");
  ExpectProblem(Shake(Separate(Cube), 1e-4), "apart: if they are the same, merge them first");
  LooseTriangles wall = Cube;
  wall.Points.push_back({ { 2, 0.5, 0.5 } });
  wall.Triangles.push_back({ { 1, 3, 8 } });
  wall.Triangles.push_back({ { 3, 7, 8 } });
  wall.Triangles.push_back({ { 7, 5, 8 } });
  wall.Triangles.push_back({ { 5, 1, 8 } });
  ExpectProblem(wall, "4 edges belong to an odd number of triangles, up to 3, the first from");
  ExpectProblem({}, "no polygons");
  ExpectProblem({ { { { 0, 0, 0 } } }, { { { 0, 0, 1 } } } }, "point 1");
  LooseTriangles strip; // five triangles, one side
  for (int p = 0; p < 5; ++p)
  {
    strip.Points.push_back({ { std::cos(1.3 * p), std::sin(1.3 * p), 0.1 * p } });
  }
  for (Index p = 0; p < 5; ++p)
  {
    strip.Triangles.push_back({ { p, (p + 1) % 5, (p + 2) % 5 } });
  }
  ExpectProblem(strip, "5 edges belong to one triangle only");
}

TEST(ClosedSurface, HasOneSideOnly)
{
  // the projective plane of six points, whose edges all have two triangles
  LooseTriangles plane;
  for (int p = 0; p < 6; ++p)
  {
    plane.Points.push_back({ { std::cos(p), std::sin(2.0 * p), 0.3 * p * p } });
  }
  plane.Triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } }, { { 0, 3, 4 } }, { { 0, 4, 5 } },
    { { 0, 5, 1 } }, { { 1, 2, 4 } }, { { 2, 3, 5 } }, { { 3, 4, 1 } }, { { 4, 5, 2 } },
    { { 5, 1, 3 } } };
  ExpectProblem(plane, "only one side");
}

TEST(ClosedSurface, DoesNotDependOnTheOrderOfTheInput)
{
  LooseTriangles input = Join(Shake(Separate(WithCornerOnEdge()), 1e-7),
    Join(MakeBox({ { 0.2, 0.2, 0.2 } }, { { 0.8, 0.8, 0.8 } }),
      MakeBox({ { 2, 0, 0 } }, { { 3, 1, 1 } }, true)));
  std::vector<int> patches;
  for (std::size_t t = 0; t < input.Triangles.size(); ++t)
  {
    patches.push_back(static_cast<int>(t % 3));
  }
  std::vector<int> expectedPatches = patches;
  std::string expectedNote;
  const ClosedSurface expected =
    CloseSurface(input.Points, input.Triangles, &expectedPatches, &expectedNote);
  EXPECT_TRUE(std::is_sorted(expected.Points.begin(), expected.Points.end()));
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round)
  {
    for (std::size_t t = input.Triangles.size() - 1; t > 0; --t)
    {
      const std::size_t other = random() % (t + 1);
      std::swap(input.Triangles[t], input.Triangles[other]);
      std::swap(patches[t], patches[other]);
      std::rotate(input.Triangles[t].begin(), input.Triangles[t].begin() + random() % 3,
        input.Triangles[t].end());
    }
    std::vector<Index> place(input.Points.size());
    for (std::size_t p = 0; p < place.size(); ++p)
    {
      place[p] = static_cast<Index>(p);
    }
    std::shuffle(place.begin(), place.end(), random);
    LooseTriangles moved{ std::vector<Vector3>(place.size()), input.Triangles };
    for (std::size_t p = 0; p < place.size(); ++p)
    {
      moved.Points[place[p]] = input.Points[p];
    }
    for (PointTriangle& t : moved.Triangles)
    {
      t = { { place[t[0]], place[t[1]], place[t[2]] } };
    }
    std::vector<int> found = patches;
    std::string note;
    const ClosedSurface surface = CloseSurface(moved.Points, moved.Triangles, &found, &note);
    EXPECT_EQ(surface.Points, expected.Points);
    EXPECT_EQ(surface.Triangles, expected.Triangles);
    EXPECT_EQ(found, expectedPatches);
    EXPECT_EQ(note, expectedNote);
  }
}

} // namespace
