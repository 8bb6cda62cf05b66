/// Volumes of leaves with labels: fragments near a leaf, their target volumes, and the
/// volumes of hexes before smoothing.
#include "Base/Partition.h"
#include "RankMeshes.h"
#include "Sweep.h"
#include "Volumes/CellLocator.h"
#include "Volumes/FragmentVolumes.h"

#include "Elements/Hex/HexTopology.h"
#include "Elements/MeasureFragments.h"
#include "FragmentShares.h"
#include "Smoothing/Hex/MakeLevels.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

LevelPlan MakePlan(int refinements, const std::vector<std::vector<Index>>& families)
{
  LevelPlan plan;
  plan.Refinements = refinements;
  plan.FineInterfaces = false;
  plan.Families = families;
  return plan;
}

/// Sets the label of each leaf to label(lowest finest cell), in the local
/// box and the layer around it.
LabelArray LabelLeaves(const RefinedGrid& levels, const std::function<int(const Index3&)>& label)
{
  const CartesianGrid& grid = levels.Finest();
  LabelArray labels(grid, 0);
  ForCells(grid.Local(),
    [&](const Index3& p)
    {
      const OctreeKeys::LevelIndex leaf = levels.LeafOf(p);
      const Index cell = grid.Linear(p);
      const int value = label(levels.FinestNode(leaf.Level, leaf.At));
      labels.Set(cell, value);
      grid.ForMirrors(cell, [&](Index n) { labels.Set(n, value); });
    });
  return labels;
}

/// Returns 0, 1 or 2, the same on any rank.
int RandomLabel(const CartesianGrid& grid, const Index3& cell, unsigned seed)
{
  std::minstd_rand random(seed + 1 + static_cast<unsigned>(grid.CellKey(cell)));
  random.discard(3);
  return static_cast<int>(random() % 3);
}

/// Data of a rank about random leaves with random labels.
struct RandomLeaves
{
  RandomLeaves(
    const CartesianGrid& grid, int refinements, double chance, unsigned seed, Ranks& ranks) :
    ThePartition(grid, ranks),
    Levels(
      grid, MakePlan(refinements, MakeRandomFamilies(grid, refinements, chance, seed)), {}, ranks),
    Labels(LabelLeaves(this->Levels, [&](const Index3& p) { return RandomLabel(grid, p, seed); })),
    Pieces(grid, this->Labels, seed % 2 == 0, this->ThePartition),
    Locator(this->Levels, this->Labels, this->Pieces)
  {
  }

  Partition ThePartition;
  RefinedGrid Levels;
  LabelArray Labels;
  Fragments Pieces;
  CellLocator Locator;
};

/// Returns the fragments of a material that touch a leaf, by the squared distance
/// of centres that FindNear uses.
std::map<Index, std::set<int>> FindTouching(
  const RandomLeaves& leaves, const OctreeKeys::LevelIndex& leaf, int material)
{
  const CartesianGrid& grid = leaves.Levels.Finest();
  const IndexBox own = leaves.Levels.FinestCells(leaf.Level, leaf.At);
  IndexBox around;
  for (int a = 0; a < 3; ++a)
  {
    around.Lower[a] = own.Lower[a] - 1;
    around.Upper[a] = own.Upper[a] + 1;
  }
  std::map<Index, std::set<int>> found;
  ForCells(Intersect(around, grid.Global()),
    [&](const Index3& p)
    {
      const int fragment = leaves.Pieces.FragmentOfCell(p);
      if (leaves.Labels[grid.Linear(p)] != material || fragment == 0)
      {
        return;
      }
      const int level = std::max(leaf.Level, leaves.Levels.LeafOf(p).Level);
      const Index size = Index(1) << (leaves.Levels.NumberOfRefinements() - level);
      Index distance = 0;
      for (int a = 0; a < 3; ++a)
      {
        const Index d = 2 * (p[a] / size * size) + size - own.Lower[a] - own.Upper[a];
        distance += d * d;
      }
      found[distance].insert(fragment);
    });
  return found;
}

} // namespace

TEST(CellLocator, AreThoseOfCellsWhereAllCellsAreFine)
{
  const CartesianGrid grid = MakeUnitGrid(8, 12, 16);
  Ranks alone;
  const RandomLeaves leaves(grid, 1, 1.0, 4, alone);
  const RefinedGrid uniform(grid, alone);
  const CellLocator cells(uniform, leaves.Labels, leaves.Pieces);
  int found = 0, missed = 0;
  ForCells(grid.Global(),
    [&](const Index3& p)
    {
      ASSERT_EQ(leaves.Levels.LeafOf(p).Level, 1);
      for (int material = 0; material < 3; ++material)
      {
        if (material != leaves.Labels[grid.Linear(p)])
        {
          const int fragment = cells.FindNear(p, material);
          ASSERT_EQ(leaves.Locator.FindNear(p, material), fragment);
          ++(fragment > 0 ? found : missed);
        }
      }
    });
  EXPECT_GT(found, 0);
}

TEST(CellLocator, AreTheNearestLeaves)
{
  Ranks alone;
  std::set<int> levels; // levels of all leaves
  int missed = 0;
  for (unsigned seed : ListSeeds(6))
  {
    SCOPED_TRACE(seed);
    const int refinements = seed < 2 ? 1 : 2 + static_cast<int>(seed % 2);
    const CartesianGrid grid =
      MakeUnitGrid(Index(4) << refinements, Index(3) << refinements, Index(5) << refinements);
    const RandomLeaves leaves(grid, refinements, 0.05, seed, alone);
    std::map<std::array<Index, 5>, int> ofLeaf; // All cells of a leaf must give the same result.
    ForCells(grid.Global(),
      [&](const Index3& p)
      {
        const OctreeKeys::LevelIndex leaf = leaves.Levels.LeafOf(p);
        levels.insert(leaf.Level);
        for (int material = 0; material < 3; ++material)
        {
          if (material == leaves.Labels[grid.Linear(p)])
          {
            continue;
          }
          const int fragment = leaves.Locator.FindNear(p, material);
          const auto known = ofLeaf.insert(
            { { { leaf.Level, leaf.At[0], leaf.At[1], leaf.At[2], material } }, fragment });
          ASSERT_EQ(known.first->second, fragment);
          if (known.second)
          {
            const auto near = FindTouching(leaves, leaf, material);
            ASSERT_TRUE(near.empty() ? fragment == 0 : near.begin()->second.count(fragment) == 1);
            missed += near.empty();
          }
        }
      });
  }
  if (IsWholeSweep())
  {
    EXPECT_EQ(levels.size(), 4u);
    EXPECT_GT(missed, 0);
  }
}

TEST(CellLocator, GiveACoarseLeafToTheAdjacentPiece)
{
  // Material 2 has two bodies: one next to the leaf at x 4..8, which contains a fifth of material
  // 2 everywhere, and one far away.
  const CartesianGrid grid = MakeUnitGrid(24, 4, 4);
  Runtime runtime;
  const Partition partition(grid, runtime.Group());
  const RefinedGrid levels(grid, MakePlan(2, {}), {}, runtime.Group());
  const auto label = [](const Index3& p) { return p[0] < 4 || p[0] >= 20 ? 2 : 1; };
  const LabelArray labels = LabelLeaves(levels, label);
  FractionField field = MakeLabels(grid, 2, label);
  ForCells({ { { 4, 0, 0 } }, { { 8, 4, 4 } } },
    [&](const Index3& p) {
      field.SetParts(grid.Linear(p), { { 1, 0.8 }, { 2, 0.2 } });
    });
  const Fragments pieces(grid, labels, false, partition);
  const int beside = pieces.FragmentOfCell({ { 0, 0, 0 } }),
            far = pieces.FragmentOfCell({ { 20, 0, 0 } });
  const auto targets = [&](const FragmentLocator& locator) {
    return FragmentVolumes(grid, field, pieces.Share(), locator, false, runtime).FragmentTargets();
  };
  const std::vector<double> leaves = targets(CellLocator(levels, labels, pieces));
  EXPECT_NEAR(leaves[beside], 64.0 + 12.8, 1e-9);
  EXPECT_NEAR(leaves[far], 64.0, 1e-9);
  const std::vector<double> cells =
    targets(CellLocator(RefinedGrid(grid, runtime.Group()), labels, pieces));
  EXPECT_GT(cells[far], 68.0); // Most of the fifth is near no cell of a body: both receive a share.
  // Left, it is in no target: a layer of the fifth of the block is near.
  const RefinedGrid finest(grid, runtime.Group());
  const CellLocator near(finest, labels, pieces);
  FragmentVolumes left(grid, field, pieces.Share(), near, true, runtime);
  EXPECT_NEAR(left.FragmentTargets()[far], 64.0, 1e-9);
  EXPECT_NEAR(left.FragmentTargets()[beside], 64.0 + 0.2 * 16, 1e-9);
  EXPECT_NEAR(left.MaterialTargets()[2], 128.0 + 0.2 * 16, 1e-9);
  const std::vector<FarMatter> matter = left.TakeFar();
  ASSERT_EQ(matter.size(), 48u);
  for (const FarMatter& part : matter)
  {
    EXPECT_EQ(part.Material, 2);
    EXPECT_EQ(part.Volume, 0.2);
    EXPECT_GT(grid.CellOfKey(part.Cell)[0], 4);
    EXPECT_LT(grid.CellOfKey(part.Cell)[0], 8);
  }
}

TEST(CellLocator, RanksAgree)
{
  for (int refinements : { 1, 2, 3 })
  {
    const CartesianGrid whole =
      MakeUnitGrid(Index(6) << refinements, Index(4) << refinements, Index(4) << refinements);
    const FractionField field = MakePatchyFractions(whole, 2, 5);
    const auto targets = [&](const CartesianGrid& grid, Ranks& ranks, std::vector<int>& ids)
    {
      const RandomLeaves leaves(grid, refinements, 0.05, 6, ranks);
      RankRuntime runtime(ranks);
      ids = leaves.Pieces.Share().Ids;
      return FragmentVolumes(grid, CopyToLocal(whole, field, grid), leaves.Pieces.Share(),
        leaves.Locator, false, runtime)
        .FragmentTargets();
    };
    Ranks alone;
    std::vector<int> all;
    const std::vector<double> expected = targets(whole, alone, all);
    ASSERT_GT(expected.size(), 10u);
    for (int count : { 2, 3, 4, 8 })
    {
      const std::vector<IndexBox> boxes = CutBaseBox(whole, refinements, count);
      RunOnRanks(count,
        [&](Ranks& ranks)
        {
          std::vector<int> ids;
          const std::vector<double> own =
            targets(MakeRankGrid(whole, boxes[ranks.Rank()]), ranks, ids);
          ASSERT_EQ(own.size(), ids.size());
          for (std::size_t f = 1; f < ids.size(); ++f)
          {
            EXPECT_EQ(own[f], expected[ids[f]])
              << count << " ranks, " << refinements << " refinements";
          }
        });
    }
  }
}

namespace
{

/// Stairs with families refined only on one side of the plane x = 16: material 1 below, void above.
struct Stairs
{
  Stairs(const CartesianGrid& grid, Runtime& runtime) :
    Levels(
      std::make_shared<RefinedGrid>(grid, MakePlan(2, { {}, ListFamilies(grid, runtime.Group()) }),
        std::vector<Index>(), runtime.Group())),
    Labels(LabelLeaves(*this->Levels, [](const Index3& p) { return p[0] < 16 ? 1 : 0; }))
  {
    const NarrowVoid narrow;
    PointNumbering numbering(grid, this->Labels, true, true, narrow);
    const std::unique_ptr<CoarseHexes> coarse =
      MakeCoarseHexes(*this->Levels, this->Labels, { true }, runtime);
    HexTopology topology = BuildHexes(
      grid, this->Labels, FindMixedNodes(grid, this->Labels), true, numbering, runtime, *coarse);
    this->Hexes = std::move(topology.Hexes);
    this->Hexes.Levels = this->Levels;
    this->Hexes.Fragment = Buffer<int>(this->Hexes.ElementIds.size());
    for (std::size_t h = 0; h < this->Hexes.ElementIds.size(); ++h)
    {
      this->Hexes.Fragment[h] = this->Hexes.Material[h] == 1 ? 1 : 2;
    }
  }

  /// Returns keys of families of 4x4x4 cells on rank 0 only: RefinedGrid gathers them.
  static std::vector<Index> ListFamilies(const CartesianGrid& grid, Ranks& ranks)
  {
    const Index nx = grid.Global().Upper[0] / 4, ny = grid.Global().Upper[1] / 4;
    std::vector<Index> keys;
    for (const Index3& q : { Index3{ { 3, 2, 2 } }, Index3{ { 2, 3, 4 } } })
    {
      keys.push_back((q[2] * ny + q[1]) * nx + q[0]);
    }
    return ranks.Rank() == 0 ? keys : std::vector<Index>();
  }

  std::shared_ptr<RefinedGrid> Levels;
  LabelArray Labels;
  Mesh Hexes;
};

} // namespace

TEST(LeafVolumes, HexesHaveWhatTheyHave)
{
  const CartesianGrid grid = MakeUnitGrid(32, 24, 24);
  Runtime runtime;
  const Stairs stairs(grid, runtime);
  const std::vector<double> volumes =
    MeasureFragments(stairs.Hexes, grid, ShareOfAll(2, runtime.Group()), runtime);
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_EQ(volumes[0], 0.0);
  EXPECT_NEAR(volumes[1], MeasureVolume(stairs.Hexes, 1), 1e-6);
  EXPECT_NEAR(volumes[2], MeasureVolume(stairs.Hexes, 0), 1e-6);
  EXPECT_NEAR(volumes[1] + volumes[2], 32.0 * 24 * 24, 1e-6);
  EXPECT_GT(std::abs(volumes[1] - 16.0 * 24 * 24), 0.01); // transitions have moved the plane
  for (int count : { 2, 4, 8 })
  {
    const std::vector<IndexBox> boxes = CutBaseBox(grid, 2, count);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        RankRuntime run(ranks);
        const CartesianGrid mine = MakeRankGrid(grid, boxes[ranks.Rank()]);
        const Stairs parts(mine, run);
        EXPECT_EQ(MeasureFragments(parts.Hexes, mine, ShareOfAll(2, ranks), run), volumes) << count;
      });
  }
}

TEST(LeafVolumes, UnitsAreMeanCells)
{
  // Cells of 3 x 3 x 3 far from the origin, and smoothed interfaces with buffer layers.
  const MeshCase shape = MakeMeshCase("half sphere");
  std::array<std::vector<double>, 3> coordinates;
  for (int a = 0; a < 3; ++a)
  {
    for (double x : shape.Grid.Coordinates(a))
    {
      coordinates[a].push_back(3.0 * x + 1e5);
    }
  }
  const CartesianGrid grid(coordinates);
  MeshOptions options;
  options.MeshVoid = true;
  options.Levels.Refinements = 1;
  Runtime runtime;
  MeshReport report;
  const Mesh mesh = MakeHexMesh(grid, shape.Fractions, options, runtime, report);
  const std::vector<double> volumes =
    MeasureFragments(mesh, grid, ShareOfAll(report.NumberOfFragments, runtime.Group()), runtime);
  ASSERT_EQ(report.NumberOfFragments, 2);
  for (std::size_t h = 0; h < mesh.ElementIds.size(); ++h)
  {
    ASSERT_EQ(mesh.Fragment[h] == mesh.Fragment[0], mesh.Material[h] == mesh.Material[0]);
  }
  const int ofFirst = mesh.Fragment[0], first = mesh.Material[0];
  EXPECT_NEAR(27.0 * volumes[ofFirst] / report.MeshVolume[first], 1.0, 1e-8);
  EXPECT_NEAR(27.0 * volumes[3 - ofFirst] / report.MeshVolume[1 - first], 1.0, 1e-8);
}
