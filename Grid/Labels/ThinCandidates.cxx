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

/// Fractions of the 27 cells around a cell; a cell outside the local box counts as the nearest cell
/// inside.
struct FractionsAround
{
  double Mean = 0.0; // with weights 8, 4, 2, 1 of the middle, faces, edges, corners
  double Largest = 0.0;
  bool HasLabel = false; // whether any of the cells has the material's label
};

FractionsAround MeasureAround(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const Index3& cell, int material)
{
  FractionsAround around;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 step = StepAround(n);
    const Index at = grid.Linear(grid.Local().Nearest(CellAround(cell, n)));
    const double fraction = fractions.Fraction(at, material);
    const auto distance = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
    around.Mean += fraction / static_cast<double>(8 << distance);
    around.Largest = std::max(around.Largest, fraction);
    around.HasLabel = around.HasLabel || labels[at] == material;
  }
  return around;
}

/// Adds the candidates of a mixed cell.
void AddCandidates(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const Index3& cell, std::vector<ThinCandidate>& list)
{
  const Index at = grid.Linear(cell);
  for (const FractionField::Part& part : fractions.Parts(at))
  {
    if (part.Material == 0 || labels[at] == part.Material || !(part.Fraction > LeastFilmFraction))
    {
      continue;
    }
    const FractionsAround around = MeasureAround(grid, fractions, labels, cell, part.Material);
    if (around.Mean < (part.Fraction > LeastFraction ? LargestMean : LargestFilmMean))
    {
      const bool isRidge = !around.HasLabel && part.Fraction >= RidgeShare * around.Largest;
      list.push_back(
        { at, part.Material, part.Fraction, 0.5 * around.Mean + 0.5 * part.Fraction, isRidge });
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
