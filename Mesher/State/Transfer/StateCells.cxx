#include "State/Transfer/StateCells.h"

#include "Base/Vector3.h"

namespace vfm
{
namespace
{

// Fraction of the element's material that is enough in the cell of its centroid.
constexpr double EnoughFraction = 0.5;

Vector3 FindCentroid(const Mesh& mesh, Index element)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  for (int c = 0; c < mesh.Corners; ++c)
  {
    sum = sum + mesh.PointAt(mesh.Elements[mesh.Corners * element + c]);
  }
  return (1.0 / mesh.Corners) * sum; // exact for 4 or 8 corners
}

/// Returns the squared distance of a point from the centre of a cell.
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

/// The cell with the largest fraction of an element's material, among the cells compared.
class FullestCell
{
public:
  FullestCell(const CartesianGrid& grid, const FractionField& fractions, const Vector3& centroid,
    int material) :
    Grid(grid), Fractions(fractions), Centroid(centroid), Material(material)
  {
  }

  void Compare(const IndexBox& cells)
  {
    ForCells(cells,
      [this](const Index3& cell)
      {
        const double fraction = this->Fractions.Fraction(this->Grid.Linear(cell), this->Material);
        const double distance = SquaredDistance(this->Grid, cell, this->Centroid);
        if (fraction > this->Fraction || (fraction == this->Fraction && distance < this->Distance))
        {
          this->Cell = cell;
          this->Fraction = fraction;
          this->Distance = distance;
        }
      });
  }

  Index3 Cell{};
  double Fraction = -1.0;

private:
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const Vector3& Centroid;
  const int Material;
  double Distance = 0.0;
};

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
    const IndexBox own = this->FindOwn(element);
    const IndexBox reach =
      this->TheMesh.Ids.ElementSlots == 0 ? own : Grow(own, StateReach, this->Grid.Global());
    const Index3 cell = reach.Nearest(this->Grid.CellAt(centroid));
    const int material = this->TheMesh.Material[element];
    if (this->Fractions.Fraction(this->Grid.Linear(cell), material) >= EnoughFraction)
    {
      return cell;
    }
    FullestCell fullest(this->Grid, this->Fractions, centroid, material);
    fullest.Compare(Grow(BoxOfCell(cell), 1, this->Grid.Global()));
    const bool isCoarse = this->TheMesh.Ids.ElementSlots > 0 && own.NumberOfCells() > 1;
    if (isCoarse && fullest.Fraction < EnoughFraction)
    {
      fullest.Compare(own);
    }
    return fullest.Cell;
  }

private:
  /// Returns the cells that the element was made of. For TetGen's tets, returns the local cells
  /// except the outermost layer.
  IndexBox FindOwn(Index element) const
  {
    return this->TheMesh.Ids.ElementSlots == 0
      ? this->Grid.Extended(StateReach)
      : CellsOfElement(this->Grid, this->TheMesh, this->TheMesh.ElementIds[element]);
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
  ForEach(
    runtime, cells.size(), [&](Index e) { cells[e] = IndexInBox(grid.Local(), rule.Choose(e)); });
  return cells;
}

} // namespace vfm
