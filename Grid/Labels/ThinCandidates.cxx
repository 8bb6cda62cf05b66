#include "Labels/ThinCandidates.h"

#include <cstdlib>

namespace vfm
{
namespace
{

constexpr double LeastFraction = 0.02; // of a candidate
// The same where the mean around is below LargestFilmMean: in films that cut corners of cells. In
// gaps between bodies it is larger.
constexpr double LeastFilmFraction = 0.003;
constexpr double LargestFilmMean = 0.35;
constexpr double LargestMean = 0.5; // of the material around a candidate
constexpr double RidgeShare = 0.7;  // of the largest fraction around a ridge
// A body ends at a side of the domain if the layer of cells there has less of it than this part of
// the cell before. Else it crosses the side.
constexpr double ShareAtSide = 0.5;

/// Fractions of the 27 cells around a cell.
struct FractionsAround
{
  double Mean = 0.0; // with weights 8, 4, 2, 1 of the middle, faces, edges, corners
  double Largest = 0.0;
  bool HasLabel = false; // whether any of the cells has the material's label
};

/// @param ends  whether cells outside the local box are void; else they count as the nearest cell
///   inside
FractionsAround MeasureAround(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const Index3& cell, int material, bool ends)
{
  FractionsAround around;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 step = StepAround(n);
    const Index3 other = CellAround(cell, n), inside = grid.Local().Nearest(other);
    if (ends && inside != other)
    {
      continue;
    }
    const Index at = grid.Linear(inside);
    const double fraction = fractions.Fraction(at, material);
    const auto distance = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
    around.Mean += fraction / static_cast<double>(8 << distance);
    around.Largest = std::max(around.Largest, fraction);
    around.HasLabel = around.HasLabel || labels[at] == material;
  }
  return around;
}

/// Returns the largest fraction of the 3^2 cells around a cell across an axis.
double LargestAcross(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell,
  int axis, int material)
{
  IndexBox layer = Grow(BoxOfCell(cell), 1, grid.Local());
  layer.Lower[axis] = cell[axis];
  layer.Upper[axis] = cell[axis] + 1;
  double largest = 0.0;
  ForCells(layer,
    [&](const Index3& q)
    { largest = std::max(largest, fractions.Fraction(grid.Linear(q), material)); });
  return largest;
}

/// Returns the steps from a cell at sides of the domain to the cell before along each axis, 0 for
/// other axes.
Index3 StepsInside(const CartesianGrid& grid, const Index3& cell)
{
  Index3 steps{};
  for (int a = 0; a < 3; ++a)
  {
    for (Index step : { -1, 1 })
    {
      Index3 before = cell, behind = cell;
      before[a] += step;
      behind[a] -= step;
      if (!grid.InDomain(behind) && grid.InDomain(before))
      {
        steps[a] = step;
      }
    }
  }
  return steps;
}

/// Returns whether a body ends in a cell at a side of the domain, or at several: then the cell
/// before can be along a diagonal.
/// @param steps  StepsInside of the cell
bool EndsAtSide(const CartesianGrid& grid, const FractionField& fractions, const LabelArray& labels,
  const Index3& cell, const Index3& steps, int material)
{
  for (int axes = 1; axes < 8; ++axes)
  {
    Index3 before = cell;
    bool isAtSides = true;
    for (int a = 0; a < 3; ++a)
    {
      before[a] += axes >> a & 1 ? steps[a] : 0;
      isAtSides = isAtSides && (steps[a] != 0 || !(axes >> a & 1));
    }
    if (!isAtSides || labels[grid.Linear(before)] != material)
    {
      continue;
    }
    double largest = 0.0; // of the layers at the sides
    for (int a = 0; a < 3; ++a)
    {
      largest =
        std::max(largest, axes >> a & 1 ? LargestAcross(grid, fractions, cell, a, material) : 0.0);
    }
    if (largest < ShareAtSide * fractions.Fraction(grid.Linear(before), material))
    {
      return true;
    }
  }
  return false;
}

/// Returns whether a cell at a side of the domain holds much less of a material than the one
/// before.
/// @param steps  StepsInside of the cell
bool FadesAtSide(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell,
  const Index3& steps, int material)
{
  const double fraction = fractions.Fraction(grid.Linear(cell), material);
  for (int a = 0; a < 3; ++a)
  {
    Index3 before = cell;
    before[a] += steps[a];
    if (fraction < ShareAtSide * fractions.Fraction(grid.Linear(before), material))
    {
      return true;
    }
  }
  return false;
}

/// Adds the candidates of a mixed cell.
void AddCandidates(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const Index3& cell, std::vector<ThinCandidate>& list)
{
  const Index at = grid.Linear(cell);
  const Index3 steps = StepsInside(grid, cell);
  const bool isAtSide = steps != Index3{};
  for (const FractionField::Part& part : fractions.Parts(at))
  {
    if (part.Material == 0 || labels[at] == part.Material || !(part.Fraction > LeastFilmFraction))
    {
      continue;
    }
    const bool ends = isAtSide && EndsAtSide(grid, fractions, labels, cell, steps, part.Material);
    const FractionsAround around =
      MeasureAround(grid, fractions, labels, cell, part.Material, ends);
    if (around.Mean < (part.Fraction > LeastFraction ? LargestMean : LargestFilmMean))
    {
      const bool isRidge = !around.HasLabel && part.Fraction >= RidgeShare * around.Largest;
      list.push_back({ at, part.Material, part.Fraction, 0.5 * around.Mean + 0.5 * part.Fraction,
        isRidge, ends, isAtSide && FadesAtSide(grid, fractions, cell, steps, part.Material) });
    }
  }
}

} // namespace

ThinCandidates::ThinCandidates(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, Runtime& runtime) :
  Grid(grid), Labels(labels), First(grid, -1)
{
  const IndexBox box = grid.Extended(Layers);
  std::vector<std::vector<ThinCandidate>> rows(box.Size(1) * box.Size(2));
  ForRows(runtime, box,
    [&](Index j, Index k, Index row)
    {
      const Index first = grid.Linear({ { box.Lower[0], j, k } });
      fractions.VisitRuns(first, first + box.Size(0),
        [&](Index begin, Index, int label)
        {
          if (label < 0)
          {
            AddCandidates(
              grid, fractions, labels, { { box.Lower[0] + begin - first, j, k } }, rows[row]);
          }
        });
    });
  for (const std::vector<ThinCandidate>& row : rows)
  {
    for (const ThinCandidate& candidate : row)
    {
      if (this->List.empty() || this->List.back().Cell != candidate.Cell)
      {
        this->First.Set(candidate.Cell, static_cast<int>(this->List.size()));
      }
      this->List.push_back(candidate);
    }
  }
  this->In.assign(this->List.size(), 1);
}

int ThinCandidates::Find(Index cell, int material) const
{
  const int first = this->First[cell];
  if (first < 0)
  {
    return -1;
  }
  for (std::size_t n = first; n < this->List.size() && this->List[n].Cell == cell; ++n)
  {
    if (this->List[n].Material == material)
    {
      return static_cast<int>(n);
    }
  }
  return -1;
}

CellsAround ThinCandidates::SetAround(const ThinCandidate& candidate, bool mirrored) const
{
  const Index3 p = this->Grid.Position(candidate.Cell);
  CellsAround set = 0;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 cell = CellAround(p, n), inside = this->Grid.Local().Nearest(cell);
    const bool isIn =
      (mirrored || inside == cell) && this->IsInSet(this->Grid.Linear(inside), candidate.Material);
    set |= isIn ? 1u << n : 0u;
  }
  return set;
}

} // namespace vfm
