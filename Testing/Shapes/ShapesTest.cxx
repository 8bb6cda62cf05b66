/**
 * Distances and volume fractions of shapes, compared with closed forms.
 */
#include "Base/Vector3.h"
#include "Fractions/Plic.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <random>
#include <thread>

using namespace vfm;

namespace
{

constexpr double Pi = 3.14159265358979323846;
const Vector3 Center{ { 0.013, -0.021, 0.007 } };
const Vector3 Turn{ { 20.0, 35.0, 50.0 } };

struct KnownShape
{
  const char* Name;
  Shape Solid;
  double Volume;
};

/// Returns shapes inside [-1,1]^3 with their volumes.
std::vector<KnownShape> GetKnownShapes()
{
  const Shape ball = MakeSphere(1, Center, 0.8);
  return {
    { "sphere", ball, 4.0 / 3.0 * Pi * 0.512 },
    { "small sphere", MakeSphere(1, Center, 0.06), 4.0 / 3.0 * Pi * 0.06 * 0.06 * 0.06 },
    { "ellipsoid", MakeEllipsoid(1, Center, { { 0.8, 0.5, 0.2 } }, Turn), 4.0 / 3.0 * Pi * 0.08 },
    { "box", MakeBox(1, Center, { { 0.8, 0.5, 0.3 } }), 0.12 },
    { "turned box", MakeBox(1, Center, { { 0.8, 0.5, 0.3 } }, Turn), 0.12 },
    { "cylinder", MakeCylinder(1, Center, 0.4, 1.0, Turn), Pi * 0.16 },
    { "cone", MakeCone(1, Center, 0.6, 0.0, 1.0, Turn), Pi * 0.12 },
    { "frustum", MakeCone(1, Center, 0.3, 0.6, 1.0, Turn), Pi / 3.0 * 0.63 },
    { "torus", MakeTorus(1, Center, 0.5, 0.25, Turn), 2.0 * Pi * Pi * 0.5 * 0.0625 },
    { "half-space", MakeHalfSpace(1, Center, { { 1.0, 0.2, 0.3 } }),
      4.0 * (1.0 + Center[0] + 0.2 * Center[1] + 0.3 * Center[2]) },
    { "half ball", CutShape(ball, Center, { { 1.0, 2.0, 3.0 } }), 2.0 / 3.0 * Pi * 0.512 },
    { "gyroid", MakeGyroid(1, { { 0.0, 0.0, 0.0 } }, 2.0), 4.0 },
  };
}

std::array<std::vector<double>, 3> MakeUniformCoordinates(int n)
{
  std::vector<double> x;
  for (int i = 0; i <= n; ++i)
  {
    x.push_back(-1.0 + 2.0 * i / n);
  }
  return { { x, x, x } };
}

double SumVolume(const CartesianGrid& grid, const FractionField& field, int material)
{
  double sum = 0.0;
  const IndexBox& box = grid.Owned();
  for (Index k = 0; k < box.Upper[2]; ++k)
  {
    for (Index j = 0; j < box.Upper[1]; ++j)
    {
      for (Index i = 0; i < box.Upper[0]; ++i)
      {
        const Index3 cell{ { i, j, k } };
        sum += field.Fraction(grid.Linear(cell), material) * grid.CellVolume(cell);
      }
    }
  }
  return sum;
}

double FractionOf(const std::vector<Shape>& shapes, const Vector3& lower, const Vector3& upper)
{
  std::vector<double> fractions(CountMaterials(shapes));
  ShapeFractions(shapes, lower, upper, DefaultShapeTolerance, fractions.data());
  return fractions[0];
}

/// Returns the fraction from the signs of the distance: mean over lines
/// along z, ends found by bisection.
double SampleFraction(const Shape& shape, const Vector3& lower, const Vector3& upper)
{
  constexpr int Lines = 40, Steps = 16;
  const Vector3 edges = upper - lower;
  double sum = 0.0;
  for (int l = 0; l < Lines * Lines; ++l)
  {
    Vector3 p =
      lower + Scaled({ { (l % Lines + 0.5) / Lines, (l / Lines + 0.5) / Lines, 0.0 } }, edges);
    const auto inside = [&](double t)
    {
      p[2] = lower[2] + t * edges[2];
      return SignedDistance(shape, p) < 0.0;
    };
    for (int s = 0; s < Steps; ++s)
    {
      double low = static_cast<double>(s) / Steps, high = (s + 1.0) / Steps;
      const double first = low, last = high;
      const bool begin = inside(low);
      if (begin == inside(high))
      {
        sum += begin ? last - first : 0.0;
        continue;
      }
      for (int i = 0; i < 20; ++i)
      {
        const double middle = 0.5 * (low + high);
        (inside(middle) == begin ? low : high) = middle;
      }
      sum += begin ? low - first : last - low;
    }
  }
  return sum / (Lines * Lines);
}

using Cells = std::map<Index3, std::vector<std::pair<int, double>>>;

/// Returns the fractions of the cells of a box; the runtime sets the number of threads.
Cells ComputeCells(const std::array<std::vector<double>, 3>& coordinates, const IndexBox& box,
  const std::vector<Shape>& shapes, Runtime& runtime)
{
  Cells cells;
  std::mutex mutex;
  ComputeShapeFractions(coordinates, box, shapes, DefaultShapeTolerance, runtime,
    [&](const IndexBox& same, const std::vector<FractionField::Part>& parts)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      for (Index k = same.Lower[2]; k < same.Upper[2]; ++k)
      {
        for (Index j = same.Lower[1]; j < same.Upper[1]; ++j)
        {
          for (Index i = same.Lower[0]; i < same.Upper[0]; ++i)
          {
            for (const FractionField::Part& part : parts)
            {
              cells[{ { i, j, k } }].emplace_back(part.Material, part.Fraction);
            }
          }
        }
      }
    });
  return cells;
}

/// Runs each index on its own thread.
struct ThreadedRuntime : Runtime
{
  void For(std::int64_t first, std::int64_t last,
    const std::function<void(std::int64_t, std::int64_t)>& body) override
  {
    std::vector<std::thread> threads;
    for (std::int64_t i = first; i < last; ++i)
    {
      threads.emplace_back(body, i, i + 1);
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }
};

} // namespace

TEST(Shapes, VolumesAreExactOnCoarseAndFineGrids)
{
  for (const KnownShape& known : GetKnownShapes())
  {
    for (int n : { 5, 16, 40 })
    {
      const CartesianGrid grid(MakeUniformCoordinates(n));
      const double volume = SumVolume(grid, FractionsOfShapes(grid, { known.Solid }), 1);
      // The small sphere fills part of one cell: the tolerance per cell limits the error.
      const double bound =
        std::max(1e-5 * known.Volume, 0.2 * DefaultShapeTolerance * std::pow(2.0 / n, 3));
      EXPECT_NEAR(volume, known.Volume, bound) << known.Name << ", n = " << n;
    }
  }
}

TEST(Shapes, FractionsOfCellsKeepTheTolerance)
{
  const int n = 7;
  const double width = 2.0 / n;
  const CartesianGrid grid(MakeUniformCoordinates(n)), fine(MakeUniformCoordinates(8 * n));
  for (const KnownShape& known : GetKnownShapes())
  {
    const FractionField field = FractionsOfShapes(grid, { known.Solid });
    const FractionField parts = FractionsOfShapes(fine, { known.Solid });
    for (int c = 0; c < n * n * n; ++c)
    {
      const Index3 cell{ { c % n, c / n % n, c / n / n } };
      const double fraction = field.Fraction(grid.Linear(cell), 1);
      double sum = 0.0;
      for (int s = 0; s < 512; ++s)
      {
        sum +=
          parts.Fraction(
            fine.Linear({ { 8 * cell[0] + s % 8, 8 * cell[1] + s / 8 % 8, 8 * cell[2] + s / 64 } }),
            1) /
          512;
      }
      EXPECT_NEAR(fraction, sum, DefaultShapeTolerance) << known.Name << ", cell " << c;
      // Independent but coarser: off by half a line where a face is parallel to the lines.
      if (c % 11 == 0)
      {
        const Vector3 lower = grid.NodePoint(cell);
        const Vector3 upper = lower + Vector3{ { width, width, width } };
        EXPECT_NEAR(fraction, SampleFraction(known.Solid, lower, upper), 0.0125)
          << known.Name << ", cell " << c;
      }
    }
  }
}

TEST(Shapes, HalfSpacesAreExactInEveryCell)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i)
  {
    const Vector3 normal = Unit({ { uniform(random), uniform(random), uniform(random) } });
    const double offset = 0.9 * uniform(random);
    const double fraction = FractionOf({ MakeHalfSpace(1, offset * normal, normal) },
      { { -0.5, -0.5, -0.5 } }, { { 0.5, 0.5, 0.5 } });
    EXPECT_NEAR(fraction, VolumeBelowPlane(normal, offset), 1e-13);
  }
}

TEST(Shapes, FirstShapeKeepsItsVolume)
{
  const CartesianGrid grid(MakeUniformCoordinates(12));
  const Shape ball = MakeSphere(1, Center, 0.6);
  const Shape below = MakeHalfSpace(2, Center, { { 0.3, 0.2, 1.0 } });
  const double half = 4.0 * (1.0 + Center[2] + 0.3 * Center[0] + 0.2 * Center[1]);
  const double volume = 4.0 / 3.0 * Pi * 0.216;
  const FractionField first = FractionsOfShapes(grid, { ball, below });
  EXPECT_NEAR(SumVolume(grid, first, 1), volume, 1e-5);
  EXPECT_NEAR(SumVolume(grid, first, 2), half - 0.5 * volume, 1e-5);
  const FractionField last = FractionsOfShapes(grid, { below, ball });
  EXPECT_NEAR(SumVolume(grid, last, 1), 0.5 * volume, 1e-5);
  EXPECT_NEAR(SumVolume(grid, last, 2), half, 1e-5);
}

TEST(Shapes, SectorsAndGrainsFillTheirWhole)
{
  const CartesianGrid grid(MakeUniformCoordinates(12));
  const FractionField sectors = FractionsOfShapes(grid, MakeSectors(Center, 0.7, 3, 20.0));
  for (int m = 1; m <= 3; ++m)
  {
    EXPECT_NEAR(SumVolume(grid, sectors, m), 4.0 / 9.0 * Pi * 0.343, 2e-5) << m;
  }
  const int grains = 30;
  const FractionField crystal =
    FractionsOfShapes(grid, MakePolycrystal(1, { { -1, -1, -1 } }, { { 1, 1, 1 } }, grains, 3));
  double sum = 0.0;
  for (int m = 1; m <= grains; ++m)
  {
    EXPECT_GT(SumVolume(grid, crystal, m), 0.0) << m;
    sum += SumVolume(grid, crystal, m);
  }
  EXPECT_NEAR(sum, 8.0, 1e-8); // parts below 1e-9 are dropped
}

TEST(Shapes, GrainsFillEveryCellOnce)
{
  std::array<std::vector<double>, 3> x = MakeUniformCoordinates(13);
  for (int i = 0; i <= 13; ++i)
  {
    x[1][i] *= 0.9;
    x[2][i] = 100.0 + 0.7 * x[2][i];
  }
  Runtime runtime;
  const IndexBox all{ { { 0, 0, 0 } }, { { 13, 13, 13 } } };
  for (int grains : { 2, 20, 400 })
  {
    const std::vector<Shape> shapes =
      MakePolycrystal(1, { { -1.0, -0.9, 99.3 } }, { { 1.0, 0.9, 100.7 } }, grains);
    const Cells cells = ComputeCells(x, all, shapes, runtime);
    EXPECT_EQ(cells.size(), 13u * 13u * 13u);
    for (const auto& cell : cells)
    {
      double sum = 0.0;
      for (const auto& part : cell.second)
      {
        sum += part.second;
      }
      EXPECT_NEAR(sum, 1.0, 1e-11) << grains << " grains";
    }
  }
}

TEST(Shapes, AnyShapesLeaveTheirRestToAFillingOne)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto point = [&] {
    return Vector3{ { uniform(random), uniform(random), uniform(random) } };
  };
  const auto size = [&] { return 0.3 + 0.25 * uniform(random); };
  for (int i = 0; i < 60; ++i)
  {
    const std::vector<Shape> shapes{ MakeSphere(1, point(), size()),
      MakeBox(2, point(), { { size(), size(), 2.0 } }, 90.0 * point()),
      MakeCone(3, point(), size(), 0.0, 1.0, 90.0 * point()),
      MakeCylinder(4, point(), size(), 1.0, 90.0 * point()), MakeHalfSpace(5, point(), point()),
      MakeSphere(6, { { 0, 0, 0 } }, 10.0) };
    double sum = 0.0;
    for (const FractionField::Part& part :
      ComputeShapeParts(shapes, { { -0.6, -0.5, -0.4 } }, { { 0.4, 0.5, 0.6 } }, 1e-2))
    {
      EXPECT_GT(part.Fraction, 0.0);
      sum += part.Fraction;
    }
    EXPECT_NEAR(sum, 1.0, 1e-10) << "scene " << i;
  }
}

TEST(Shapes, VoronoiCellOfTwoSeedsIsAHalfSpace)
{
  const auto seeds = std::make_shared<const std::vector<Vector3>>(
    std::vector<Vector3>{ { { -0.5, 0.1, 0.2 } }, { { 0.6, 0.3, -0.4 } } });
  const Vector3 lower{ { -0.3, -0.3, -0.3 } }, upper{ { 0.4, 0.4, 0.4 } };
  const Vector3 middle = 0.5 * ((*seeds)[0] + (*seeds)[1]);
  EXPECT_NEAR(FractionOf({ MakeVoronoiCell(1, seeds, 0) }, lower, upper),
    FractionOf({ MakeHalfSpace(1, middle, (*seeds)[1] - (*seeds)[0]) }, lower, upper), 1e-13);
}

TEST(Shapes, FractionsDependOnNeitherBoxNorThreads)
{
  const std::array<std::vector<double>, 3> coordinates = MakeUniformCoordinates(40);
  const std::vector<Shape> shapes{ MakeTorus(1, Center, 0.5, 0.2, Turn),
    MakeBox(2, Center, { { 1.2, 0.3, 0.7 } }, Turn), MakeGyroid(3, Center, 1.5) };
  Runtime serial;
  ThreadedRuntime threaded;
  const IndexBox all{ { { 0, 0, 0 } }, { { 40, 40, 40 } } };
  const Cells whole = ComputeCells(coordinates, all, shapes, serial);
  EXPECT_EQ(whole, ComputeCells(coordinates, all, shapes, threaded));
  Cells pieces;
  for (Index k : { 0, 13 })
  {
    const IndexBox low{ { { 0, 0, k } }, { { 3, 40, k == 0 ? 13 : 40 } } };
    const IndexBox high{ { { 3, 0, k } }, { { 40, 40, k == 0 ? 13 : 40 } } };
    pieces.merge(ComputeCells(coordinates, low, shapes, serial));
    pieces.merge(ComputeCells(coordinates, high, shapes, serial));
  }
  EXPECT_EQ(whole, pieces);
}

TEST(Shapes, RectilinearGridsAreExactToo)
{
  std::array<std::vector<double>, 3> x = MakeUniformCoordinates(20);
  for (std::size_t i = 0; i < x[0].size(); ++i)
  {
    x[0][i] = std::sinh(2.0 * x[0][i]) / std::sinh(2.0);
    x[2][i] = x[2][i] * (1.0 + 0.4 * (x[2][i] * x[2][i] - 1.0));
  }
  const CartesianGrid grid(x);
  for (const KnownShape& known : GetKnownShapes())
  {
    EXPECT_NEAR(SumVolume(grid, FractionsOfShapes(grid, { known.Solid }), 1), known.Volume,
      1e-5 * std::max(known.Volume, 0.1))
      << known.Name;
  }
}

TEST(Shapes, DistancesReachTheSurface)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const KnownShape& known : GetKnownShapes())
  {
    const Shape& shape = known.Solid;
    const bool exact = shape.Kind != ShapeKind::Gyroid && shape.Planes.size() == shape.OwnPlanes;
    int tested = 0;
    for (int i = 0; exact && i < 400; ++i)
    {
      const Vector3 p{ { uniform(random), uniform(random), uniform(random) } };
      const double distance = SignedDistance(shape, p), step = 1e-6;
      Vector3 gradient;
      for (int a = 0; a < 3; ++a)
      {
        Vector3 low = p, high = p;
        low[a] -= step;
        high[a] += step;
        gradient[a] = (SignedDistance(shape, high) - SignedDistance(shape, low)) / (2.0 * step);
      }
      EXPECT_LT(Norm(gradient), 1.0 + 1e-5) << known.Name;
      if (Norm(gradient) > 1.0 - 1e-6) // not on the medial axis
      {
        ++tested;
        EXPECT_NEAR(SignedDistance(shape, p - distance * gradient), 0.0, 1e-5) << known.Name;
      }
    }
    EXPECT_EQ(tested > 350, exact) << known.Name;
  }
}

TEST(Shapes, FunctionsGiveTheFractionsOfTheirShape)
{
  const CartesianGrid grid(MakeUniformCoordinates(9));
  const Shape box = MakeBox(1, Center, { { 0.9, 0.7, 0.8 } }, Turn);
  const Shape torus = MakeTorus(1, Center, 0.5, 0.25, Turn);
  for (const Shape& shape : { box, torus })
  {
    const Shape function =
      MakeFunctionShape(1, [shape](const Vector3& p) { return SignedDistance(shape, p); });
    const FractionField a = FractionsOfShapes(grid, { shape });
    const FractionField b = FractionsOfShapes(grid, { function });
    for (Index c = 0; c < grid.NumberOfEntries(); ++c)
    {
      EXPECT_NEAR(a.Fraction(c, 1), b.Fraction(c, 1), 2.0 * DefaultShapeTolerance) << c;
    }
  }
}

TEST(Shapes, RefusesWhatIsNoShape)
{
  const Vector3 zero{ { 0, 0, 0 } };
  EXPECT_THROW(MakeSphere(1, zero, 0.0), InputError);
  EXPECT_THROW(MakeSphere(0, zero, 1.0), InputError);
  EXPECT_THROW(MakeSphere(1, { { NAN, 0, 0 } }, 1.0), InputError);
  EXPECT_THROW(MakeEllipsoid(1, zero, { { 1, -1, 1 } }), InputError);
  EXPECT_THROW(MakeBox(1, zero, { { 1, 0, 1 } }), InputError);
  EXPECT_THROW(MakeCylinder(1, zero, 1.0, INFINITY), InputError);
  EXPECT_THROW(MakeCone(1, zero, 0.0, 0.0, 1.0), InputError);
  EXPECT_THROW(MakeCone(1, zero, 1.0, -0.1, 1.0), InputError);
  EXPECT_THROW(MakeTorus(1, zero, 0.2, 0.3), InputError);
  EXPECT_THROW(MakeHalfSpace(1, zero, zero), InputError);
  EXPECT_THROW(MakeGyroid(1, zero, 1.0, 1.5), InputError);
  EXPECT_THROW(MakePlate(1, zero, { { 0, 0, 1 } }, 0.0), InputError);
  EXPECT_THROW(MakeSectors(zero, 1.0, 1), InputError);
  EXPECT_THROW(MakePolycrystal(1, zero, { { 1, 1, 1 } }, 0), InputError);
  EXPECT_THROW(ComputeShapeParts({}, zero, { { 1, 1, 1 } }, 0.0), InputError);
}
