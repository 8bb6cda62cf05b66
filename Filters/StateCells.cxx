#include "StateCells.h"

#include "MakePartition.h"

namespace vfm
{
namespace
{

constexpr double EnoughFraction = 0.5; // of the element's material in the cell of its centroid

Vector3 FindCentroid(const Mesh& mesh, Index element)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int c = 0; c < mesh.Corners; ++c)
  {
    const double* point = mesh.Points.data() + 3 * mesh.Elements[mesh.Corners * element + c];
    for (int a = 0; a < 3; ++a)
    {
      sum[a] += point[a];
    }
  }
  return { { sum[0] / mesh.Corners, sum[1] / mesh.Corners, sum[2] / mesh.Corners } };
}

IndexBox BoxOf(const Index3& cell)
{
  return { cell, { { cell[0] + 1, cell[1] + 1, cell[2] + 1 } } };
}

/// The cell of a box that holds a point, or the nearest.
Index3 FindCell(const CartesianGrid& grid, const IndexBox& box, const Vector3& point)
{
  Index3 cell;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    const Index i = std::upper_bound(x.begin(), x.end(), point[a]) - x.begin() - 1;
    cell[a] = std::min(std::max(i, box.Lower[a]), box.Upper[a] - 1);
  }
  return cell;
}

/// From the centre of a cell, squared.
double SquaredDistance(const CartesianGrid& grid, const Index3& cell, const Vector3& point)
{
  double sum = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    const double d = point[a] - 0.5 * (x[cell[a]] + x[cell[a] + 1]);
    sum += d * d;
  }
  return sum;
}

/// Of a cell and its neighbours the one that holds most of the material.
Index3 FindFullest(const CartesianGrid& grid, const FractionField& fractions, const Index3& middle,
  const Vector3& centroid, int material)
{
  const IndexBox around = Grow(BoxOf(middle), 1, grid.Global());
  Index3 best = middle;
  double bestFraction = -1.0, bestDistance = 0.0;
  for (Index k = around.Lower[2]; k < around.Upper[2]; ++k)
  {
    for (Index j = around.Lower[1]; j < around.Upper[1]; ++j)
    {
      for (Index i = around.Lower[0]; i < around.Upper[0]; ++i)
      {
        const Index3 cell{ { i, j, k } };
        const double fraction = fractions.Fraction(grid.Linear(cell), material);
        const double distance = SquaredDistance(grid, cell, centroid);
        if (fraction > bestFraction || (fraction == bestFraction && distance < bestDistance))
        {
          best = cell;
          bestFraction = fraction;
          bestDistance = distance;
        }
      }
    }
  }
  return best;
}

/// Applies the rule to the elements of a mesh.
class StateRule
{
public:
  StateRule(const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions) :
    TheMesh(mesh), Grid(grid), Fractions(fractions)
  {
  }

  Index3 Choose(Index element) const
  {
    const Vector3 centroid = FindCentroid(this->TheMesh, element);
    const Index3 cell = FindCell(this->Grid, this->Reach(element), centroid);
    const int material = this->TheMesh.Material[element];
    return this->Fractions.Fraction(this->Grid.Linear(cell), material) >= EnoughFraction
      ? cell
      : FindFullest(this->Grid, this->Fractions, cell, centroid, material);
  }

private:
  /// The cells in which the centroid may lie.
  IndexBox Reach(Index element) const
  {
    if (this->TheMesh.ElementSlots == 0)
    {
      return this->Grid.Extended(StateReach);
    }
    const Index3 cell = CellOfElement(this->Grid, this->TheMesh, this->TheMesh.ElementIds[element]);
    return Grow(BoxOf(cell), StateReach, this->Grid.Global());
  }

  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const FractionField& Fractions;
};

} // namespace

std::vector<Index> FindStateCells(
  const Mesh& mesh, const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime)
{
  const StateRule rule(mesh, grid, fractions);
  std::vector<Index> cells(mesh.Material.size());
  runtime.For(0, static_cast<Index>(cells.size()),
    [&](Index begin, Index end)
    {
      for (Index e = begin; e < end; ++e)
      {
        cells[e] = PlaceInBox(grid.Local(), rule.Choose(e));
      }
    });
  return cells;
}

} // namespace vfm
