/// User-selected cells, passed by the host for refinement.
#include "CMLPSculptor.c.h"
#include "HostFields.h"
#include "Sculptor.h"

#include <gtest/gtest.h>

using vfm::testing::HostFields;
using vfm::testing::MeshFromData;
using vfm::testing::MyRank;
using vfm::testing::NumberOfRanks;

namespace
{

class SculptorChosenCells : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Sculptor = c_create_cml_psculptor();
    sculptor_set_option(this->Sculptor, "FineInterfaces", "off");
  }
  void TearDown() override { c_delete_cml_psculptor(this->Sculptor); }

  /// Returns the halvings of this rank's cells: `halvings` for cells (8..9, 5..7, 8..8)
  /// of the whole grid, 0 for others.
  std::vector<int> Choose(int halvings) const
  {
    const vfm::IndexBox chosen{ { { 8, 5, 8 } }, { { 10, 8, 9 } } };
    std::vector<int> result;
    ForCells(this->Fields.Cells,
      [&](const vfm::Index3& p) { result.push_back(chosen.Contains(p) ? halvings : 0); });
    return result;
  }
  bool HasChosen() const
  {
    const std::vector<int> halvings = this->Choose(1);
    return std::find(halvings.begin(), halvings.end(), 1) != halvings.end();
  }

  double Number(const char* name, int index = 0) const
  {
    double value = -1.0;
    sculptor_get_number(this->Sculptor, name, index, &value);
    return value;
  }
  /// Returns the number of elements of all ranks.
  double Elements() const
  {
    int64_t points = 0, elements = 0;
    int corners = 0;
    EXPECT_EQ(sculptor_get_counts(this->Sculptor, &points, &elements, &corners), SCULPTOR_OK);
    double mine = static_cast<double>(elements), all = 0.0;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return all;
  }
  double MeshByReport(int refine)
  {
    EXPECT_EQ(MeshFromData(this->Sculptor, this->Fields, this->Fields.Ball.data(), refine), 0)
      << sculptor_error_text(this->Sculptor);
    return this->Elements();
  }

  HostFields Fields{ MyRank(), NumberOfRanks() };
  int Sculptor = 0;
};

} // namespace

TEST_F(SculptorChosenCells, OnlyOfTheNextMesh)
{
  const double plain = this->MeshByReport(0);
  EXPECT_EQ(this->Number("ChosenCells"), 0.0);
  const std::vector<int> once = this->Choose(1), twice = this->Choose(2);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, once.data()), SCULPTOR_OK);
  const double refined = this->MeshByReport(0);
  EXPECT_GT(refined, plain);
  EXPECT_EQ(this->Number("ChosenCells"), 6.0);
  EXPECT_GT(this->Number("LevelCells", 1), 0.0);
  EXPECT_GT(this->Number("MinimumScaledJacobian"), 0.0);
  EXPECT_EQ(this->MeshByReport(0), plain);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, twice.data()), SCULPTOR_OK);
  EXPECT_GT(this->MeshByReport(0), refined);
  EXPECT_GT(this->Number("LevelCells", 2), 0.0);
}

TEST_F(SculptorChosenCells, MaximumLevelBounds)
{
  const std::vector<int> once = this->Choose(1), twice = this->Choose(2);
  ASSERT_EQ(sculptor_set_option(this->Sculptor, "ThinCells", "0"), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, once.data()), SCULPTOR_OK);
  const double refined = this->MeshByReport(0);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, twice.data()), SCULPTOR_OK);
  EXPECT_EQ(this->MeshByReport(1), refined);
}

TEST_F(SculptorChosenCells, SomeRanksNameNone)
{
  const double plain = this->MeshByReport(0);
  const std::vector<int> once = this->Choose(1);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, once.data()), SCULPTOR_OK);
  const double refined = this->MeshByReport(0);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, this->HasChosen() ? once.data() : nullptr),
    SCULPTOR_OK);
  EXPECT_EQ(this->MeshByReport(0), refined);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, nullptr), SCULPTOR_OK);
  EXPECT_EQ(this->MeshByReport(0), plain);
}

TEST_F(SculptorChosenCells, OfSeveralMaterialsAndTets)
{
  const HostFields& f = this->Fields;
  const std::vector<int> once = this->Choose(1);
  ASSERT_EQ(sculptor_set_box(this->Sculptor, f.Bounds.data(), f.Intervals.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_neighbours(this->Sculptor, f.Neighbours.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_add_material(this->Sculptor, "ball", f.Ball.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_add_material(this->Sculptor, "plate", f.Plate.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_option(this->Sculptor, "Method", "Lattice"), SCULPTOR_OK);
  for (const auto& [tets, width] :
    { std::pair(0, "0"), { 1, "0" }, { 0, "0.17,0.2,0.2" }, { 1, "0.17,0.2,0.2" } })
  {
    ASSERT_EQ(sculptor_set_option(this->Sculptor, "CellWidth", width), SCULPTOR_OK);
    ASSERT_EQ(sculptor_make_mesh(this->Sculptor, tets), SCULPTOR_OK);
    const double plain = this->Elements();
    ASSERT_EQ(sculptor_set_refinement(this->Sculptor, once.data()), SCULPTOR_OK);
    ASSERT_EQ(sculptor_make_mesh(this->Sculptor, tets), SCULPTOR_OK);
    EXPECT_GT(this->Elements(), plain);
    EXPECT_EQ(this->Number("ChosenCells"), 6.0);
  }
}

TEST_F(SculptorChosenCells, OfTheBlockLastBegun)
{
  const HostFields& f = this->Fields;
  const std::vector<int> once = this->Choose(1);
  ASSERT_EQ(sculptor_set_box(this->Sculptor, f.Bounds.data(), f.Intervals.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_add_material(this->Sculptor, "ball", f.Ball.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK);
  const double plain = this->Elements();
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, once.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK);
  const double refined = this->Elements();
  const int lower = f.Intervals[2] / 2, layer = f.Intervals[0] * f.Intervals[1];
  for (bool forgets : { false, true })
  {
    ASSERT_EQ(sculptor_clear_blocks(this->Sculptor), SCULPTOR_OK);
    for (const auto& span : { std::array<int, 2>{ 0, lower }, { lower, f.Intervals[2] } })
    {
      const double width = (f.Bounds[5] - f.Bounds[2]) / f.Intervals[2];
      std::array<double, 6> bounds = f.Bounds;
      bounds[2] = f.Bounds[2] + span[0] * width;
      bounds[5] = f.Bounds[2] + span[1] * width;
      const int intervals[3] = { f.Intervals[0], f.Intervals[1], span[1] - span[0] };
      ASSERT_EQ(sculptor_add_block(this->Sculptor, 0, bounds.data(), intervals), SCULPTOR_OK);
      const int first = layer * span[0];
      ASSERT_EQ(sculptor_add_material(this->Sculptor, "ball", f.Ball.data() + first), SCULPTOR_OK);
      ASSERT_EQ(sculptor_set_refinement(this->Sculptor, forgets ? nullptr : once.data() + first),
        SCULPTOR_OK);
    }
    ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK)
      << sculptor_error_text(this->Sculptor);
    EXPECT_EQ(this->Elements(), forgets ? plain : refined);
  }
}

TEST_F(SculptorChosenCells, MaximumLevelOfOtherRefinementsBoundsToo)
{
  const HostFields& f = this->Fields;
  const std::vector<int> once = this->Choose(1), twice = this->Choose(2);
  ASSERT_EQ(sculptor_set_box(this->Sculptor, f.Bounds.data(), f.Intervals.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_add_material(this->Sculptor, "ball", f.Ball.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, once.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK);
  const double refined = this->Elements();
  ASSERT_EQ(sculptor_set_option(this->Sculptor, "MaximumLevel", "1"), SCULPTOR_OK);
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, twice.data()), SCULPTOR_OK);
  ASSERT_EQ(sculptor_make_mesh(this->Sculptor, 0), SCULPTOR_OK);
  EXPECT_EQ(this->Elements(), refined);
}

TEST_F(SculptorChosenCells, WrongNumbersOnOneRank)
{
  std::vector<int> wrong = this->Choose(1);
  wrong.back() = MyRank() == NumberOfRanks() - 1 ? -1 : 0;
  ASSERT_EQ(sculptor_set_refinement(this->Sculptor, wrong.data()), SCULPTOR_OK);
  EXPECT_NE(MeshFromData(this->Sculptor, this->Fields, this->Fields.Ball.data()), 0);
  EXPECT_EQ(sculptor_error_code(this->Sculptor), SCULPTOR_ERROR_INPUT);
  const std::string text = sculptor_error_text(this->Sculptor);
  EXPECT_NE(text.find("holds -1"), std::string::npos) << text;
  EXPECT_GT(this->MeshByReport(0), 0.0);
  EXPECT_EQ(sculptor_set_refinement(987654, wrong.data()), SCULPTOR_ERROR_HANDLE);
}
