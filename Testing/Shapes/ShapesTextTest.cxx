/**
 * Shapes given as text, and the predefined scenes.
 */
#include "Shapes/ShapesText.h"
#include "Base/Runtime.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace vfm;

namespace
{

const Vector3 Lower{ { -1, -1, -1 } }, Upper{ { 1, 1, 1 } };

std::vector<Shape> Parse(const std::string& text)
{
  return ParseShapes(text, Lower, Upper);
}

std::string ErrorOf(const std::string& text)
{
  try
  {
    Parse(text);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(ShapesText, ReadsEveryShape)
{
  const std::vector<Shape> shapes =
    Parse("# a comment\n"
          "sphere radius=0.4 center=0.1,0,0 # the ball\n"
          "ellipsoid radii=0.4,0.3,0.2 rotation=0,0,45\n\n"
          "  box size=1,1,0.5 material=3 ; cylinder radius=0.2 height=1\n"
          "cone bottom=0.4 top=0.1 height=1\n"
          "torus ring=0.5 tube=0.2\n"
          "halfspace point=0,0,0 normal=0,0,2\n"
          "plate thickness=0.1 normal=1,1,0\n"
          "gyroid period=1 level=0.2\r\n"
          "polycrystal material=5 grains=4 seed=2");
  ASSERT_EQ(shapes.size(), 13u);
  EXPECT_EQ(shapes[0].Kind, ShapeKind::Sphere);
  EXPECT_EQ(shapes[0].Center[0], 0.1);
  EXPECT_EQ(shapes[0].Size[0], 0.4);
  EXPECT_NEAR(shapes[1].Axes[0][1], std::sqrt(0.5), 1e-15);
  EXPECT_EQ(shapes[2].Material, 3);
  EXPECT_EQ(shapes[2].Size[2], 0.25);
  EXPECT_EQ(shapes[3].Kind, ShapeKind::Cylinder);
  EXPECT_EQ(shapes[4].Size[1], 0.1);
  EXPECT_EQ(shapes[5].Size[0], 0.5);
  EXPECT_EQ(shapes[6].Planes[0].Normal[2], 1.0);
  EXPECT_EQ(shapes[7].Planes.size(), 2u);
  EXPECT_EQ(shapes[8].Size[1], 0.2);
  EXPECT_EQ(shapes[9].Material, 5);
  EXPECT_EQ(shapes[12].Material, 8);
  EXPECT_TRUE(Parse("").empty());
}

TEST(ShapesText, CutsRepeat)
{
  const std::vector<Shape> shapes = Parse("sphere radius=0.8 cut=0,0,0,1,0,0 cut=0,0,0.5,0,0,1");
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_LT(SignedDistance(shapes[0], { { -0.1, 0.0, 0.4 } }), 0.0);
  EXPECT_NEAR(SignedDistance(shapes[0], { { 0.1, 0.0, 0.4 } }), 0.1, 1e-15);
  EXPECT_NEAR(SignedDistance(shapes[0], { { -0.2, 0.0, 0.6 } }), 0.1, 1e-15);
}

TEST(ShapesText, ErrorsNameLineAndWord)
{
  const auto expect = [](const std::string& text, const std::string& line, const std::string& word)
  {
    const std::string error = ErrorOf(text);
    EXPECT_NE(error.find("line " + line), std::string::npos) << text << ": " << error;
    EXPECT_NE(error.find(word), std::string::npos) << text << ": " << error;
  };
  expect("sphere radius=1\nball radius=1", "2", "'ball' is not a shape");
  expect("sphere", "1", "'radius='");
  expect("sphere radius=abc", "1", "'abc' is not a number");
  expect("sphere radius=", "1", "'radius='");
  expect("sphere radius=1,2", "1", "'radius' needs 1 number");
  expect("sphere radius=1 center=0,0", "1", "'center' needs 3 numbers");
  expect("sphere radius=1 radius=2", "1", "'radius' is given twice");
  expect("sphere radius=1 height=2", "1", "no parameter 'height'");
  expect("sphere radius = 1", "1", "'radius' is not of the form");
  expect("\n\nsphere radius=-1", "3", "radius");
  expect("sphere radius=1 material=0", "1", "material");
  expect("sphere radius=1 material=1.5", "1", "'material' must be an integer");
  expect("sphere radius=nan", "1", "radius");
  expect("sphere radius=1 cut=0,0,0,0,0,0", "1", "normal");
  expect("polycrystal grains=0", "1", "grains");
}

TEST(ShapesScenes, EverySceneFillsAPartOfItsDomain)
{
  const Vector3 lower{ { 2.0, -1.0, 5.0 } }, upper{ { 6.0, 2.0, 8.5 } };
  std::array<std::vector<double>, 3> x;
  for (int a = 0; a < 3; ++a)
  {
    for (int i = 0; i <= 10; ++i)
    {
      x[a].push_back(lower[a] + (upper[a] - lower[a]) * i / 10);
    }
  }
  const CartesianGrid grid(x);
  std::set<std::string> names;
  for (int s = 0; s < static_cast<int>(Scene::NumberOfScenes); ++s)
  {
    names.insert(GetSceneName(static_cast<Scene>(s)));
    const std::vector<Shape> shapes = MakeScene(static_cast<Scene>(s), lower, upper);
    const FractionField field = FractionsOfShapes(grid, shapes);
    std::vector<double> sums(CountMaterials(shapes) + 1, 0.0);
    for (int c = 0; c < 1000; ++c)
    {
      for (int m = 0; m <= CountMaterials(shapes); ++m)
      {
        sums[m] += field.Fraction(grid.Linear({ { c % 10, c / 10 % 10, c / 100 } }), m);
      }
    }
    for (std::size_t m = 1; m < sums.size(); ++m)
    {
      EXPECT_GT(sums[m], 1.0) << GetSceneName(static_cast<Scene>(s)) << ", material " << m;
    }
    EXPECT_EQ(sums[0] < 1e-6, static_cast<Scene>(s) == Scene::Polycrystal);
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Scene::NumberOfScenes));
}
