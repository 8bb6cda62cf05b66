#include "RefineCells.h"

#include "ChildFractions.h"
#include "Mesh.h"
#include "TetTopology.h"

namespace vfm
{
namespace
{

constexpr int ReadLevels = GhostLevels / 2; // coarse ghost levels whose cells are cut

IndexBox Doubled(const IndexBox& box)
{
  IndexBox doubled;
  for (int a = 0; a < 3; ++a)
  {
    doubled.Lower[a] = 2 * box.Lower[a];
    doubled.Upper[a] = 2 * box.Upper[a];
  }
  return doubled;
}

CartesianGrid HalveCells(const CartesianGrid& grid)
{
  std::array<std::vector<double>, 3> halved;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
    {
      halved[a].push_back(x[i]);
      halved[a].push_back(x[i] + 0.5 * (x[i + 1] - x[i]));
    }
    halved[a].push_back(x.back());
  }
  return CartesianGrid(std::move(halved), Doubled(grid.Owned()), GhostLevels);
}

Index3 Child(const Index3& cell, int c)
{
  return { { 2 * cell[0] + (c & 1), 2 * cell[1] + (c >> 1 & 1), 2 * cell[2] + (c >> 2 & 1) } };
}

/// Calls body(cell) for each cell of a box's layer along z.
template <class Body>
void ForLayer(const IndexBox& box, Index k, const Body& body)
{
  for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
  {
    for (Index i = box.Lower[0]; i < box.Upper[0]; ++i)
    {
      body(Index3{ { i, j, k } });
    }
  }
}

void SetChild(FractionField& field, Index child, FractionField::Range parts,
  const std::vector<OctantFractions>& octants, int c)
{
  std::vector<FractionField::Part> own;
  for (std::size_t p = 0; p < octants.size(); ++p)
  {
    if (octants[p][c] > 0.0)
    {
      own.push_back({ parts.First[p].Material, octants[p][c] });
    }
  }
  if (own.size() == 1)
  {
    field.SetLabel(child, own[0].Material);
    return;
  }
  field.CopyParts(child, { own.data(), own.data() + own.size() });
}

/// Cuts the cells of a layer along z.
void RefineLayer(const CartesianGrid& grid, const FractionField& fractions, Index k,
  Runtime& runtime, RefinedCells& refined)
{
  std::vector<Index3> mixed;
  ForLayer(grid.Extended(ReadLevels), k,
    [&](const Index3& cell)
    {
      const Index n = grid.Linear(cell);
      if (fractions.IsMixed(n))
      {
        mixed.push_back(cell);
        return;
      }
      for (int c = 0; c < 8; ++c)
      {
        refined.Fractions.SetLabel(refined.Grid.Linear(Child(cell, c)), fractions.Label(n));
      }
    });
  std::vector<std::vector<OctantFractions>> octants(mixed.size());
  runtime.For(0, static_cast<Index>(mixed.size()),
    [&](Index begin, Index end)
    {
      for (Index m = begin; m < end; ++m)
      {
        octants[m] = SplitCell(grid, fractions, mixed[m]);
      }
    });
  for (std::size_t m = 0; m < mixed.size(); ++m)
  {
    const FractionField::Range parts = fractions.Parts(grid.Linear(mixed[m]));
    for (int c = 0; c < 8; ++c)
    {
      SetChild(refined.Fractions, refined.Grid.Linear(Child(mixed[m], c)), parts, octants[m], c);
    }
  }
}

} // namespace

RefinedCells RefineCells(
  const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime)
{
  CartesianGrid halved = HalveCells(grid);
  CheckIds(halved, TetElementSlots);
  FractionField field(halved, fractions.NumberOfMaterials());
  RefinedCells refined{ std::move(halved), std::move(field) };
  const IndexBox box = grid.Extended(ReadLevels);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    RefineLayer(grid, fractions, k, runtime, refined);
  }
  return refined;
}

} // namespace vfm
