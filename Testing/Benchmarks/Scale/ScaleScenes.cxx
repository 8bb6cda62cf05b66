#include "ScaleScenes.h"

#include "MeshChecks.h"
#include "Ranks/Errors.h"
#include "Shapes/ShapesFractions.h"
#include "SiteDraw.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfm
{
namespace testing
{
namespace
{

constexpr int Samples = 6;            // per axis of a cell that a drop fills partly
constexpr double HalfDiagonal = 0.87; // of a cell, rounded up

double SquareTo(const Vector3& a, const Vector3& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
    (a[2] - b[2]) * (a[2] - b[2]);
}

Vector3 CentreOf(const Index3& cell)
{
  return { { static_cast<double>(cell[0]) + 0.5, static_cast<double>(cell[1]) + 0.5,
    static_cast<double>(cell[2]) + 0.5 } };
}

/// Sites on a lattice, each at a random place in the middle of its cube.
class Sites
{
public:
  Sites(const Index3& count, Index spacing, double scatter) :
    Count(count), Spacing(spacing), Scatter(scatter)
  {
  }
  Index3 CubeOf(const Index3& cell) const
  {
    return { { cell[0] / this->Spacing, cell[1] / this->Spacing, cell[2] / this->Spacing } };
  }
  Index NumberOf(const Index3& cube) const
  {
    return (cube[2] * this->Count[1] + cube[1]) * this->Count[0] + cube[0];
  }
  Vector3 PlaceOf(const Index3& cube) const
  {
    Vector3 place;
    for (int a = 0; a < 3; ++a)
    {
      place[a] = static_cast<double>(this->Spacing) * (static_cast<double>(cube[a]) + 0.5) +
        this->Scatter * (DrawNumber(this->NumberOf(cube), a) - 0.5);
    }
    return place;
  }
  bool Has(const Index3& cube) const { return IndexBox{ {}, this->Count }.Contains(cube); }

private:
  Index3 Count;
  Index Spacing;
  double Scatter; // width of the range of places, in cells
};

/// Returns the part of a cell inside a ball.
double ShareOfBall(const Index3& cell, const Vector3& centre, double radius)
{
  const double distance = std::sqrt(SquareTo(CentreOf(cell), centre));
  if (std::fabs(distance - radius) > HalfDiagonal)
  {
    return distance < radius ? 1.0 : 0.0;
  }
  int inside = 0;
  for (int s = 0; s < Samples * Samples * Samples; ++s)
  {
    const int at[3] = { s % Samples, s / Samples % Samples, s / (Samples * Samples) };
    Vector3 x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = static_cast<double>(cell[a]) + (at[a] + 0.5) / Samples;
    }
    inside += SquareTo(x, centre) < radius * radius;
  }
  return static_cast<double>(inside) / (Samples * Samples * Samples);
}

template <class Value, class Function>
std::vector<Value> Evaluate(const IndexBox& box, const Function& valueOf)
{
  std::vector<Value> values;
  values.reserve(box.NumberOfCells());
  ForCells(box, [&](const Index3& cell) { values.push_back(static_cast<Value>(valueOf(cell))); });
  return values;
}

ScaleScene MakeSpray(const Index3& drops, const SpraySizes& sizes)
{
  const Sites sites(drops, sizes.Spacing, 1.0);
  ScaleScene scene;
  scene.Fractions = [=](const IndexBox& box)
  {
    return Evaluate<float>(box,
      [&](const Index3& cell)
      {
        const Index3 cube = sites.CubeOf(cell);
        return ShareOfBall(cell, sites.PlaceOf(cube),
          sizes.Least + (sizes.Largest - sizes.Least) * DrawNumber(sites.NumberOf(cube), 3));
      });
  };
  return scene;
}

/// Returns the number of the nearest seed, from 1.
int GrainOf(const Index3& cell, const Sites& seeds)
{
  const Index3 middle = seeds.CubeOf(cell);
  double least = std::numeric_limits<double>::max();
  Index nearest = 0;
  const IndexBox near{ { { middle[0] - 1, middle[1] - 1, middle[2] - 1 } },
    { { middle[0] + 2, middle[1] + 2, middle[2] + 2 } } };
  ForCells(near,
    [&](const Index3& cube)
    {
      const double square = seeds.Has(cube) ? SquareTo(CentreOf(cell), seeds.PlaceOf(cube)) : least;
      if (square < least)
      {
        least = square;
        nearest = seeds.NumberOf(cube) + 1;
      }
    });
  return static_cast<int>(nearest);
}

ScaleScene MakeGrains(const Index3& grains, Index spacing)
{
  const Sites seeds(grains, spacing, 0.5 * static_cast<double>(spacing));
  ScaleScene scene;
  scene.AreLabels = true;
  scene.Labels = [=](const IndexBox& box)
  { return Evaluate<int>(box, [&](const Index3& cell) { return GrainOf(cell, seeds); }); };
  return scene;
}

ScaleScene MakeBall(const Index3& cells)
{
  const double width = static_cast<double>(*std::min_element(cells.begin(), cells.end()));
  const Vector3 centre{ { 0.5 * static_cast<double>(cells[0]) + 0.1,
    0.5 * static_cast<double>(cells[1]) + 0.2, 0.5 * static_cast<double>(cells[2]) + 0.3 } };
  ScaleScene scene;
  scene.Fractions = [=](const IndexBox& box)
  {
    return Evaluate<float>(
      box, [&](const Index3& cell) { return ShareOfBall(cell, centre, 0.4 * width); });
  };
  return scene;
}

ScaleScene MakeGyroidScene(const Index3& cells)
{
  ScaleScene scene;
  scene.Fractions = [=](const IndexBox& box)
  {
    const CartesianGrid whole = MakeUnitGrid(cells[0], cells[1], cells[2]);
    const CartesianGrid grid(whole, box, 0, 0);
    const FractionField field =
      FractionsOfShapes(grid, { MakeGyroid(1, { { 0.1, 0.2, 0.3 } }, 16.0) });
    return Evaluate<float>(
      box, [&](const Index3& cell) { return field.Fraction(grid.Linear(cell), 1); });
  };
  return scene;
}

} // namespace

ScaleScene MakeScaleScene(const std::string& name, const Index3& size, const SpraySizes& sizes)
{
  const bool hasSites = name == "spray" || name == "grains";
  if (!hasSites && name != "ball" && name != "gyroid")
  {
    throw InputError("Scale: there is no scene " + name);
  }
  ScaleScene scene = name == "spray" ? MakeSpray(size, sizes)
    : name == "grains"               ? MakeGrains(size, sizes.Spacing)
    : name == "ball"                 ? MakeBall(size)
                                     : MakeGyroidScene(size);
  for (int a = 0; a < 3; ++a)
  {
    scene.Cells[a] = size[a] * (hasSites ? sizes.Spacing : 1);
  }
  return scene;
}

} // namespace testing
} // namespace vfm
