#include "Labels/ThinSizes.h"

#include "Base/Vector3.h"

namespace vfm
{
namespace
{

// Thickness above which a candidate with a small load belongs to a body, not to a thin part.
constexpr double LargestThickness = 1.2;
// The same, measured as a film, for candidates that only join cells of a body, and their least load
// per least thickness.
constexpr double LargestFilmAtJoints = 0.95;
constexpr double LeastLoadOfJoints = 0.4;
constexpr double LeastWeight = 1e-3; // of a cell without the material that gets a share of it

/// Returns the weight by which a cell gets a share of the material in the cell at step n from it.
double WeightOf(double fraction, int n)
{
  const Index3 step = StepAround(n);
  const Index square = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
  return (fraction + LeastWeight) / static_cast<double>(square * square);
}

/// Calls body(cell, linear index) for the cells of the set of a candidate in the 27 around it.
template <class Body>
void ForSetAround(const CartesianGrid& grid, const ThinCandidates& candidates,
  const ThinCandidate& candidate, const Body& body)
{
  const Index3 middle = grid.Position(candidate.Cell);
  for (int n = 0; n < 27; ++n)
  {
    const Index3 cell = CellAround(middle, n);
    if (grid.Local().Contains(cell) && candidates.IsInSet(grid.Linear(cell), candidate.Material))
    {
      body(cell, grid.Linear(cell));
    }
  }
}

/// Returns the number of faces of a cell of a set across each axis that no other cell of the set
/// shares. A set that reaches a side of the domain continues there; one along the side does not.
Vector3 CountOpenFaces(
  const CartesianGrid& grid, const ThinCandidates& candidates, const Index3& cell, int material)
{
  Vector3 count{};
  for (int a = 0; a < 3; ++a)
  {
    std::array<int, 2> isShared; // 1, 0, or -1 outside of the domain
    for (int side = 0; side < 2; ++side)
    {
      Index3 other = cell;
      other[a] += 2 * side - 1;
      isShared[side] =
        grid.Local().Contains(other) ? candidates.IsInSet(grid.Linear(other), material) : -1;
    }
    for (int side = 0; side < 2; ++side)
    {
      const int shared = isShared[side] < 0 ? isShared[1 - side] : isShared[side];
      count[a] += shared > 0 ? 0.0 : 1.0;
    }
  }
  return count;
}

/// Size of a set around a candidate.
struct LocalSize
{
  double AsFilm = 0.0;      ///< thickness in cells, if the set is a film
  double Codimension = 0.0; ///< about 1 in a film, 2 in a thread, 3 in a drop; less in a body
  /// Returns the thickness; threads and drops need less material to be as wide as a film.
  double Thickness() const { return 0.5 * (1.0 + std::max(this->Codimension, 1.0)) * this->AsFilm; }
};

/// Measures a set in the 27 cells around a candidate. Half the number of open faces per cell is the
/// codimension, for any direction of a film or thread. Cells of a film that is oblique to the grid
/// cover less of it, by up to sqrt(3): the length of the vector of the open faces across each axis
/// measures that.
LocalSize SizeAt(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, const std::vector<double>& loads,
  const ThinCandidate& candidate)
{
  double load = 0.0, cells = 0.0;
  Vector3 faces{};
  ForSetAround(grid, candidates, candidate,
    [&](const Index3& cell, Index at)
    {
      const int found = candidates.Find(at, candidate.Material);
      load += found >= 0 ? loads[found] : fractions.Fraction(at, candidate.Material);
      faces = faces + CountOpenFaces(grid, candidates, cell, candidate.Material);
      cells += 1.0;
    });
  const Vector3 open = (0.5 / cells) * faces;
  const double codimension = open[0] + open[1] + open[2];
  return { load / cells * std::sqrt(codimension) / Norm(open), codimension };
}

/// Returns whether a candidate joins cells with the label of its material and has no other
/// candidate of its set around it.
bool IsJoint(
  const CartesianGrid& grid, const ThinCandidates& candidates, const ThinCandidate& candidate)
{
  bool hasBody = false, hasOthers = false;
  ForSetAround(grid, candidates, candidate,
    [&](const Index3&, Index at)
    {
      const bool isCandidate = candidates.Find(at, candidate.Material) >= 0;
      hasBody = hasBody || !isCandidate;
      hasOthers = hasOthers || (isCandidate && at != candidate.Cell);
    });
  return hasBody && !hasOthers;
}

} // namespace

double FindLoad(const CartesianGrid& grid, const FractionField& fractions, Index cell, int material,
  const std::function<bool(Index)>& isInSet)
{
  const auto isIn = [&](const Index3& p)
  { return grid.Local().Contains(p) && isInSet(grid.Linear(p)); };
  const double own = fractions.Fraction(cell, material);
  double load = own;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 from = CellAround(grid.Position(cell), n);
    const double given = n != 13 && grid.Local().Contains(from)
      ? fractions.Fraction(grid.Linear(from), material)
      : 0.0;
    if (!(given > 0.0) || isIn(from))
    {
      continue;
    }
    double sum = 0.0;
    for (int m = 0; m < 27; ++m)
    {
      const Index3 to = CellAround(from, m);
      sum += m != 13 && isIn(to) ? WeightOf(fractions.Fraction(grid.Linear(to), material), m) : 0.0;
    }
    load += given * WeightOf(own, 26 - n) / sum;
  }
  return load;
}

std::vector<double> FindLoads(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, Runtime& runtime)
{
  const IndexBox box = grid.Extended(1);
  std::vector<double> loads(candidates.Size(), 0.0);
  ForEach(runtime, candidates.Size(),
    [&](Index n)
    {
      const ThinCandidate& candidate = candidates[n];
      if (candidates.IsIn(n) && box.Contains(grid.Position(candidate.Cell)))
      {
        loads[n] = FindLoad(grid, fractions, candidate.Cell, candidate.Material,
          [&](Index at) { return candidates.IsInSet(at, candidate.Material); });
      }
    });
  return loads;
}

bool IsRefused(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, const std::vector<double>& loads, double leastThickness,
  std::size_t candidate)
{
  const LocalSize size = SizeAt(grid, fractions, candidates, loads, candidates[candidate]);
  const double load = loads[candidate];
  if (size.Thickness() < leastThickness)
  {
    return true;
  }
  return IsJoint(grid, candidates, candidates[candidate])
    ? size.AsFilm > LargestFilmAtJoints || load < LeastLoadOfJoints * leastThickness
    : size.Thickness() > LargestThickness && load < leastThickness;
}

} // namespace vfm
