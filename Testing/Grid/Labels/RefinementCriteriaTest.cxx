/// Marking of cells for refinement: thin and thick features, curvature, flipped
/// labels, layers, families, ranks.
#include "Labels/RefinementCriteria.h"
#include "Base/Vector3.h"
#include "Fractions/InterfaceCurvature.h"
#include "Fractions/ThinFeatures.h"
#include "Labels/ResolveLabels.h"
#include "MeshChecks.h"
#include "Octree/OctantFamilies.h"
#include "RankFields.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr int Cells = 20;
const Vector3 Middle{ { 10.13, 9.79, 10.37 } };
const Vector3 Turn{ { 33.0, 21.0, 10.0 } };
const std::vector<Vector3> Normals{ { { 1, 0, 0 } }, { { 1, 2, 3 } }, { { 0.2, 1, 0.1 } },
  { { 1, 1, 1 } }, { { 1, 1, 0 } } };

FractionField Fill(const CartesianGrid& grid, const std::vector<Shape>& shapes)
{
  return FractionsOfShapes(grid, shapes);
}

RefinementRequests RequestsOf(
  const CartesianGrid& grid, const FractionField& field, const RefinementCriteria& criteria)
{
  Runtime runtime;
  return FindRefinement(grid, field, criteria, 0.5, Partition(grid, runtime.Group()), runtime);
}

RefinementCriteria ThinOnly(double cells, int level)
{
  RefinementCriteria criteria;
  criteria.ThinCells = cells;
  criteria.MaximumLevel = level;
  return criteria;
}

RefinementCriteria LabelsOnly(bool flipped, int layers)
{
  RefinementCriteria criteria = ThinOnly(0.0, 2);
  criteria.FlippedCells = flipped;
  criteria.InterfaceLayers = layers;
  return criteria;
}

RefinementCriteria AllCriteria()
{
  RefinementCriteria criteria = ThinOnly(2.0, 3);
  criteria.CurvaturePerCell = 0.3;
  criteria.FlippedCells = true;
  criteria.InterfaceLayers = 2;
  criteria.Chosen = { { { { { 1, 1, 1 } }, { { 9, 4, 3 } } }, 2 },
    { { { { 3, 2, 0 } }, { { 5, 14, 2 } } }, 3 } };
  return criteria;
}

std::map<Index, int> ToMap(const std::vector<RefinementRequest>& requests)
{
  std::map<Index, int> map;
  for (const RefinementRequest& request : requests)
  {
    EXPECT_TRUE(map.emplace(request.Cell, request.Halvings).second);
  }
  return map;
}

/// Returns the sorted thickness of a material's region at each cell with a fraction above `part`.
std::vector<double> Thicknesses(
  const CartesianGrid& grid, const FractionField& field, int material, double part)
{
  std::vector<double> all;
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      if (field.Fraction(grid.Linear(p), material) > part)
      {
        all.push_back(FindThickness(grid, field, p, material, LargestThickness));
      }
    });
  std::sort(all.begin(), all.end());
  return all;
}

/// Returns the share of cells on a surface that request at least `halvings`
/// halvings. Cells near the domain boundary are excluded: there an oblique plate and
/// its mirror image form one thick edge.
double PartToRefine(const CartesianGrid& grid, const RefinementRequests& requests, int halvings,
  const std::function<bool(const Index3&)>& goesThrough)
{
  const std::map<Index, int> map = ToMap(requests.Cells);
  Index cells = 0, asking = 0;
  ForCells({ { { 4, 4, 4 } }, { { Cells - 4, Cells - 4, Cells - 4 } } },
    [&](const Index3& p)
    {
      if (goesThrough(p))
      {
        const auto at = map.find(grid.CellKey(p));
        ++cells;
        asking += at != map.end() && at->second >= halvings;
      }
    });
  EXPECT_GT(cells, 0);
  return static_cast<double>(asking) / static_cast<double>(cells);
}

/// Returns whether a plane through Middle cuts a cell.
bool Cuts(const Vector3& normal, const Index3& p)
{
  double distance = 0.0, half = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    distance += normal[a] * (static_cast<double>(p[a]) + 0.5 - Middle[a]);
    half += 0.5 * std::fabs(normal[a]);
  }
  return std::fabs(distance) < 0.98 * half;
}

} // namespace

TEST(ThinFeatures, FindTheThicknessOfFilms)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  for (double thickness : { 0.4, 0.7, 1.0, 1.5, 2.0 })
  {
    for (const Vector3& normal : Normals)
    {
      const FractionField film = Fill(grid, { MakePlate(1, Middle, normal, thickness) });
      const std::vector<double> found = Thicknesses(grid, film, 1, 1e-3);
      const double median = found[found.size() / 2];
      EXPECT_NEAR(median, thickness, 0.25) << ::testing::PrintToString(normal);
      EXPECT_GT(found.front(), 0.75 * thickness) << ::testing::PrintToString(normal);
    }
  }
}

TEST(ThinFeatures, GapsAreAsThickAsFilms)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  const Vector3 normal = Unit({ { 1, 2, 3 } });
  const FractionField field = Fill(grid,
    { MakeHalfSpace(1, Middle - 0.5 * normal, normal),
      MakeHalfSpace(2, Middle + 0.5 * normal, -1.0 * normal) });
  const std::vector<double> gap = Thicknesses(grid, field, 0, 1e-3);
  EXPECT_NEAR(gap[gap.size() / 2], 1.0, 0.2);
  EXPECT_GT(Thicknesses(grid, field, 1, 1e-3).front(), 2.5);
  EXPECT_GT(Thicknesses(grid, field, 2, 1e-3).front(), 2.5);
}

TEST(ThinFeatures, ThickBodiesAreThickEverywhere)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  const double size = 12.0;
  for (const Shape& shape : { MakeSphere(1, Middle, 2.5), MakeSphere(1, Middle, 6.0),
         MakeBox(1, Middle, { { size, size, size } }),
         MakeBox(1, Middle, { { size, size, size } }, Turn),
         MakeCylinder(1, Middle, 3.0, size, Turn), MakeTorus(1, Middle, 6.0, 2.0, Turn) })
  {
    const FractionField field = Fill(grid, { shape });
    EXPECT_GT(Thicknesses(grid, field, 1, 1e-3).front(), 2.0) << static_cast<int>(shape.Kind);
    EXPECT_GT(Thicknesses(grid, field, 0, 1e-3).front(), 2.0) << static_cast<int>(shape.Kind);
    EXPECT_EQ(RequestsOf(grid, field, ThinOnly(2.0, 2)).AllCells, 0)
      << static_cast<int>(shape.Kind);
  }
}

TEST(ThinFeatures, RodsAndBallsThinnerThanTwoCellsAreThin)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  for (double diameter : { 0.7, 1.0, 1.5 })
  {
    for (const Shape& shape : { MakeSphere(1, Middle, 0.5 * diameter),
           MakeCylinder(1, Middle, 0.5 * diameter, 12.0, Turn) })
    {
      const FractionField field = Fill(grid, { shape });
      const std::vector<double> found = Thicknesses(grid, field, 1, 1e-3);
      EXPECT_LT(found.back(), 1.1 * diameter);
      EXPECT_GT(RequestsOf(grid, field, ThinOnly(2.0, 1)).ThinCells, 0);
    }
  }
}

TEST(ThinFeatures, TheSidesOfTheDomainAreMirrors)
{
  const CartesianGrid grid = MakeUnitGrid(8);
  const FractionField field = Fill(grid, { MakeHalfSpace(1, { { 0.6, 0, 0 } }, { { 1, 0, 0 } }) });
  EXPECT_NEAR(FindThickness(grid, field, { { 0, 4, 4 } }, 1, LargestThickness), 1.2, 0.05);
}

TEST(Curvature, IsThatOfBalls)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  Runtime runtime;
  // A few cells overestimate the curvature.
  const std::map<double, double> ratios{ { 2.0, 1.6 }, { 3.0, 1.3 }, { 5.0, 1.15 }, { 8.0, 1.06 } };
  for (const auto& entry : ratios)
  {
    const FractionField ball = Fill(grid, { MakeSphere(1, Middle, entry.first) });
    const std::vector<CellCurvature> found = FindCurvatures(grid, ball, runtime);
    ASSERT_FALSE(found.empty());
    for (const CellCurvature& c : found)
    {
      EXPECT_GT(c.Curvature * entry.first, 0.98) << entry.first;
      EXPECT_LT(c.Curvature * entry.first, entry.second) << entry.first;
    }
  }
}

TEST(Curvature, PlanesHaveNone)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  Runtime runtime;
  for (const Vector3& normal : Normals)
  {
    const FractionField field = Fill(grid, { MakeHalfSpace(1, Middle, normal) });
    for (const CellCurvature& c : FindCurvatures(grid, field, runtime))
    {
      EXPECT_LT(c.Curvature, 0.15) << ::testing::PrintToString(normal);
    }
  }
}

TEST(Curvature, SurvivesNoise)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  Runtime runtime;
  const FractionField ball = Fill(grid, { MakeSphere(1, Middle, 6.0) });
  FractionField noisy(grid, 1);
  ForCells(grid.Local(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      const double noise = 0.02 * std::sin(12.9898 * p[0] + 78.233 * p[1] + 37.719 * p[2]);
      const double fraction = ball.Fraction(cell, 1);
      if (ball.IsMixed(cell))
      {
        noisy.SetParts(cell, { { 1, std::min(std::max(fraction + noise, 1e-6), 1.0 - 1e-6) } });
      }
      else
      {
        noisy.SetLabel(cell, ball.Label(cell));
      }
    });
  std::vector<double> found;
  for (const CellCurvature& c : FindCurvatures(grid, noisy, runtime))
  {
    found.push_back(c.Curvature);
  }
  std::sort(found.begin(), found.end());
  EXPECT_NEAR(found[found.size() / 2], 1.0 / 6.0, 0.03);
  EXPECT_LT(found[found.size() * 19 / 20], 0.3);
}

TEST(RefinementCriteria, EveryCellOfAThinPlateRequests)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  const std::map<double, int> halvings{ { 0.4, 2 }, { 1.0, 1 }, { 1.5, 1 } };
  for (const auto& entry : halvings)
  {
    for (const Vector3& normal : Normals)
    {
      const FractionField field = Fill(grid, { MakePlate(1, Middle, normal, entry.first) });
      const RefinementRequests requests = RequestsOf(grid, field, ThinOnly(2.0, 3));
      EXPECT_GE(PartToRefine(grid, requests, entry.second,
                  [&normal](const Index3& p) { return Cuts(normal, p); }),
        0.99)
        << entry.first << " " << ::testing::PrintToString(normal);
      EXPECT_GE(requests.Refinements, entry.second);
      EXPECT_EQ(RequestsOf(grid, field, ThinOnly(2.0, 1)).Refinements, 1);
    }
  }
}

TEST(RefinementCriteria, FilmsBetweenMaterialsAreFoundToo)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  const Vector3 normal{ { 1, 2, 3 } };
  const FractionField field = Fill(grid,
    { MakePlate(3, Middle, normal, 1.0), MakeHalfSpace(1, Middle, normal),
      MakeHalfSpace(2, Middle, -1.0 * normal) });
  const RefinementRequests requests = RequestsOf(grid, field, ThinOnly(2.0, 1));
  EXPECT_GE(
    PartToRefine(grid, requests, 1, [&normal](const Index3& p) { return Cuts(normal, p); }), 0.99);
}

TEST(RefinementCriteria, OneLayerOfPureCellsIsThin)
{
  const CartesianGrid grid = MakeUnitGrid(9);
  const FractionField field = MakeLabels(grid, 1, [](const Index3& p) { return p[2] == 4; });
  const RefinementRequests requests = RequestsOf(grid, field, ThinOnly(2.0, 1));
  EXPECT_EQ(requests.ThinCells, 81);
  EXPECT_EQ(requests.AllCells, 81);
}

TEST(RefinementCriteria, SpecksRequestNothing)
{
  const CartesianGrid grid = MakeUnitGrid(9);
  FractionField field(grid, 1);
  field.SetParts(grid.Linear({ { 4, 4, 4 } }), { { 1, 1e-4 } });
  EXPECT_EQ(RequestsOf(grid, field, ThinOnly(2.0, 3)).AllCells, 0);
}

TEST(RefinementCriteria, SmallRadiiRequestHalvings)
{
  const CartesianGrid grid = MakeUnitGrid(Cells);
  RefinementCriteria criteria = ThinOnly(0.0, 3);
  criteria.CurvaturePerCell = 0.25;
  const auto ask = [&](double radius)
  { return RequestsOf(grid, Fill(grid, { MakeSphere(1, Middle, radius) }), criteria); };
  EXPECT_EQ(ask(8.0).AllCells, 0);
  const RefinementRequests small = ask(3.0), smaller = ask(1.5);
  EXPECT_EQ(small.Refinements, 1);
  EXPECT_GT(small.CurvedCells, 100);
  EXPECT_EQ(small.CurvedCells, small.AllCells);
  EXPECT_EQ(smaller.Refinements, 2);
}

TEST(RefinementCriteria, FlippedCellsRequestOne)
{
  const CartesianGrid grid = MakeUnitGrid(10);
  const FractionField field = MakeRandomLabels(grid, 2, 0, 5);
  Runtime runtime;
  const LabelArray before = AssignMaterials(grid, field, 0.5);
  LabelArray after = before;
  ResolveLabels(grid, field, after, Partition(grid, runtime.Group()), runtime);
  std::map<Index, int> expected;
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      if (before[grid.Linear(p)] != after[grid.Linear(p)])
      {
        expected[grid.CellKey(p)] = 1;
      }
    });
  const RefinementRequests requests = RequestsOf(grid, field, LabelsOnly(true, 0));
  EXPECT_FALSE(expected.empty());
  EXPECT_TRUE(ToMap(requests.Cells) == expected);
  EXPECT_EQ(requests.FlippedCells, static_cast<Index>(expected.size()));
}

TEST(RefinementCriteria, LayersCountFromTheInterface)
{
  const CartesianGrid grid = MakeUnitGrid(12);
  const FractionField field = MakeLabels(
    grid, 1, [](const Index3& p) { return p[0] >= 4 && p[0] < 7 && p[1] >= 4 && p[2] < 5; });
  for (int layers = 0; layers <= 5; ++layers)
  {
    const RefinementRequests requests = RequestsOf(grid, field, LabelsOnly(false, layers));
    const std::map<Index, int> map = ToMap(requests.Cells);
    ForCells(grid.Owned(),
      [&](const Index3& p)
      {
        bool isNear = false; // another label within `layers` cells
        ForCells(grid.Owned(),
          [&](const Index3& q)
          {
            Index distance = 0;
            for (int a = 0; a < 3; ++a)
            {
              distance = std::max<Index>(distance, std::abs(p[a] - q[a]));
            }
            isNear = isNear ||
              (distance <= layers && field.Label(grid.Linear(p)) != field.Label(grid.Linear(q)));
          });
        ASSERT_EQ(map.count(grid.CellKey(p)) > 0, isNear) << layers;
        ASSERT_TRUE(!isNear || map.at(grid.CellKey(p)) == 2);
      });
  }
}

TEST(RefinementCriteria, ChosenCellsRequestTheirHalvings)
{
  const CartesianGrid grid = MakeUnitGrid(6, 5, 4);
  const IndexBox first{ { { 0, 1, 1 } }, { { 3, 3, 2 } } },
    second{ { { 2, 2, 0 } }, { { 5, 4, 4 } } };
  RefinementCriteria criteria = ThinOnly(0.0, 2);
  criteria.Chosen = { { second, 1 }, { first, 3 }, { { { { 5, 4, 3 } }, { { 9, 9, 9 } } }, 1 },
    { { { { 0, 0, 0 } }, { { 1, 1, 1 } } }, 0 } };
  std::map<Index, int> expected{ { grid.CellKey({ { 5, 4, 3 } }), 1 } };
  ForCells(second, [&](const Index3& p) { expected[grid.CellKey(p)] = 1; });
  ForCells(first, [&](const Index3& p) { expected[grid.CellKey(p)] = 2; }); // the maximum level
  const RefinementRequests requests = RequestsOf(grid, FractionField(grid, 1), criteria);
  EXPECT_TRUE(ToMap(requests.Cells) == expected);
  EXPECT_EQ(requests.Refinements, 2);
  EXPECT_EQ(requests.ChosenCells, static_cast<Index>(expected.size()));
  EXPECT_EQ(requests.AllCells, requests.ChosenCells);
  criteria.MaximumLevel = 0;
  EXPECT_EQ(RequestsOf(grid, FractionField(grid, 1), criteria).ChosenCells, 0);
}

namespace
{

/// Returns, for each level, the families of all cells that a request covers,
/// with `layers` layers around it.
std::vector<std::set<Index>> FamiliesAround(
  const OctreeKeys& lattice, const RefinementRequests& requests, int layers)
{
  std::vector<std::set<Index>> families(requests.Refinements);
  const CartesianGrid& grid = lattice.Base();
  for (const RefinementRequest& request : requests.Cells)
  {
    const Index nx = grid.Global().Upper[0], ny = grid.Global().Upper[1];
    const Index3 cell{ { request.Cell % nx, request.Cell / nx % ny, request.Cell / (nx * ny) } };
    const Index along = (Index(1) << request.Halvings) + 2 * layers;
    ForCells({ { { 0, 0, 0 } }, { { along, along, along } } },
      [&](const Index3& d)
      {
        Index3 p;
        for (int a = 0; a < 3; ++a)
        {
          p[a] = (cell[a] << request.Halvings) + d[a] - layers;
        }
        for (int level = 0; level < request.Halvings && lattice.HasCell(request.Halvings, p);
             ++level)
        {
          const int shift = request.Halvings - level + 1;
          families[level].insert(
            lattice.FamilyKey(level, { { p[0] >> shift, p[1] >> shift, p[2] >> shift } }));
        }
      });
  }
  return families;
}

} // namespace

TEST(RefinementCriteria, FamiliesHoldWhatIsRequested)
{
  const CartesianGrid grid = MakeUnitGrid(7, 6, 5);
  const OctreeKeys lattice(grid, 3);
  RefinementRequests requests;
  requests.Refinements = 3;
  requests.Cells = { { grid.CellKey({ { 1, 2, 3 } }), 1 }, { grid.CellKey({ { 2, 2, 3 } }), 2 },
    { grid.CellKey({ { 6, 5, 4 } }), 3 } };
  for (int layers : { 0, 1, 2, 3, 5, 9 })
  {
    const std::vector<std::vector<Index>> families =
      FindRequestedFamilies(lattice, requests, layers);
    const std::vector<std::set<Index>> expected = FamiliesAround(lattice, requests, layers);
    ASSERT_EQ(families.size(), 3u);
    for (int level = 0; level < 3; ++level)
    {
      EXPECT_TRUE(
        families[level] == std::vector<Index>(expected[level].begin(), expected[level].end()))
        << layers << " layers, level " << level;
    }
  }
  EXPECT_EQ(
    OctantFamilies(lattice, FindRequestedFamilies(lattice, requests)).Report(2).Requested, 8);
}

TEST(RefinementCriteria, FamiliesHoldTheRequestsOfALevel)
{
  const CartesianGrid base = MakeUnitGrid(7, 6, 5), halves = MakeUnitGrid(14, 12, 10);
  const OctreeKeys lattice(base, 3), ofHalves(halves, 2);
  const IndexBox box{ { { 3, 4, 1 } }, { { 6, 5, 4 } } };
  for (int layers : { 0, 2, 3 })
  {
    RefinementRequests requests;
    requests.Refinements = 2;
    ForCells(box, [&](const Index3& p) { requests.Cells.push_back({ halves.CellKey(p), 2 }); });
    const std::vector<std::set<Index>> expected = FamiliesAround(ofHalves, requests, layers);
    std::vector<std::vector<Index>> families(3);
    AddRequestedFamilies(lattice, 1, { box, 2 }, layers, families);
    EXPECT_TRUE(families[0].empty());
    for (int level = 1; level < 3; ++level)
    {
      EXPECT_TRUE(
        std::set<Index>(families[level].begin(), families[level].end()) == expected[level - 1])
        << layers << " layers, level " << level;
    }
  }
}

TEST(RefinementCriteria, RanksAgree)
{
  const CartesianGrid whole = MakeUnevenGrid(14);
  const double size = whole.Coordinates(0).back();
  const Vector3 middle{ { 0.5 * size, 0.7 * size, 0.9 * size } };
  const FractionField field = Fill(
    whole, { MakePlate(1, middle, { { 1, 2, 3 } }, 1.2), MakeSphere(2, 0.6 * middle, 0.2 * size) });
  const RefinementRequests alone = RequestsOf(whole, field, AllCriteria());
  ASSERT_GT(alone.ThinCells, 0);
  ASSERT_GT(alone.CurvedCells, 0);
  ASSERT_GT(alone.NearCells, 0);
  ASSERT_EQ(alone.ChosenCells, 48 + 48 - 4);
  ASSERT_GT(alone.AllCells, 0);
  for (int ranks : { 2, 3, 4, 8 })
  {
    std::vector<IndexBox> boxes = CutBox(whole.Global(), ranks, ranks == 3 ? 0 : -1);
    boxes.push_back(IndexBox()); // a rank without cells
    std::map<Index, int> merged;
    std::mutex lock;
    RunOnRanks(static_cast<int>(boxes.size()),
      [&](Ranks& group)
      {
        RankRuntime runtime(group);
        const CartesianGrid grid = MakeRankGrid(whole, boxes[group.Rank()]);
        const RefinementRequests mine = FindRefinement(grid, CopyToLocal(whole, field, grid),
          AllCriteria(), 0.5, Partition(grid, group), runtime);
        const std::lock_guard<std::mutex> guard(lock);
        EXPECT_EQ(mine.Refinements, alone.Refinements);
        EXPECT_EQ(mine.ThinCells, alone.ThinCells);
        EXPECT_EQ(mine.CurvedCells, alone.CurvedCells);
        EXPECT_EQ(mine.FlippedCells, alone.FlippedCells);
        EXPECT_EQ(mine.NearCells, alone.NearCells);
        EXPECT_EQ(mine.ChosenCells, alone.ChosenCells);
        EXPECT_EQ(mine.AllCells, alone.AllCells);
        for (const auto& request : ToMap(mine.Cells))
        {
          EXPECT_TRUE(merged.insert(request).second);
        }
      });
    EXPECT_TRUE(merged == ToMap(alone.Cells)) << ranks << " ranks";
  }
}

TEST(RefinementCriteria, NothingIsRequestedWhenAllIsOff)
{
  const CartesianGrid grid = MakeUnitGrid(8);
  const FractionField field = MakeRandomLabels(grid, 2, 0, 1);
  EXPECT_EQ(RequestsOf(grid, field, LabelsOnly(false, 0)).AllCells, 0);
  RefinementCriteria criteria = AllCriteria();
  criteria.MaximumLevel = 0;
  EXPECT_EQ(RequestsOf(grid, field, criteria).AllCells, 0);
  EXPECT_EQ(RequestsOf(grid, field, criteria).Refinements, 0);
}

TEST(RefinementCriteria, RefusesWhatIsOutOfRange)
{
  const CartesianGrid grid = MakeUnitGrid(4);
  const FractionField field(grid, 1);
  EXPECT_THROW(RequestsOf(grid, field, ThinOnly(3.5, 1)), InputError);
  EXPECT_THROW(RequestsOf(grid, field, ThinOnly(std::nan(""), 1)), InputError);
  EXPECT_THROW(RequestsOf(grid, field, ThinOnly(2.0, -1)), InputError);
  RefinementCriteria criteria;
  criteria.CurvaturePerCell = std::nan("");
  EXPECT_THROW(RequestsOf(grid, field, criteria), InputError);
}
