/// Contents of neighbour cells that are joined.
#include "State/Transfer/JoinRows.h"
#include "MeshChecks.h"
#include "RankFields.h"
#include "State/Transfer/FarContents.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

using namespace vfm;
using namespace vfm::testing;

namespace
{

// Density, and a value per mass.
const StateColumns Columns({ { StateKind::PerVolume }, { StateKind::PerMass } }, 0);

/// What a row became: volume, position along x, density, value.
using BarRows = std::map<std::pair<Index, int>, std::array<double, 4>>;

/// Joins rows of a bar of unit cells.
/// @param volumes  volume of each material in some cells; the density is 1 + the cell's index, the
///   value the index
BarRows JoinBar(const std::map<std::pair<Index, int>, double>& volumes, const JoinRule& rule,
  int count, bool isPeriodic = false)
{
  constexpr Index Length = 16;
  BarRows joined;
  std::mutex mutex;
  const std::vector<IndexBox> boxes = CutBox({ {}, { { Length, 1, 1 } } }, count, 0);
  RunOnRanks(count,
    [&](Ranks& ranks)
    {
      const CartesianGrid whole = MakeUnitGrid(Length, 1, 1);
      const CartesianGrid grid = isPeriodic
        ? CartesianGrid::Covering(whole.Coordinates(), boxes[ranks.Rank()],
            { { true, false, false } }, Seam::Free, GhostLayers)
        : MakeRankGrid(whole, boxes[ranks.Rank()]);
      const Partition partition(grid, ranks);
      const Index first = grid.Domain().Lower[0];
      UnmeshedRows rows;
      for (const auto& [place, volume] : volumes)
      {
        const Index3 cell{ { place.first + first, grid.Domain().Lower[1], 0 } };
        if (grid.Owned().Contains(cell))
        {
          const double x = static_cast<double>(place.first), values[2] = { 1.0 + x, x };
          rows.Add(
            { grid.Linear(cell), place.second, volume, CentreOfCell(grid, cell) }, values, 2);
        }
      }
      const UnmeshedRows result = JoinRows(std::move(rows), rule, Columns, partition, grid);
      const std::lock_guard<std::mutex> lock(mutex);
      for (std::size_t n = 0; n < result.Rows.size(); ++n)
      {
        const UnmeshedRow& row = result.Rows[n];
        joined[{ grid.Position(row.Cell)[0] - first, row.Material }] = { { row.Volume,
          row.Position[0], result.Values[2 * n], result.Values[2 * n + 1] } };
      }
    });
  return joined;
}

/// Expects one row of the cells of a material.
void ExpectSum(const std::array<double, 4>& row, const std::map<Index, double>& cells)
{
  double volume = 0.0, moment = 0.0, mass = 0.0, content = 0.0;
  for (const auto& [cell, part] : cells)
  {
    const auto x = static_cast<double>(cell);
    volume += part;
    moment += part * (x + 0.5);
    mass += part * (1.0 + x);
    content += part * (1.0 + x) * x;
  }
  EXPECT_NEAR(row[0], volume, 1e-15);
  EXPECT_NEAR(row[1], moment / volume, 1e-14);
  EXPECT_NEAR(row[2], mass / volume, 1e-14);
  EXPECT_NEAR(row[3], content / mass, 1e-14);
}

} // namespace

TEST(JoinRows, NothingJoinsWithoutARule)
{
  const std::map<std::pair<Index, int>, double> rows{ { { 3, 1 }, 0.2 }, { { 4, 1 }, 0.1 } };
  const BarRows joined = JoinBar(rows, { false, 0.0 }, 2);
  ASSERT_EQ(joined.size(), 2u);
  ExpectSum(joined.at({ 3, 1 }), { { 3, 0.2 } });
  ExpectSum(joined.at({ 4, 1 }), { { 4, 0.1 } });
}

// Cells 3 and 7 are best. Cell 5 has the seeds 4 and 6 around neither; 5 joins the better one.
TEST(JoinRows, CellsJoinTheBestAround)
{
  const std::map<std::pair<Index, int>, double> rows{ { { 2, 1 }, 0.1 }, { { 3, 1 }, 0.4 },
    { { 4, 1 }, 0.2 }, { { 5, 1 }, 0.3 }, { { 6, 1 }, 0.1 }, { { 4, 2 }, 0.3 },
    { { 9, 1 }, 0.001 } };
  for (int count : { 1, 2, 3, 5 })
  {
    const BarRows joined = JoinBar(rows, { true, 0.0 }, count);
    ASSERT_EQ(joined.size(), 4u);
    ExpectSum(joined.at({ 3, 1 }), { { 2, 0.1 }, { 3, 0.4 }, { 4, 0.2 } });
    ExpectSum(joined.at({ 5, 1 }), { { 5, 0.3 }, { 6, 0.1 } });
    ExpectSum(joined.at({ 4, 2 }), { { 4, 0.3 } });
    ExpectSum(joined.at({ 9, 1 }), { { 9, 0.001 } });
    EXPECT_EQ(joined, JoinBar(rows, { true, 0.0 }, 1));
  }
}

// Of equal cells, those with the smaller key are seeds.
TEST(JoinRows, TiesGoToTheFirst)
{
  std::map<std::pair<Index, int>, double> rows;
  for (Index i = 0; i < 16; ++i)
  {
    rows[{ i, 1 }] = 0.25;
  }
  for (int count : { 1, 3 })
  {
    const BarRows joined = JoinBar(rows, { true, 0.0 }, count);
    // The score of the ends is smaller.
    std::vector<Index> seeds;
    for (const auto& [place, row] : joined)
    {
      seeds.push_back(place.first);
    }
    EXPECT_EQ(seeds, (std::vector<Index>{ 1, 3, 5, 7, 9, 11, 13, 15 }));
    ExpectSum(joined.at({ 1, 1 }), { { 0, 0.25 }, { 1, 0.25 }, { 2, 0.25 } });
    ExpectSum(joined.at({ 3, 1 }), { { 3, 0.25 }, { 4, 0.25 } });
  }
}

// Cell 2 joins 3, which is not small; 6 and 7 have no other around; 9 stays alone.
TEST(JoinRows, SmallRowsJoin)
{
  const std::map<std::pair<Index, int>, double> rows{ { { 2, 1 }, 0.01 }, { { 3, 1 }, 0.2 },
    { { 4, 1 }, 0.2 }, { { 6, 1 }, 0.01 }, { { 7, 1 }, 0.02 }, { { 9, 1 }, 0.001 } };
  for (int count : { 1, 2, 5 })
  {
    const BarRows joined = JoinBar(rows, { false, 0.05 }, count);
    ASSERT_EQ(joined.size(), 4u);
    ExpectSum(joined.at({ 3, 1 }), { { 2, 0.01 }, { 3, 0.2 } });
    ExpectSum(joined.at({ 4, 1 }), { { 4, 0.2 } });
    ExpectSum(joined.at({ 7, 1 }), { { 6, 0.01 }, { 7, 0.02 } });
    ExpectSum(joined.at({ 9, 1 }), { { 9, 0.001 } });
  }
}

// The cells on both sides are neighbours, and the centroid is in the domain.
TEST(JoinRows, AcrossPeriodicSides)
{
  const std::map<std::pair<Index, int>, double> rows{ { { 0, 1 }, 0.2 }, { { 15, 1 }, 0.3 } };
  for (int count : { 1, 2, 3 })
  {
    const BarRows joined = JoinBar(rows, { true, 0.0 }, count, true);
    ASSERT_EQ(joined.size(), 1u);
    const std::array<double, 4>& row = joined.at({ 15, 1 });
    EXPECT_NEAR(row[0], 0.5, 1e-15);
    EXPECT_NEAR(row[1], 15.9, 1e-14);
  }
}

// The far part of a cell, and what is left of it, are one row.
TEST(FarContents, PartsOfACellAreOneRow)
{
  const CartesianGrid grid = MakeUnitGrid(4, 1, 1);
  const Index one = grid.Linear({ { 1, 0, 0 } }), two = grid.Linear({ { 2, 0, 0 } });
  const double values[2] = { 3.0, 5.0 };
  FarContents none(grid, Columns, nullptr);
  EXPECT_EQ(none.Take(one, 1, 0.5, values), 0.5);
  EXPECT_FALSE(none.TakeRest(one, 1, 0.5, values));
  EXPECT_TRUE(none.Rows.Rows.empty());
  const ParticleRequest request{ { { one, 1, 0.25 }, { two, 2, 0.5 } } };
  FarContents far(grid, Columns, &request);
  EXPECT_EQ(far.Take(one, 1, 0.75, values), 0.5);
  EXPECT_TRUE(far.TakeRest(one, 1, 0.5, values));
  EXPECT_EQ(far.Take(one, 2, 0.25, values), 0.25);
  EXPECT_FALSE(far.TakeRest(one, 0, 0.25, values));      // void
  EXPECT_EQ(far.Take(two, 2, 0.5 + 1e-12, values), 0.0); // all of it
  ASSERT_EQ(far.Rows.Rows.size(), 2u);
  EXPECT_EQ(far.Rows.Rows[0].Volume, 0.75);
  EXPECT_EQ(far.Rows.Rows[0].Position, (Vector3{ { 1.5, 0.5, 0.5 } }));
  EXPECT_EQ(far.Rows.Rows[1].Volume, 0.5 + 1e-12);
  EXPECT_EQ(far.Rows.Values, (std::vector<double>{ 3.0, 5.0, 3.0, 5.0 }));
}
