/// Contents of donors, and their flow until each holds the volume of its elements.
#include "State/Transfer/DonorContents.h"
#include "MeshChecks.h"
#include "RankFields.h"
#include "State/Transfer/VolumeFluxes.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const std::vector<StateQuantity> Quantities{ { StateKind::PerVolume }, { StateKind::PerMass } };
const StateColumns Columns(Quantities, 0);

/// The value per mass is the cell's first index; the density is the material.
struct CellNumbers : StateCellValues
{
  void Read(const Index3& cell, int material, double* values) const override
  {
    values[0] = material;
    values[1] = static_cast<double>(cell[0]);
  }
};

/// A bar of cells without whole elements.
struct Bar
{
  Bar(const CartesianGrid& grid, const FractionField& fractions, Ranks& ranks) :
    Grid(grid),
    Fractions(fractions),
    Run(ranks),
    Parts(grid, ranks),
    Request{ grid, Fractions, Values, Quantities, 0 },
    Source(Request, Columns, IsMeshed),
    Whole(None, grid, Fractions, Run),
    Donors(grid)
  {
  }
  /// Makes the donor of an owned cell.
  void AddDonor(Index i, int material, double overlap)
  {
    if (this->Grid.Owned().Contains({ { i, 0, 0 } }))
    {
      this->Donors[this->Donors.Get(this->Grid.Linear({ { i, 0, 0 } }), material, material)]
        .Overlap = overlap;
    }
  }

  const CartesianGrid& Grid;
  const FractionField Fractions;
  RankRuntime Run;
  const Partition Parts;
  const CellNumbers Values;
  TransferRequest Request;
  const std::vector<unsigned char> IsMeshed{ 0, 1, 1 };
  const StateSource Source;
  const Mesh None;
  const WholeElements Whole;
  DonorTable Donors;
  FarContents Far{ Grid, Columns, nullptr };
};

/// Runs body on ranks that own parts of a bar of unit cells of material 1, with other parts of
/// some cells.
void ForBars(Index cells, const std::map<Index, FractionField::Part>& others,
  const std::function<void(Bar&, MaterialSums&, MaterialSums&)>& body)
{
  const CartesianGrid whole = MakeUnitGrid(cells, 1, 1);
  for (int count : { 1, 2 })
  {
    const std::vector<IndexBox> boxes = CutBox(whole.Global(), count, 0);
    RunOnRanks(count,
      [&](Ranks& ranks)
      {
        const CartesianGrid grid = MakeRankGrid(whole, boxes[ranks.Rank()], { GhostLayers, 0 });
        FractionField fractions = MakeLabels(grid, 2, [](const Index3&) { return 1; });
        for (const auto& [i, part] : others)
        {
          if (grid.Local().Contains({ { i, 0, 0 } }))
          {
            fractions.SetParts(grid.Linear({ { i, 0, 0 } }),
              { { 1, 1.0 - part.Fraction }, { part.Material, part.Fraction } });
          }
        }
        Bar bar(grid, fractions, ranks);
        MaterialSums input(3, Columns), unmeshed(3, Columns);
        body(bar, input, unmeshed);
      });
  }
}

} // namespace

TEST(MaterialSums, OverRanks)
{
  RunOnRanks(3,
    [](Ranks& ranks)
    {
      MaterialSums sums(3, Columns);
      const double values[4] = { 2.0, 5.0 + ranks.Rank() };
      sums.Add(1, 0.5, values);
      sums.Add(2, 1.0, values);
      sums.Add(1, 1.5, values);
      const std::vector<StateTotals> totals = sums.Finish(ranks);
      // Volume, mass, content of density, content of the value.
      EXPECT_EQ(totals[0], (StateTotals{ 0.0, 0.0, 0.0, 0.0 }));
      EXPECT_EQ(totals[1], (StateTotals{ 6.0, 12.0, 12.0, 4.0 * (5 + 6 + 7) }));
      EXPECT_EQ(totals[2], (StateTotals{ 3.0, 6.0, 6.0, 2.0 * (5 + 6 + 7) }));
    });
}

/// Material 2 has one donor, in cell 5. Its other cells give what they contain to it, if they are
/// at most three cells away.
TEST(DonorContents, CellsWithoutDonorGive)
{
  ForBars(12, { { 2, { 2, 0.5 } }, { 5, { 2, 0.25 } }, { 9, { 2, 0.5 } } },
    [](Bar& bar, MaterialSums& input, MaterialSums& unmeshed)
    {
      for (Index i = 0; i < 12; ++i)
      {
        bar.AddDonor(i, 1, 1.0);
      }
      bar.AddDonor(5, 2, 0.4);
      const DonorLinks links(bar.Grid, bar.Parts, bar.Donors);
      const DonorValues values =
        FillDonors(bar.Source, bar.Whole, bar.Parts, bar.Donors, input, unmeshed, bar.Far);
      ForCells(bar.Grid.Owned(),
        [&](const Index3& p)
        {
          const int own = bar.Donors.Find(bar.Grid.Linear(p), 1);
          const bool isHalf = p[0] == 2 || p[0] == 9;
          EXPECT_DOUBLE_EQ(bar.Donors[own].Volume, isHalf ? 0.5 : p[0] == 5 ? 0.75 : 1.0);
          EXPECT_EQ(values.Of(own)[0], 1.0);
          EXPECT_EQ(values.Of(own)[1], static_cast<double>(p[0]));
        });
      if (bar.Grid.Owned().Contains({ { 5, 0, 0 } }))
      {
        const int donor = bar.Donors.Find(bar.Grid.Linear({ { 5, 0, 0 } }), 2);
        EXPECT_DOUBLE_EQ(bar.Donors[donor].Volume, 0.75);
        EXPECT_EQ(values.Of(donor)[0], 2.0);
        EXPECT_DOUBLE_EQ(values.Of(donor)[1], (0.25 * 5 + 0.5 * 2) / 0.75);
      }
      const StateTotals all = input.Finish(bar.Parts.Group())[2];
      EXPECT_EQ(all, (StateTotals{ 1.25, 2.5, 2.5, 2.0 * (0.5 * 2 + 0.25 * 5 + 0.5 * 9) }));
      // Cell 9 is four cells away.
      EXPECT_EQ(unmeshed.Finish(bar.Parts.Group())[2], (StateTotals{ 0.5, 1.0, 1.0, 9.0 }));
    });
}

/// Donors of one material in a cell share it by overlap. An empty donor has the values nearby.
TEST(DonorContents, DonorsShareTheirCell)
{
  const CartesianGrid grid = MakeUnitGrid(3, 1, 1);
  Ranks alone;
  Bar bar(grid, MakeLabels(grid, 2, [](const Index3& p) { return p[0] < 2 ? 1 : 2; }), alone);
  const Index cell = grid.Linear({ { 0, 0, 0 } });
  const int a = bar.Donors.Get(cell, 1, 1), b = bar.Donors.Get(cell, 7, 1);
  bar.Donors[a].Overlap = 0.2;
  bar.Donors[b].Overlap = 0.6;
  bar.AddDonor(1, 2, 0.1);
  MaterialSums input(3, Columns), unmeshed(3, Columns);
  const DonorValues values =
    FillDonors(bar.Source, bar.Whole, bar.Parts, bar.Donors, input, unmeshed, bar.Far);
  EXPECT_DOUBLE_EQ(bar.Donors[a].Volume, 0.25);
  // Cell 1 has material 1 but no donor for it: it gives to the larger donor of cell 0.
  EXPECT_DOUBLE_EQ(bar.Donors[b].Volume, 0.75 + 1.0);
  EXPECT_DOUBLE_EQ(values.Of(b)[1], 1.0 / 1.75);
  const int other = bar.Donors.Find(grid.Linear({ { 1, 0, 0 } }), 2);
  EXPECT_DOUBLE_EQ(bar.Donors[other].Volume, 1.0);
  EXPECT_EQ(values.Of(other)[1], 2.0);
}

/// Cells with too much give to cells with too little, through all cells between them.
TEST(VolumeFluxes, FillTheOverlaps)
{
  std::map<Index, FractionField::Part> mixed;
  for (Index i = 0; i < 8; ++i)
  {
    mixed[i] = { 2, 0.5 }; // all cells are mismatch cells
  }
  ForBars(8, mixed,
    [](Bar& bar, MaterialSums& input, MaterialSums& unmeshed)
    {
      for (Index i = 0; i < 8; ++i)
      {
        bar.AddDonor(i, 1, i == 0 ? 0.9 : i == 7 ? 0.1 : 0.5);
        bar.AddDonor(i, 2, 0.25);
      }
      const MismatchCells mismatches(
        bar.Grid, bar.Fractions, bar.Whole, bar.Donors, bar.IsMeshed, bar.Parts);
      const DonorLinks links(bar.Grid, bar.Parts, bar.Donors);
      DonorValues values =
        FillDonors(bar.Source, bar.Whole, bar.Parts, bar.Donors, input, unmeshed, bar.Far);
      const VolumeFactors factors =
        MoveContents(bar.Source, { mismatches, {} }, links, bar.Run, bar.Donors, values);
      EXPECT_NEAR(factors[1][0], 1.0, 1e-14);
      EXPECT_NEAR(factors[1][1], 1.0, 1e-14);
      // The elements of material 2 have half of its volume, so it is twice as dense in them.
      EXPECT_NEAR(factors[2][0], 1.0, 1e-14);
      EXPECT_NEAR(factors[2][1], 2.0, 1e-14);
      MaterialSums moved(3, Columns);
      ForCells(bar.Grid.Owned(),
        [&](const Index3& p)
        {
          for (int material : { 1, 2 })
          {
            const int s = bar.Donors.Find(bar.Grid.Linear(p), material);
            EXPECT_NEAR(bar.Donors[s].Volume, bar.Donors[s].Overlap, 1e-9);
            moved.Add(material, bar.Donors[s].Volume, values.Of(s));
            // 0.4 moves from the right to the left, so values are those of the next cells.
            const double x = static_cast<double>(p[0]);
            EXPECT_GE(values.Of(s)[1], x - 1e-9);
            EXPECT_LE(values.Of(s)[1], material == 1 ? std::min(x + 1.0, 7.0) : x + 1e-9);
            EXPECT_NEAR(values.Of(s)[0], material == 1 ? 1.0 : 4.0, 1e-9);
          }
        });
      const std::vector<StateTotals> before = input.Finish(bar.Parts.Group());
      const std::vector<StateTotals> after = moved.Finish(bar.Parts.Group());
      for (int material : { 1, 2 })
      {
        for (int n : { 1, 2, 3 })
        {
          EXPECT_NEAR(after[material][n], before[material][n], 1e-8);
        }
      }
    });
}
