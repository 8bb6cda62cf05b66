/// Periodic meshes with free sides.
#include "GluedChecks.h"
#include "RankMeshes.h"

#include "Phases/MeshOfCells.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vfm;
using namespace vfm::testing;

namespace
{

class Periodic : public ::testing::TestWithParam<ElementMaker>
{
};

/// Returns the largest distance of a point beyond the domain along periodic axes.
double FindExcess(const CartesianGrid& grid, const Mesh& mesh)
{
  double excess = 0.0;
  for (std::size_t at = 0; at < mesh.Points.size(); ++at)
  {
    const int a = static_cast<int>(at % 3);
    const std::vector<double>& x = grid.Coordinates(a);
    const double below = x[grid.Domain().Lower[a]] - mesh.Points[at];
    const double above = mesh.Points[at] - x[grid.Domain().Upper[a]];
    excess = grid.Period(a) > 0 ? std::max({ excess, below, above }) : excess;
  }
  return excess;
}

} // namespace

/// A body across the corner of the cell gets the same mesh as one in its middle.
TEST_P(Periodic, PlaceOfSidesDoesNotMatter)
{
  const ElementMaker& method = this->GetParam();
  const CartesianGrid grid =
    MakePeriodicGrid({ { 12, 12, 12 } }, { { true, true, true } }, Seam::Free);
  MeshReport reports[2];
  std::size_t elements[2];
  for (const int place : { 0, 1 })
  {
    const FractionField field = SamplePeriodic(grid, 1, 4,
      [&](const Vector3& x)
      {
        double squares = 0.0;
        for (double coordinate : x)
        {
          const double away = std::fabs(coordinate - 6.0 * place);
          squares += std::pow(std::min(away, 12.0 - away), 2);
        }
        return squares < 4.2 * 4.2 ? 1 : 0;
      });
    MeshOptions options;
    options.Method = method.Tets;
    Runtime alone;
    elements[place] = method.Make(grid, field, options, alone, reports[place]).ElementIds.size();
  }
  EXPECT_EQ(elements[0], elements[1]);
  EXPECT_EQ(reports[0].NumberOfFragments, 1);
  EXPECT_NEAR(reports[0].MinimumScaledJacobian, reports[1].MinimumScaledJacobian, 1e-4);
  EXPECT_NEAR(reports[0].MeshVolume[1], reports[0].TargetVolume[1], 1e-5);
}

TEST_P(Periodic, SidesFollowInterfaces)
{
  const CartesianGrid grid =
    MakePeriodicGrid({ { 7, 7, 7 } }, { { true, true, true } }, Seam::Free);
  MeshOptions options;
  options.Method = this->GetParam().Tets;
  Runtime alone;
  MeshReport report;
  const Mesh mesh =
    this->GetParam().Make(grid, MakeRandomPeriodic(grid, 2, 0, 1), options, alone, report);
  EXPECT_GT(FindExcess(grid, mesh), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Methods, Periodic,
  ::testing::Values(ElementMaker{ "FreeHexes", MakeHexMesh, TetMethod::Lattice },
    ElementMaker{ "FreeLattice", MakeTetMesh, TetMethod::Lattice },
    ElementMaker{ "FreeCells", MakeTetMesh, TetMethod::Cells }),
  [](const auto& info) { return std::string(info.param.Name); });

/// Sums that decide between equal fractions of copies must not depend on rounded coordinates.
TEST(PeriodicGrid, CopiesOfCellsHaveTheirWidths)
{
  std::vector<double> x;
  for (int i = 0; i <= 7; ++i)
  {
    x.push_back(0.1 + std::pow(1.3, i));
  }
  const CartesianGrid grid = CartesianGrid::Covering(
    { x, x, x }, IndexBox{ { 0, 0, 0 }, { 7, 7, 7 } }, { true, true, false }, Seam::Free, 4);
  int rounded = 0;
  ForCells(grid.Global(),
    [&](const Index3& cell)
    {
      const Index3 own = grid.Canonical(cell);
      EXPECT_EQ(grid.CellVolume(cell), grid.CellVolume(own));
      const std::vector<double>& y = grid.Coordinates(1);
      rounded += y[cell[1] + 1] - y[cell[1]] != grid.Width(1, own[1]);
    });
  EXPECT_GT(rounded, 0);
}
