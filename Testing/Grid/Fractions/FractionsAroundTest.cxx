/// Copies of the fractions around cells.
#include "Fractions/FractionsAround.h"
#include "MeshChecks.h"
#include "RankFields.h"

#include <gtest/gtest.h>

#include <tuple>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using PartAround = std::tuple<int, int, double>; // cell around, material, fraction

/// Returns the parts of the cells around a cell, read from the field.
std::vector<PartAround> ReadAround(
  const CartesianGrid& grid, const FractionField& field, const Index3& cell)
{
  std::vector<PartAround> parts;
  for (int n = 0; n < 27; ++n)
  {
    field.ForParts(grid.Linear(grid.Global().Nearest(CellAround(cell, n))),
      [&](int material, double fraction) { parts.emplace_back(n, material, fraction); });
  }
  return parts;
}

} // namespace

TEST(FractionsAround, HoldsThePartsOfTheField)
{
  for (const CartesianGrid& grid : { MakeUnevenGrid(7), MakeUnitGrid(70, 3, 1) })
  {
    const FractionField field = MakePatchyFractions(grid, 3, 4);
    std::vector<Index3> positions; // also at sides, edges and corners of the domain
    std::vector<Index> cells;
    ForCells(grid.Owned(),
      [&](const Index3& p)
      {
        if ((p[0] + 2 * p[1] + 3 * p[2]) % 5 < 2)
        {
          positions.push_back(p);
          cells.push_back(grid.Linear(p));
        }
      });
    const FractionsAround around(grid, field, cells);
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      std::vector<PartAround> parts;
      around.ForParts(static_cast<Index>(c),
        [&](int n, int material, double fraction) { parts.emplace_back(n, material, fraction); });
      ASSERT_EQ(parts, ReadAround(grid, field, positions[c])) << "cell " << c;
    }
  }
}
