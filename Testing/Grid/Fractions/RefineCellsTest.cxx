/// Refinement before meshing: the children contain what the cell contained, plane
/// surfaces stay exact, ranks agree.
#include "Fractions/RefineCells.h"
#include "Base/Vector3.h"
#include "MeshCases.h"
#include "RankFields.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

Vector3 MiddleOf(const CartesianGrid& grid)
{
  Vector3 middle;
  for (int a = 0; a < 3; ++a)
  {
    middle[a] = 0.5 * (grid.Coordinates(a).front() + grid.Coordinates(a).back());
  }
  return middle;
}

RefinedCells Refine(const CartesianGrid& grid, const FractionField& field)
{
  Runtime runtime;
  return RefineCells(grid, field, runtime);
}

/// Returns the largest difference between the fraction of a cell and the mean over its children.
double LargestLoss(const CartesianGrid& grid, const FractionField& field, const RefinedCells& fine)
{
  double largest = 0.0;
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      for (int m = 0; m <= field.NumberOfMaterials(); ++m)
      {
        double sum = 0.0;
        for (int c = 0; c < 8; ++c)
        {
          const Index child = fine.Grid.Linear(
            { { 2 * p[0] + (c & 1), 2 * p[1] + (c >> 1 & 1), 2 * p[2] + (c >> 2) } });
          sum += fine.Fractions.Fraction(child, m);
        }
        largest = std::max(largest, std::fabs(sum / 8.0 - field.Fraction(grid.Linear(p), m)));
      }
    });
  return largest;
}

/// Deviation of fractions in refined cells from the exact fractions of the shapes.
struct Deviation
{
  double Largest = 0.0, Sum = 0.0;
  Index Children = 0; ///< number of children of mixed cells
  double Mean() const { return this->Sum / static_cast<double>(this->Children); }
};

Deviation CompareWithExact(const CartesianGrid& grid, const std::vector<Shape>& shapes)
{
  const FractionField field = FractionsOfShapes(grid, shapes);
  const RefinedCells fine = Refine(grid, field);
  Deviation deviation;
  ForCells(fine.Grid.Owned(),
    [&](const Index3& p)
    {
      std::vector<double> exact(CountMaterials(shapes) + 1, 0.0);
      exact[0] = 1.0;
      for (const FractionField::Part& part : ComputeShapeParts(shapes, fine.Grid.NodePoint(p),
             fine.Grid.NodePoint({ { p[0] + 1, p[1] + 1, p[2] + 1 } })))
      {
        exact[part.Material] = part.Fraction;
        exact[0] -= part.Fraction;
      }
      double largest = 0.0;
      for (int m = 0; m < static_cast<int>(exact.size()); ++m)
      {
        largest =
          std::max(largest, std::fabs(fine.Fractions.Fraction(fine.Grid.Linear(p), m) - exact[m]));
      }
      deviation.Largest = std::max(deviation.Largest, largest);
      if (field.IsMixed(grid.Linear({ { p[0] / 2, p[1] / 2, p[2] / 2 } })))
      {
        deviation.Sum += largest;
        ++deviation.Children;
      }
    });
  return deviation;
}

const std::vector<Vector3> Normals{ { { 1, 0, 0 } }, { { 0, -1, 0 } }, { { 0, 0, 1 } },
  { { 1, 1, 0 } }, { { 1, 2, 3 } }, { { -3, 1, 0.2 } }, { { 0.01, 0.02, -1 } }, { { 1, 1, 1 } },
  { { -5, 0, 2 } } };

} // namespace

TEST(RefineCells, HalvesTheWidths)
{
  const CartesianGrid grid = MakeUnevenGrid(5);
  const CartesianGrid fine = Refine(grid, FractionField(grid, 1)).Grid;
  EXPECT_EQ(fine.Global().Upper, (Index3{ { 10, 10, 10 } }));
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 0; i < 5; ++i)
    {
      EXPECT_EQ(fine.Coordinates(a)[2 * i], grid.Coordinates(a)[i]);
      EXPECT_NEAR(fine.Width(a, 2 * i), 0.5 * grid.Width(a, i), 1e-14);
      EXPECT_NEAR(fine.Width(a, 2 * i + 1), 0.5 * grid.Width(a, i), 1e-14);
    }
  }
}

TEST(RefineCells, LabelsGoToTheChildren)
{
  const CartesianGrid grid = MakeUnitGrid(7, 6, 5);
  const FractionField field = MakeRandomLabels(grid, 3, 0, 2);
  const RefinedCells fine = Refine(grid, field);
  ForCells(fine.Grid.Owned(),
    [&](const Index3& p)
    {
      const Index child = fine.Grid.Linear(p);
      ASSERT_FALSE(fine.Fractions.IsMixed(child));
      ASSERT_EQ(fine.Fractions.Label(child),
        field.Label(grid.Linear({ { p[0] / 2, p[1] / 2, p[2] / 2 } })));
    });
}

TEST(RefineCells, KeepsTheVolumesOfEveryCell)
{
  for (int materials = 1; materials <= 5; ++materials)
  {
    const CartesianGrid grid = materials % 2 ? MakeUnevenGrid(8) : MakeUnitGrid(9, 7, 1);
    const FractionField field = MakePatchyFractions(grid, materials, materials);
    const RefinedCells fine = Refine(grid, field);
    EXPECT_LT(LargestLoss(grid, field, fine), 1e-12) << materials << " materials";
    ForCells(fine.Grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = fine.Grid.Linear(p);
        if (!fine.Fractions.IsMixed(cell))
        {
          return;
        }
        double sum = 0.0;
        int last = -1;
        for (const FractionField::Part& part : fine.Fractions.Parts(cell))
        {
          ASSERT_GT(part.Fraction, 0.0);
          ASSERT_GT(part.Material, last) << "parts are in order";
          last = part.Material;
          sum += part.Fraction;
        }
        ASSERT_NEAR(sum, 1.0, 1e-13);
      });
  }
}

TEST(RefineCells, ChildrenMayBeLikeTheirParent)
{
  const CartesianGrid grid = MakeUnitGrid(6, 5, 4);
  const FractionField field = MakePatchyFractions(grid, 3, 3);
  Runtime runtime;
  const RefinedCells fine = RefineCells(grid, field, runtime, ChildRule::Parent);
  ForCells(fine.Grid.Local(),
    [&](const Index3& p)
    {
      EXPECT_TRUE(HaveSameParts(fine.Fractions, fine.Grid.Linear(p), field,
        grid.Linear({ { p[0] / 2, p[1] / 2, p[2] / 2 } })));
    });
  EXPECT_LT(LargestLoss(grid, field, fine), 1e-15);
}

TEST(RefineCells, HalfSpacesStayExact)
{
  for (const CartesianGrid& grid : { MakeUnitGrid(8), MakeUnevenGrid(8) })
  {
    for (const Vector3& normal : Normals)
    {
      const Vector3 point = MiddleOf(grid) + Vector3{ { 0.13, -0.21, 0.37 } };
      const std::vector<Shape> half{ MakeHalfSpace(1, point, normal) };
      const std::vector<Shape> filled{ MakeHalfSpace(1, point, normal),
        MakeHalfSpace(2, point, -1.0 * normal) };
      EXPECT_LT(CompareWithExact(grid, half).Largest, 1e-10) << ::testing::PrintToString(normal);
      EXPECT_LT(CompareWithExact(grid, filled).Largest, 1e-10) << ::testing::PrintToString(normal);
    }
  }
}

/// Returns two materials side by side, separated by one plane and bounded above by another.
std::vector<Shape> MakeCutHalfSpace(const Vector3& point, const Vector3& up, const Vector3& across)
{
  const Shape below = MakeHalfSpace(1, point, up);
  Shape right = CutShape(below, point, -1.0 * across);
  right.Material = 2;
  return { CutShape(below, point, across), right };
}

TEST(RefineCells, ThreePartsStayNear)
{
  for (const CartesianGrid& grid : { MakeUnitGrid(8), MakeUnevenGrid(8) })
  {
    const Vector3 point = MiddleOf(grid) + Vector3{ { 0.13, -0.21, 0.37 } };
    const auto straight = MakeCutHalfSpace(point, { { 0, 0, 1 } }, { { 3, 1, 0 } });
    EXPECT_LT(CompareWithExact(grid, straight).Largest, 1e-10);
    const auto oblique = MakeCutHalfSpace(point, { { 1, 2, 3 } }, { { 3, 0, -1 } });
    EXPECT_LT(CompareWithExact(grid, oblique).Largest, 0.06);
  }
}

/// Films about one cell thick are also found, unless one layer of cells contains them:
/// then their position is unknown.
TEST(RefineCells, FilmsStayNear)
{
  const std::map<double, double> largest{ { 0.6, 0.06 }, { 0.9, 0.02 }, { 1.2, 1e-3 } };
  for (const auto& entry : largest)
  {
    for (const CartesianGrid& grid : { MakeUnitGrid(8), MakeUnevenGrid(8) })
    {
      double sum = 0.0;
      for (const Vector3& normal : Normals)
      {
        const Vector3 point = MiddleOf(grid) + Vector3{ { 0.13, -0.21, 0.37 } };
        const Shape film = MakePlate(1, point, normal, entry.first * grid.MeanWidth());
        sum += CompareWithExact(grid, { film }).Mean();
      }
      EXPECT_LT(sum / static_cast<double>(Normals.size()), entry.second)
        << "thickness " << entry.first;
    }
  }
}

TEST(RefineCells, FilmsOfAGridOneCellThickStayNear)
{
  const CartesianGrid grid = MakeUnitGrid(10, 10, 1);
  const Vector3 point = MiddleOf(grid) + Vector3{ { 0.13, -0.21, 0.0 } };
  EXPECT_LT(CompareWithExact(grid, { MakePlate(1, point, { { 1, 2, 0 } }, 0.9) }).Mean(), 0.01);
}

TEST(RefineCells, RefusesGridsWhoseIdsWouldNotFit)
{
  std::vector<double> x(140001);
  std::iota(x.begin(), x.end(), 0.0);
  const CartesianGrid grid(std::array<std::vector<double>, 3>{ { x, x, x } },
    { { { 5, 5, 5 } }, { { 6, 6, 6 } } }, GhostLayers);
  EXPECT_THROW(Refine(grid, FractionField(grid, 1)), InputError);
}

TEST(RefineCells, RanksHoldWhatTheWholeGridHolds)
{
  const CartesianGrid whole = MakeUnevenGrid(8);
  const FractionField field = MakePatchyFractions(whole, 3, 7);
  RefinedCells all = Refine(whole, field);
  all = Refine(all.Grid, all.Fractions);
  for (int ranks : { 2, 8 })
  {
    std::vector<IndexBox> boxes = CutBox(whole.Global(), ranks);
    boxes.push_back(IndexBox()); // a rank without cells
    for (const IndexBox& box : boxes)
    {
      const CartesianGrid grid = MakeRankGrid(whole, box);
      RefinedCells part = Refine(grid, CopyToLocal(whole, field, grid));
      part = Refine(part.Grid, part.Fractions);
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_EQ(part.Grid.Owned().Lower[a], 4 * box.Lower[a]);
        EXPECT_EQ(part.Grid.Owned().Upper[a], 4 * box.Upper[a]);
        EXPECT_TRUE(box.NumberOfCells() == 0 ||
          part.Grid.Local().Lower[a] == std::max<Index>(4 * box.Lower[a] - GhostLayers, 0));
      }
      EXPECT_EQ(part.Grid.Global().Upper, all.Grid.Global().Upper);
      Index differences = 0;
      ForCells(part.Grid.Local(),
        [&](const Index3& p)
        {
          differences +=
            !HaveSameParts(part.Fractions, part.Grid.Linear(p), all.Fractions, all.Grid.Linear(p));
        });
      EXPECT_EQ(differences, 0) << ranks << " ranks";
    }
  }
}

TEST(RefineCells, MeshesComeNearerToTheSurface)
{
  Runtime runtime;
  std::printf("%s", FormatHeader().c_str());
  for (const char* name : { "sphere 8", "sphere 16", "plate 2 thick", "ball of 3 sectors" })
  {
    const MeshCase c = MakeMeshCase(name);
    const RefinedCells fine = Refine(c.Grid, c.Fractions);
    MeshCase refined = c;
    refined.Grid = fine.Grid;
    refined.Fractions = fine.Fractions;
    const MeshFigures before = MeasureCase(c, MeshOptions(), runtime);
    const MeshFigures after = MeasureCase(refined, MeshOptions(), runtime);
    std::printf("%s%s", FormatFigures(name, before).c_str(),
      FormatFigures(std::string(name) + ", refined", after).c_str());
    EXPECT_EQ(FindTopologyProblem(after.Result), "");
    EXPECT_GT(SmallestCornerDeterminant(after.Result), 0.0);
    EXPECT_LT(after.Distance.RootMeanSquare, 0.6 * before.Distance.RootMeanSquare);
    EXPECT_LT(after.VolumeError, 1e-5);
    for (std::size_t m = 1; m < before.Report.TargetVolume.size(); ++m)
    {
      EXPECT_NEAR(after.Report.TargetVolume[m] / before.Report.TargetVolume[m], 1.0, 1e-9);
    }
  }
}

TEST(RefineCells, ChildrenLikeTheirParentAndNoneWhereNotRequested)
{
  const CartesianGrid grid({ { { 0.0, 1.0, 2.0 }, { 0.0, 1.0 }, { 0.0, 1.0 } } });
  FractionField field(grid, 2);
  field.SetParts(grid.Linear({ { 0, 0, 0 } }), { { 1, 0.25 }, { 2, 0.5 } });
  field.SetLabel(grid.Linear({ { 1, 0, 0 } }), 2);
  Runtime runtime;
  const RefinedCells fine = RefineCells(
    grid, field, runtime, ChildRule::Parent, [](const Index3& cell) { return cell[0] == 1; });
  for (int c = 0; c < 8; ++c)
  {
    const Index child = fine.Grid.Linear(ChildOfCell({ { 0, 0, 0 } }, c));
    EXPECT_EQ(fine.Fractions.Fraction(child, 0), 0.25);
    EXPECT_EQ(fine.Fractions.Fraction(child, 1), 0.25);
    EXPECT_EQ(fine.Fractions.Fraction(child, 2), 0.5);
    EXPECT_EQ(fine.Fractions.Label(fine.Grid.Linear(ChildOfCell({ { 1, 0, 0 } }, c))), 0);
  }
}

TEST(RefineCells, KnownChildrenReplaceTheRule)
{
  const CartesianGrid grid({ { { 0.0, 1.0, 2.0 }, { 0.0, 1.0 }, { 0.0, 1.0 } } });
  FractionField field(grid, 1);
  field.SetParts(grid.Linear({ { 0, 0, 0 } }), { { 1, 0.125 } });
  field.SetParts(grid.Linear({ { 1, 0, 0 } }), { { 1, 0.5 } });
  Runtime runtime;
  const RefinedCells fine = RefineCells(grid, field, runtime, ChildRule::Parent, {},
    [](const Index3& cell)
    {
      std::vector<std::vector<double>> children;
      if (cell[0] == 0)
      {
        children = { std::vector<double>(8, 1.0), std::vector<double>(8, 0.0) };
        std::swap(children[0][6], children[1][6]);
      }
      return children;
    });
  for (int c = 0; c < 8; ++c)
  {
    const Index known = fine.Grid.Linear(ChildOfCell({ { 0, 0, 0 } }, c));
    EXPECT_EQ(fine.Fractions.Label(known), c == 6 ? 1 : 0);
    EXPECT_EQ(fine.Fractions.Fraction(fine.Grid.Linear(ChildOfCell({ { 1, 0, 0 } }, c)), 1), 0.5);
  }
}
