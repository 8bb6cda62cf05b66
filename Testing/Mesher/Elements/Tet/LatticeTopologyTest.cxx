/// Tetrahedra of the lattice are valid and conforming before smoothing, for any
/// fractions, and the same on any ranks.
#include "Elements/Tet/LatticeTopology.h"
#include "Base/Vector3.h"
#include "Elements/TetQuality.h"
#include "MeshChecks.h"
#include "NoCoarseTets.h"
#include "RankFields.h"
#include "Shapes/ShapesFractions.h"
#include "Sweep.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Triangle = std::array<Index, 3>;

TetTopology BuildAlone(const CartesianGrid& grid, const FractionField& fractions, bool meshVoid)
{
  Runtime runtime;
  const Partition partition(grid, runtime.Group());
  const LabelArray labels = MakeResolvedLabels(grid, fractions, partition, runtime);
  LatticeNodes nodes(grid, fractions, labels, 0.5, partition, runtime);
  return BuildLatticeTets(
    grid, nodes, meshVoid, NarrowVoid(), partition, runtime, NoCoarseTets(grid, runtime).Tets)
    .Topology;
}

CartesianGrid MakeUnevenGrid(Index nx, Index ny, Index nz)
{
  const CartesianGrid unit = MakeUnitGrid(nx, ny, nz);
  std::array<std::vector<double>, 3> x{ { unit.Coordinates(0), unit.Coordinates(1),
    unit.Coordinates(2) } };
  for (std::vector<double>& axis : x)
  {
    std::for_each(
      axis.begin(), axis.end(), [](double& at) { at += 0.3 + 0.25 * std::sin(1.7 * at); });
  }
  return CartesianGrid(x);
}

FractionField MakeRandomFractions(const CartesianGrid& grid, int materials, unsigned seed)
{
  FractionField field(grid, materials);
  std::mt19937 engine(seed);
  const Index3& n = grid.Global().Upper;
  for (Index cell = 0; cell < n[0] * n[1] * n[2]; ++cell)
  {
    std::vector<FractionField::Part> parts;
    double sum = (engine() % 100) / 100.0; // fraction of void
    for (int m = 1; m <= materials; ++m)
    {
      parts.push_back({ m, 0.01 + (engine() % 100) / 100.0 });
      sum += parts.back().Fraction;
    }
    for (FractionField::Part& part : parts)
    {
      part.Fraction /= sum;
    }
    field.SetParts(
      grid.Linear({ { cell % n[0], cell / n[0] % n[1], cell / (n[0] * n[1]) } }), parts);
  }
  return field;
}

/// Sums and extremes over many meshes.
struct Sums
{
  std::size_t Tets = 0;
  int NonManifoldEdges = 0;
  double Lowest = 180.0, Highest = 0.0; // dihedral angles in cubic cells
};

double SixVolumes(const double* points, const Index* tet)
{
  Vector3 x[4];
  for (int c = 0; c < 4; ++c)
  {
    const double* p = points + 3 * tet[c];
    x[c] = { { p[0], p[1], p[2] } };
  }
  return Dot(Cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]);
}

/// Checks that at most two tets share a triangle; returns the boundary triangles of each material.
std::map<int, std::vector<Triangle>> BoundariesOf(const Mesh& mesh)
{
  std::map<Triangle, std::vector<int>> materials;
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    const Index* p = mesh.Elements.data() + 4 * t;
    for (int c = 0; c < 4; ++c)
    {
      Triangle triangle{ { p[(c + 1) % 4], p[(c + 2) % 4], p[(c + 3) % 4] } };
      std::sort(triangle.begin(), triangle.end());
      materials[triangle].push_back(mesh.Material[t]);
    }
  }
  std::map<int, std::vector<Triangle>> boundaries;
  for (const auto& triangle : materials)
  {
    const std::vector<int>& sides = triangle.second;
    EXPECT_LE(sides.size(), 2u);
    for (int material : sides)
    {
      if (sides.front() != sides.back() || sides.size() == 1)
      {
        boundaries[material].push_back(triangle.first);
      }
    }
  }
  return boundaries;
}

/// Counts the edges where the boundary of a material touches itself.
int CountNonManifoldEdges(const Mesh& mesh)
{
  int count = 0;
  for (const auto& boundary : BoundariesOf(mesh))
  {
    std::map<std::pair<Index, Index>, int> edges;
    for (const Triangle& t : boundary.second)
    {
      ++edges[{ t[0], t[1] }];
      ++edges[{ t[0], t[2] }];
      ++edges[{ t[1], t[2] }];
    }
    for (const auto& edge : edges)
    {
      EXPECT_EQ(edge.second % 2, 0) << "an open boundary";
      count += edge.second > 2;
    }
  }
  return count;
}

void CheckPoints(const CartesianGrid& grid, const TetTopology& topology, bool isUnit)
{
  const Mesh& mesh = topology.Tets;
  const std::set<Index> used(mesh.Elements.begin(), mesh.Elements.end());
  EXPECT_EQ(used.size(), mesh.PointIds.size());
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    const Index3 block = NodeOfPoint(grid, mesh, mesh.PointIds[p]);
    EXPECT_TRUE(p == 0 || mesh.PointIds[p] > mesh.PointIds[p - 1]);
    bool onDomain = false;
    for (int a = 0; a < 3; ++a)
    {
      const double x = mesh.Points[3 * p + a];
      onDomain = onDomain || x == grid.Coordinates(a).front() || x == grid.Coordinates(a).back();
      EXPECT_TRUE(!isUnit || block[a] == static_cast<Index>(std::floor(x + 1e-9)));
    }
    EXPECT_TRUE(topology.Positions[p] != PointPosition::Inside || !onDomain);
    EXPECT_TRUE(topology.Positions[p] != PointPosition::OnDomain || onDomain);
  }
}

/// Checks order, volumes and angles of the tets; returns the volume.
double CheckTets(const CartesianGrid& grid, const Mesh& mesh, Sums& sums)
{
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    EXPECT_TRUE(t == 0 || mesh.ElementIds[t] > mesh.ElementIds[t - 1]);
    const Index* tet = mesh.Elements.data() + 4 * t;
    const double v = SixVolumes(mesh.Points.data(), tet);
    EXPECT_GT(v, 0.0);
    volume += v / 6.0;
    double of[6];
    DihedralAngles(mesh.Points.data(), tet, of);
    sums.Lowest = std::min(sums.Lowest, *std::min_element(of, of + 6));
    sums.Highest = std::max(sums.Highest, *std::max_element(of, of + 6));
    for (int c = 0; c < 16; ++c)
    {
      const Index3 block = NodeOfPoint(grid, mesh, mesh.PointIds[tet[c / 4]]);
      const Index3 other = NodeOfPoint(grid, mesh, mesh.PointIds[tet[c % 4]]);
      EXPECT_TRUE(
        block == other || CartesianGrid::Parities(block) != CartesianGrid::Parities(other));
    }
  }
  return volume;
}

void Check(const CartesianGrid& grid, const FractionField& fractions, bool meshVoid, bool isFilled,
  Sums& sums)
{
  const TetTopology topology = BuildAlone(grid, fractions, meshVoid);
  const bool isUnit = grid.Coordinates(0)[0] == 0.0;
  CheckPoints(grid, topology, isUnit);
  Sums uneven;
  const double volume = CheckTets(grid, topology.Tets, isUnit ? sums : uneven);
  const auto length = [&](int a) { return grid.Coordinates(a).back() - grid.Coordinates(a)[0]; };
  if (isFilled)
  {
    EXPECT_NEAR(volume / (length(0) * length(1) * length(2)), 1.0, 1e-12);
  }
  sums.NonManifoldEdges += CountNonManifoldEdges(topology.Tets);
  sums.Tets += topology.Tets.ElementIds.size();
}

void Print(const std::string& name, const Sums& sums)
{
  std::printf("%s: %zu tets, dihedral angles %.2f to %.2f, %d non-manifold edges\n", name.c_str(),
    sums.Tets, sums.Lowest, sums.Highest, sums.NonManifoldEdges);
}

/// Tets by id: material, and id, coordinates and place of each corner.
using TetsById = std::map<Index, std::pair<int, std::array<std::array<double, 5>, 4>>>;

/// Adds the tets owned by a rank.
void Collect(const CartesianGrid& grid, const TetTopology& topology, TetsById& tets)
{
  const Mesh& mesh = topology.Tets;
  for (std::size_t t = 0; t < mesh.ElementIds.size(); ++t)
  {
    const Index id = mesh.ElementIds[t];
    if (!grid.Owned().Contains(CellOfElement(grid, mesh, id)))
    {
      continue;
    }
    EXPECT_EQ(tets.count(id), 0u);
    tets[id].first = mesh.Material[t];
    for (int c = 0; c < 4; ++c)
    {
      const Index p = mesh.Elements[4 * t + c];
      const double* x = mesh.Points.data() + 3 * p;
      tets[id].second[c] = { { static_cast<double>(mesh.PointIds[p]), x[0], x[1], x[2],
        static_cast<double>(topology.Positions[p]) } };
    }
  }
}

} // namespace

TEST(LatticeTopology, AnyFractionsGiveValidTets)
{
  for (int materials = 1; materials <= 5; ++materials)
  {
    Sums withVoid, filled, mixed;
    for (unsigned seed : ListSeeds(30))
    {
      const Index nx = 1 + seed % 5, ny = 1 + seed / 5 % 4, nz = 2 + seed % 4;
      const CartesianGrid grid = seed % 3 ? MakeUnitGrid(nx, ny, nz) : MakeUnevenGrid(nx, ny, nz);
      const bool meshVoid = seed % 2 != 0;
      Check(grid, MakeRandomLabels(grid, materials, 0, seed), meshVoid, meshVoid, withVoid);
      Check(grid, MakeRandomLabels(grid, materials, 1, seed), meshVoid, true, filled);
      Check(grid, MakeRandomFractions(grid, materials, seed), meshVoid, meshVoid, mixed);
    }
    const std::string name = std::to_string(materials) + " materials, ";
    Print(name + "random labels and void", withVoid);
    Print(name + "random labels", filled);
    Print(name + "random fractions", mixed);
    EXPECT_GT(mixed.Lowest, 6.5);
    EXPECT_LT(mixed.Highest, 160.0);
  }
}

TEST(LatticeTopology, SphereStartsWithFairAngles)
{
  const CartesianGrid grid = MakeUnitGrid(22);
  const Shape sphere = MakeSphere(1, { { 11.1, 10.9, 11.2 } }, 8.0);
  Sums sums;
  Check(grid, FractionsOfShapes(grid, { sphere }), false, false, sums);
  Print("sphere", sums);
  EXPECT_GT(sums.Lowest, 18.0);
  EXPECT_LT(sums.Highest, 147.0);
  EXPECT_EQ(sums.NonManifoldEdges, 0);
}

TEST(LatticeTopology, RanksMakeTheTetsOfOneProcess)
{
  const CartesianGrid whole = MakeUnevenGrid(17, 9, 10);
  for (int count : { 2, 3, 5, 8 })
  {
    const bool meshVoid = count % 2 == 0;
    const FractionField field = MakeRandomFractions(whole, count, count);
    TetsById serial, merged;
    Collect(whole, BuildAlone(whole, field, meshVoid), serial);
    std::vector<IndexBox> boxes = CutBox(whole.Global(), count, count == 3 ? 0 : -1);
    std::vector<TetTopology> parts(count);
    RunOnRanks(count,
      [&](ThreadRanks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()]);
        RankRuntime runtime(ranks);
        const Partition partition(grid, ranks);
        const FractionField own = CopyToLocal(whole, field, grid);
        const LabelArray labels = MakeResolvedLabels(grid, own, partition, runtime);
        LatticeNodes nodes(grid, own, labels, 0.5, partition, runtime);
        parts[ranks.Rank()] = BuildLatticeTets(
          grid, nodes, meshVoid, NarrowVoid(), partition, runtime, NoCoarseTets(grid, runtime).Tets)
                                .Topology;
      });
    for (int rank = 0; rank < count; ++rank)
    {
      Collect(MakeRankGrid(whole, boxes[rank]), parts[rank], merged);
    }
    EXPECT_TRUE(serial == merged) << count << " ranks";
    std::printf("%d ranks: %zu tets\n", count, merged.size());
  }
}
