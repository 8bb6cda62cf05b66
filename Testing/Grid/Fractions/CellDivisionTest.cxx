/// Cells of high aspect ratio are cut before meshing: into as few parts as suffice, with all
/// volumes kept, the same on all ranks, and with elements of good shape.
#include "Fractions/CellDivision.h"
#include "Base/Vector3.h"
#include "Fractions/GhostFractions.h"
#include "Fractions/RefineCells.h"
#include "Labels/SmoothLabels.h"
#include "MeshCases.h"
#include "RankFields.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Coordinates = std::array<std::vector<double>, 3>;

/// Returns equal cells of the given widths.
Coordinates MakeCells(const Index3& counts, const Vector3& widths)
{
  Coordinates x;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i <= counts[a]; ++i)
    {
      x[a].push_back(widths[a] * static_cast<double>(i));
    }
  }
  return x;
}

/// Returns the largest ratio of widths of any cell.
double LargestAspectRatio(const Coordinates& coordinates)
{
  const CartesianGrid grid(coordinates);
  double largest = 1.0;
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      const Vector3 w{ { grid.Width(0, p[0]), grid.Width(1, p[1]), grid.Width(2, p[2]) } };
      largest = std::max(
        largest, *std::max_element(w.begin(), w.end()) / *std::min_element(w.begin(), w.end()));
    });
  return largest;
}

Index CountCells(const Coordinates& x)
{
  return static_cast<Index>((x[0].size() - 1) * (x[1].size() - 1) * (x[2].size() - 1));
}

/// Returns the fewest cells of any sufficient division into at most `most` parts per layer. The
/// grid has two layers along x and y, one along z.
Index FindFewestCells(const Coordinates& x, double ratio, Index most)
{
  Index fewest = -1;
  std::array<Index, 5> n;
  for (Index code = 0; code < most * most * most * most * most; ++code)
  {
    Index rest = code;
    for (Index& parts : n)
    {
      parts = rest % most + 1;
      rest /= most;
    }
    const Coordinates divided = CellDivision(
      std::array<std::vector<Index>, 3>{ { { n[0], n[1] }, { n[2], n[3] },
        { n[4] } } }).Divide(x);
    const Index cells = CountCells(divided);
    if ((fewest < 0 || cells < fewest) && LargestAspectRatio(divided) <= ratio)
    {
      fewest = cells;
    }
  }
  return fewest;
}

/// Returns a division whose number of parts differs from layer to layer.
CellDivision MakeUnevenDivision(const Index3& cells)
{
  std::array<std::vector<Index>, 3> parts;
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i < cells[a]; ++i)
    {
      parts[a].push_back(1 + (i * (a + 2) + a) % (a + 3));
    }
  }
  return CellDivision(parts);
}

RefinedCells Divide(
  const CartesianGrid& grid, const FractionField& field, const CellDivision& division)
{
  Runtime runtime;
  return DivideCells(grid, field, division, runtime);
}

/// Returns the largest difference between the fraction of a cell and the mean over its parts.
double FindLargestLoss(const CartesianGrid& grid, const FractionField& field,
  const CellDivision& division, const RefinedCells& parts)
{
  double largest = 0.0;
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const IndexBox box = division.Divide(BoxOfCell(p));
      for (int m = 0; m <= field.NumberOfMaterials(); ++m)
      {
        double sum = 0.0;
        ForCells(
          box, [&](const Index3& q) { sum += parts.Fractions.Fraction(parts.Grid.Linear(q), m); });
        const double mean = sum / static_cast<double>(box.NumberOfCells());
        largest = std::max(largest, std::fabs(mean - field.Fraction(grid.Linear(p), m)));
      }
    });
  return largest;
}

} // namespace

TEST(CellDivision, CutsIntoTheFewestPartsThatSuffice)
{
  const auto parts = [](const Vector3& widths, double ratio) {
    return DivideLongCells(MakeCells({ { 2, 3, 4 } }, widths), ratio).Parts({ { 1, 1, 1 } });
  };
  EXPECT_EQ(parts({ { 0.5, 0.5, 3.0 } }, 1.5), (Index3{ { 1, 1, 4 } }));
  EXPECT_EQ(parts({ { 1.0, 1.0, 4.0 } }, 1.5), (Index3{ { 1, 1, 3 } }));
  EXPECT_EQ(parts({ { 0.1, 0.3, 0.15 } }, 1.5), (Index3{ { 1, 2, 1 } }));
  EXPECT_EQ(parts({ { 1.0, 1.5, 1.6 } }, 1.5), (Index3{ { 1, 2, 2 } })) << "a part may be narrower";
  EXPECT_EQ(parts({ { 1.0, 1.0, 1.5 } }, 1.5), (Index3{ { 1, 1, 1 } }));
  EXPECT_TRUE(DivideLongCells(MakeCells({ { 2, 3, 4 } }, { { 0.3, 0.2, 0.2 } }), 1.5).IsNone());
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> width(0.5, 2.5);
  for (double ratio : { 1.3, 1.5, 2.0 })
  {
    for (int seed = 0; seed < 8; ++seed)
    {
      Coordinates x{ { { 0.0 }, { 0.0 }, { 0.0, width(engine) } } };
      for (int i = 0; i < 2; ++i)
      {
        x[0].push_back(x[0].back() + width(engine));
        x[1].push_back(x[1].back() + width(engine));
      }
      const Coordinates divided = DivideLongCells(x, ratio).Divide(x);
      EXPECT_LE(LargestAspectRatio(divided), 1.001 * ratio);
      const Index fewest = FindFewestCells(x, ratio, 7);
      EXPECT_TRUE(fewest < 0 || CountCells(divided) <= fewest) << fewest;
    }
  }
}

TEST(CellDivision, CutsOnlyLongLayers)
{
  Coordinates x = MakeCells({ { 4, 4, 5 } }, { { 1.0, 1.0, 1.0 } });
  x[2] = { 0.0, 1.0, 2.0, 6.0, 7.2, 9.2 };
  const CellDivision division = DivideLongCells(x, 1.5);
  EXPECT_EQ(division.Divide(x)[2],
    (std::vector<double>{
      0.0, 1.0, 2.0, 2.0 + 4.0 / 3, 2.0 + 2.0 / 3 * 4.0, 6.0, 7.2, 7.2 + 0.5 * (9.2 - 7.2), 9.2 }));
  EXPECT_EQ(division.Divide(x)[0], x[0]);
  EXPECT_EQ(division.ParentOf({ { 3, 0, 4 } }), (Index3{ { 3, 0, 2 } }));
  EXPECT_EQ(division.ParentOf({ { 0, 2, 7 } }), (Index3{ { 0, 2, 4 } }));
  const CellDivision halves = division.OfHalves(1);
  EXPECT_EQ(halves.Parts({ { 7, 0, 4 } }), (Index3{ { 1, 1, 3 } }));
  EXPECT_EQ(halves.Divide(IndexBox{ { { 0, 0, 4 } }, { { 2, 2, 6 } } }),
    (IndexBox{ { { 0, 0, 4 } }, { { 2, 2, 10 } } }));
}

TEST(CellDivision, RefusesMoreCellsThanIdsCanNumber)
{
  EXPECT_THROW(DivideLongCells(MakeCells({ { 2, 2, 2 } }, { { 1.0, 1e9, 1e9 } }), 1.5), InputError);
  EXPECT_THROW(
    DivideLongCells(MakeCells({ { 2, 2, 2 } }, { { 1e-10, 1.0, 1.0 } }), 1.5), InputError);
}

TEST(CellDivision, KeepsTheVolumesOfEveryCell)
{
  double largest = 0.0;
  for (int materials = 1; materials <= 5; ++materials)
  {
    const CartesianGrid grid = materials % 2 ? MakeUnevenGrid(7) : MakeUnitGrid(9, 7, 1);
    const FractionField field = MakePatchyFractions(grid, materials, materials);
    const CellDivision division = MakeUnevenDivision(grid.Global().Upper);
    const RefinedCells parts = Divide(grid, field, division);
    largest = std::max(largest, FindLargestLoss(grid, field, division, parts));
  }
  std::printf("fractions of cells and means of their parts differ by at most %.1e\n", largest);
  EXPECT_LT(largest, 1e-12);
}

TEST(CellDivision, HalfSpacesStayExact)
{
  const CartesianGrid grid(MakeCells({ { 8, 8, 4 } }, { { 1.0, 1.0, 3.0 } }));
  const CellDivision division = MakeUnevenDivision(grid.Global().Upper);
  for (const Vector3& normal : { Vector3{ { 0, 0, 1 } }, { { 1, 2, 3 } }, { { -3, 1, 0.2 } } })
  {
    const std::vector<Shape> half{ MakeHalfSpace(1, { { 4.1, 3.8, 6.4 } }, normal) };
    const RefinedCells parts = Divide(grid, FractionsOfShapes(grid, half), division);
    const FractionField exact = FractionsOfShapes(parts.Grid, half);
    double largest = 0.0;
    ForCells(parts.Grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = parts.Grid.Linear(p);
        largest =
          std::max(largest, std::fabs(parts.Fractions.Fraction(cell, 1) - exact.Fraction(cell, 1)));
      });
    EXPECT_LT(largest, 1e-10);
  }
}

TEST(CellDivision, InHalvesDoesAsRefineCells)
{
  const CartesianGrid grid = MakeUnevenGrid(6);
  const FractionField field = MakePatchyFractions(grid, 3, 2);
  Runtime runtime;
  const RefinedCells halves = RefineCells(grid, field, runtime);
  const RefinedCells parts = Divide(grid, field, CellDivision(grid.Global().Upper, 2));
  EXPECT_EQ(halves.Grid.Coordinates(), parts.Grid.Coordinates());
  ForCells(halves.Grid.Owned(),
    [&](const Index3& p)
    {
      EXPECT_TRUE(HaveSameParts(
        halves.Fractions, halves.Grid.Linear(p), parts.Fractions, parts.Grid.Linear(p)));
    });
}

TEST(CellDivision, RanksHoldWhatTheWholeGridHolds)
{
  const CartesianGrid whole = MakeUnevenGrid(9);
  const FractionField field = MakePatchyFractions(whole, 3, 7);
  const CellDivision division = MakeUnevenDivision(whole.Global().Upper);
  const RefinedCells all = Divide(whole, field, division);
  for (int count : { 2, 3, 4 })
  {
    std::vector<IndexBox> boxes = CutBox(whole.Global(), count);
    boxes.push_back(IndexBox()); // a rank without cells
    std::atomic<Index> differences{ 0 };
    RunOnRanks(static_cast<int>(boxes.size()),
      [&](Ranks& ranks)
      {
        RankRuntime runtime(ranks);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        RefinedCells part = DivideCells(grid, CopyToLocal(whole, field, grid), division, runtime);
        FillGhosts(Partition(part.Grid, ranks), part.Fractions);
        ForCells(part.Grid.Local(),
          [&](const Index3& p)
          {
            differences += !HaveSameParts(
              part.Fractions, part.Grid.Linear(p), all.Fractions, all.Grid.Linear(p));
          });
      });
    EXPECT_EQ(differences, 0) << count << " ranks";
  }
}

namespace
{

/// Root mean square deviation of a material's surface from a shape: distance of nodes (length) and
/// angle between normals of facets (degrees).
struct SurfaceError
{
  double Distance = 0.0, Normal = 0.0;
};

Vector3 GradientOf(const Shape& shape, const Vector3& x)
{
  constexpr double step = 1e-4;
  Vector3 gradient;
  for (int a = 0; a < 3; ++a)
  {
    Vector3 low = x, high = x;
    low[a] -= step;
    high[a] += step;
    gradient[a] = SignedDistance(shape, high) - SignedDistance(shape, low);
  }
  return Unit(gradient);
}

SurfaceError MeasureSurface(const Mesh& mesh, const Shape& shape)
{
  const auto point = [&mesh](Index p)
  {
    const double* x = mesh.Points.data() + 3 * p;
    return Vector3{ { x[0], x[1], x[2] } };
  };
  double squares = 0.0;
  std::size_t facets = 0;
  for (std::size_t f = 0; f < mesh.Surfaces.DomainSide.size(); ++f)
  {
    if (mesh.Surfaces.DomainSide[f] >= 0)
    {
      continue;
    }
    const Index* corners = mesh.Surfaces.Points.data() + 4 * f;
    const Vector3 a = point(corners[0]), b = point(corners[1]), c = point(corners[2]),
                  d = point(corners[3]);
    const Vector3 normal = Unit(Cross(c - a, d - b));
    const double cosine = std::fabs(Dot(normal, GradientOf(shape, 0.25 * (a + b + c + d))));
    squares += std::pow(180.0 / M_PI * std::acos(std::min(cosine, 1.0)), 2);
    ++facets;
  }
  SurfaceError error;
  error.Distance = MeasureDistances(mesh,
    [&shape](const Vector3& x) {
      return SignedDistance(shape, x);
    }).RootMeanSquare;
  error.Normal = std::sqrt(squares / static_cast<double>(facets));
  return error;
}

enum class Order
{
  SmoothThenCut,
  CutThenSmooth
};

/// Meshes the labels of a shape at cell centres, smoothed and cut in the given order.
SurfaceError MeasureLabels(const CartesianGrid& grid, const Shape& shape, Order order)
{
  constexpr int passes = 2;
  Runtime runtime;
  const FractionField labels = MakeLabels(grid, 1,
    [&](const Index3& p)
    {
      const Vector3 middle = 0.5 * (grid.NodePoint(p) + grid.NodePoint(CornerOfCell(p, 7)));
      return SignedDistance(shape, middle) < 0.0 ? 1 : 0;
    });
  const auto smooth = [&](const CartesianGrid& cells, FractionField& field)
  { SmoothLabels(cells, passes, Partition(cells, runtime.Group()), runtime, field); };
  FractionField field = labels;
  if (order == Order::SmoothThenCut)
  {
    smooth(grid, field);
  }
  RefinedCells parts = Divide(grid, field, DivideLongCells(grid.Coordinates(), 1.5));
  if (order == Order::CutThenSmooth)
  {
    smooth(parts.Grid, parts.Fractions);
  }
  MeshReport report;
  const Mesh mesh = MakeHexMesh(parts.Grid, parts.Fractions, MeshOptions(), runtime, report);
  return MeasureSurface(mesh, shape);
}

} // namespace

/// Smoothing parts of a slice retains the steps between slices; smoothing
/// whole slices removes them.
TEST(CellDivision, LabelsAreSmoothedBetterBeforeTheyAreCut)
{
  std::printf("labels, two passes: rms distance in pixels, rms error of normals in degrees\n"
              "%-14s%8s%22s%22s\n",
    "", "aspect", "smoothed, then cut", "cut, then smoothed");
  double before = 0.0, after = 0.0;
  for (double aspect : { 3.0, 6.0 })
  {
    const Index layers = static_cast<Index>(std::lround(30.0 / aspect));
    const CartesianGrid grid(MakeCells({ { 30, 30, layers } }, { { 1.0, 1.0, aspect } }));
    const Vector3 centre{ { 15.1, 14.8, 15.3 } };
    const std::vector<std::pair<const char*, Shape>> shapes{ { "sphere",
                                                               MakeSphere(1, centre, 11.0) },
      { "oblique plane", MakeHalfSpace(1, centre, Unit({ { 1.0, 2.0, 3.0 } })) },
      { "torus", MakeTorus(1, centre, 8.5, 4.5) } };
    for (const auto& shape : shapes)
    {
      const SurfaceError first = MeasureLabels(grid, shape.second, Order::SmoothThenCut);
      const SurfaceError second = MeasureLabels(grid, shape.second, Order::CutThenSmooth);
      std::printf("%-14s%8.0f%12.3f%10.1f%12.3f%10.1f\n", shape.first, aspect, first.Distance,
        first.Normal, second.Distance, second.Normal);
      before += first.Normal;
      after += second.Normal;
    }
  }
  EXPECT_LT(before, 0.9 * after);
}

/// Meshes a sphere in cells four times as long as wide, uncut and cut.
TEST(CellDivision, SpheresInLongCellsGetGoodElements)
{
  Runtime runtime;
  std::printf(
    "a sphere in cells of 1 x 1 x 4: largest aspect ratio of the cells. Hexahedra: number, "
    "smallest scaled Jacobian, rms "
    "distance in widths. Tetrahedra by Lattice: number, smallest and largest dihedral angle, "
    "scaled Jacobian, rms\n");
  for (Index n : { 24, 32 })
  {
    const CartesianGrid grid(MakeCells({ { n, n, n / 4 } }, { { 1.0, 1.0, 4.0 } }));
    const double middle = 0.5 * static_cast<double>(n), radius = 0.4 * static_cast<double>(n);
    const Vector3 centre{ { middle - 0.03, middle - 0.02, middle - 0.01 } };
    const FractionField field = FractionsOfShapes(grid, { MakeSphere(1, centre, radius) });
    const auto distance = [&](const Vector3& x) { return Norm(x - centre) - radius; };
    for (double ratio : { 4.0, 2.0, 1.5 })
    {
      const RefinedCells parts = Divide(grid, field, DivideLongCells(grid.Coordinates(), ratio));
      MeshReport report, tetReport;
      const Mesh hexes = MakeHexMesh(parts.Grid, parts.Fractions, MeshOptions(), runtime, report);
      const Mesh tets = MakeTetMesh(parts.Grid, parts.Fractions, MeshOptions(), runtime, tetReport);
      const double hexError = MeasureDistances(hexes, distance).RootMeanSquare;
      std::printf("%2lld x %2lld x %lld%6.2f%8zu%8.3f%8.4f%9zu%7.1f%7.1f%8.3f%8.4f\n",
        static_cast<long long>(n), static_cast<long long>(n), static_cast<long long>(n / 4),
        LargestAspectRatio(parts.Grid.Coordinates()), hexes.ElementIds.size(),
        report.MinimumScaledJacobian, hexError, tets.ElementIds.size(),
        tetReport.MinimumDihedralAngle, tetReport.MaximumDihedralAngle,
        tetReport.MinimumScaledJacobian, MeasureDistances(tets, distance).RootMeanSquare);
      EXPECT_NEAR(report.MeshVolume[1] / (4.0 / 3.0 * M_PI * std::pow(radius, 3)), 1.0, 1e-5);
      if (ratio == 1.5)
      {
        EXPECT_GE(report.MinimumScaledJacobian, 0.7);
        EXPECT_GE(tetReport.MinimumDihedralAngle, 25.0);
        EXPECT_LT(hexError, 0.055);
      }
    }
  }
}
