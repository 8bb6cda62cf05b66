#include "Labels/ThinParts.h"

#include "Base/Vector3.h"
#include "Labels/ThinCandidates.h"
#include "Labels/Thinning.h"

namespace vfm
{
namespace
{

// Thickness above which a candidate with a small load belongs to a body, not to a thin part.
constexpr double LargestThickness = 1.2;
// The same for candidates that only join cells of a body, and their least load per least thickness.
constexpr double LargestFilmAtJoints = 0.95;
constexpr double LeastLoadOfJoints = 0.4;
constexpr int MostPasses = 3;        // of the removal of cells with small loads
constexpr double LeastWeight = 1e-3; // of a cell without the material that gets a share of it
constexpr double LeastClaim = 0.6;   // fraction that a thin cell claims if it has no load

/// Returns the share of the material in the cell at step n from a cell, by which that cell gets
/// material from it: more if it is filled and near.
double WeightOf(double fraction, int n)
{
  const Index3 step = StepAround(n);
  const Index square = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
  return (fraction + LeastWeight) / static_cast<double>(square * square);
}

/// Returns the load of a cell of the set of a material (ThinCell::Load).
/// @param isInSet  isInSet(cell) for linear indices within two cells
template <class IsInSet>
double LoadOf(const CartesianGrid& grid, const FractionField& fractions, const Index3& cell,
  int material, const IsInSet& isInSet)
{
  const auto fraction = [&](const Index3& p)
  { return fractions.Fraction(grid.Linear(p), material); };
  const auto has = [&](const Index3& p)
  { return grid.Local().Contains(p) && isInSet(grid.Linear(p)); };
  const double own = fraction(cell);
  double load = own;
  for (int n = 0; n < 27; ++n)
  {
    const Index3 from = CellAround(cell, n);
    if (n == 13 || !grid.Local().Contains(from) || has(from) || !(fraction(from) > 0.0))
    {
      continue;
    }
    double sum = 0.0;
    for (int m = 0; m < 27; ++m)
    {
      const Index3 to = CellAround(from, m);
      sum += m != 13 && has(to) ? WeightOf(fraction(to), m) : 0.0;
    }
    load += fraction(from) * WeightOf(own, 26 - n) / sum;
  }
  return load;
}

/// Returns the loads of the candidates in the sets, in and around the owned cells.
std::vector<double> FindLoads(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, Runtime& runtime)
{
  const IndexBox box = grid.Extended(1);
  std::vector<double> loads(candidates.Size(), 0.0);
  ForEach(runtime, candidates.Size(),
    [&](Index n)
    {
      const ThinCandidate& candidate = candidates[n];
      const Index3 cell = grid.Position(candidate.Cell);
      if (candidates.IsIn(n) && box.Contains(cell))
      {
        loads[n] = LoadOf(grid, fractions, cell, candidate.Material,
          [&](Index at) { return candidates.IsInSet(at, candidate.Material); });
      }
    });
  return loads;
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
  double Codimension = 0.0; ///< about 1 in a film, 2 in a thread, 3 in a drop
  /// Returns the thickness; threads and drops need less material to be as wide as a film.
  double Thickness() const { return 0.5 * (1.0 + this->Codimension) * this->AsFilm; }
};

/// Measures a set in the 27 cells around a candidate. Half the number of open faces per cell is the
/// codimension, for any direction of a film or thread. Cells of a film that is oblique to the grid
/// cover less of it, by up to sqrt(3): the length of the vector of the open faces across each axis
/// measures that.
LocalSize SizeAt(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, const std::vector<double>& loads, std::size_t n)
{
  const int material = candidates[n].Material;
  const Index3 middle = grid.Position(candidates[n].Cell);
  double load = 0.0, cells = 0.0;
  Vector3 faces{};
  for (int step = 0; step < 27; ++step)
  {
    const Index3 cell = CellAround(middle, step);
    if (!grid.Local().Contains(cell) || !candidates.IsInSet(grid.Linear(cell), material))
    {
      continue;
    }
    const int found = candidates.Find(grid.Linear(cell), material);
    load += found >= 0 ? loads[found] : fractions.Fraction(grid.Linear(cell), material);
    faces = faces + CountOpenFaces(grid, candidates, cell, material);
    cells += 1.0;
  }
  const Vector3 open = (0.5 / cells) * faces;
  const double codimension = open[0] + open[1] + open[2];
  return { load / cells * std::sqrt(codimension) / Norm(open), codimension };
}

/// Returns whether a candidate joins cells with the label of its material and has no other
/// candidate of its set around it.
bool IsJoint(const CartesianGrid& grid, const ThinCandidates& candidates, std::size_t n)
{
  const int material = candidates[n].Material;
  const Index3 middle = grid.Position(candidates[n].Cell);
  bool hasBody = false;
  for (int step = 0; step < 27; ++step)
  {
    const Index3 cell = CellAround(middle, step);
    if (step == 13 || !grid.Local().Contains(cell) ||
      !candidates.IsInSet(grid.Linear(cell), material))
    {
      continue;
    }
    if (candidates.Find(grid.Linear(cell), material) >= 0)
    {
      return false;
    }
    hasBody = true;
  }
  return hasBody;
}

/// Returns whether a candidate holds too little, or is a corner of bodies that are no thin part.
bool IsRefused(const CartesianGrid& grid, const FractionField& fractions,
  const ThinCandidates& candidates, const std::vector<double>& loads, double least, std::size_t n)
{
  const LocalSize size = SizeAt(grid, fractions, candidates, loads, n);
  const double thickness = size.Thickness();
  if (IsJoint(grid, candidates, n))
  {
    return !(thickness >= least && size.AsFilm <= LargestFilmAtJoints &&
      loads[n] >= LeastLoadOfJoints * least);
  }
  return !(thickness >= least && (thickness <= LargestThickness || loads[n] >= least));
}

/// Removes refused candidates from the sets, a few times: their material then loads the others.
void RemoveRefused(const CartesianGrid& grid, const FractionField& fractions, double least,
  const Partition& partition, Runtime& runtime, ThinCandidates& candidates)
{
  bool hasRemoved = true;
  for (int pass = 0; hasRemoved && pass < MostPasses; ++pass)
  {
    const std::vector<double> loads = FindLoads(grid, fractions, candidates, runtime);
    std::vector<unsigned char> isRefused(candidates.Size(), 0);
    ForEach(runtime, candidates.Size(),
      [&](Index n)
      {
        isRefused[n] = candidates.IsIn(n) &&
          grid.Owned().Contains(grid.Position(candidates[n].Cell)) &&
          IsRefused(grid, fractions, candidates, loads, least, n);
      });
    std::vector<ThinAction> own;
    for (std::size_t n = 0; n < candidates.Size(); ++n)
    {
      if (isRefused[n])
      {
        own.push_back({ n, true });
      }
    }
    for (const ThinAction& action : ShareActions(grid, candidates, partition, own))
    {
      candidates.Remove(action.Candidate);
    }
    hasRemoved = partition.Group().Any(!own.empty());
  }
}

/// Sets the labels of owned cells that are in sets. Returns these cells.
std::vector<Index> LabelOwned(
  const CartesianGrid& grid, const ThinCandidates& candidates, LabelArray& labels)
{
  std::vector<Index> changed;
  double best = 0.0; // fraction of the material that has the last cell
  for (std::size_t n = 0; n < candidates.Size(); ++n)
  {
    const ThinCandidate& candidate = candidates[n];
    const bool isNew = changed.empty() || changed.back() != candidate.Cell;
    if (!candidates.IsIn(n) || !grid.Owned().Contains(grid.Position(candidate.Cell)) ||
      (!isNew && candidate.Fraction <= best))
    {
      continue;
    }
    best = candidate.Fraction;
    labels.Set(candidate.Cell, candidate.Material);
    if (isNew)
    {
      changed.push_back(candidate.Cell);
    }
  }
  return changed;
}

/// A load of a cell of a box that two ranks have.
struct SentLoad
{
  Index Place; // IndexInBox
  double Load;
};

/// Returns the loads of thin cells of the local box, ascending. own: those of owned cells.
std::vector<ThinCell> ShareLoads(
  const CartesianGrid& grid, const Partition& partition, const std::vector<ThinCell>& own)
{
  std::vector<ThinCell> all = own;
  partition.ExchangeBoxes(
    [&](const IndexBox& box)
    {
      std::vector<SentLoad> sent;
      for (const ThinCell& thin : own)
      {
        const Index3 cell = grid.Position(thin.Cell);
        if (box.Contains(cell))
        {
          sent.push_back({ IndexInBox(box, cell), thin.Load });
        }
      }
      return ToBytes(sent);
    },
    [&](const IndexBox& box, const Bytes& bytes)
    {
      for (const SentLoad& sent : FromBytes<SentLoad>(bytes))
      {
        all.push_back({ grid.Linear(CellInBox(box, sent.Place)), sent.Load });
      }
    });
  std::sort(
    all.begin(), all.end(), [](const ThinCell& a, const ThinCell& b) { return a.Cell < b.Cell; });
  return all;
}

} // namespace

std::vector<ThinCell> LabelThinParts(const CartesianGrid& grid, const FractionField& fractions,
  double leastThickness, const Partition& partition, Runtime& runtime, LabelArray& labels)
{
  std::vector<Index> cells;
  {
    ThinCandidates candidates(grid, fractions, labels, runtime);
    if (!partition.Group().Any(candidates.Size() > 0))
    {
      return {};
    }
    ThinSets(grid, partition, runtime, candidates);
    RemoveRefused(grid, fractions, leastThickness, partition, runtime, candidates);
    cells = LabelOwned(grid, candidates, labels);
  }
  const auto mirror = [&](Index cell)
  { grid.ForMirrors(cell, [&](Index other) { labels.Set(other, labels[cell]); }); };
  std::for_each(cells.begin(), cells.end(), mirror);
  partition.ExchangeCells(labels, mirror);
  std::vector<ThinCell> own;
  for (Index cell : cells)
  {
    const int label = labels[cell];
    own.push_back({ cell,
      LoadOf(grid, fractions, grid.Position(cell), label,
        [&](Index at) { return labels[at] == label; }) });
  }
  return ShareLoads(grid, partition, own);
}

namespace
{

/// Returns the parts of a thin cell of which its label has the most.
std::vector<FractionField::Part> ClaimParts(
  const FractionField& fractions, const ThinCell& thin, int label)
{
  const double claim = LeastClaim + (1.0 - LeastClaim) * std::min(thin.Load, 1.0);
  double others = 0.0;
  fractions.ForParts(thin.Cell,
    [&](int material, double fraction)
    { others += material > 0 && material != label ? fraction : 0.0; });
  const double scale = (1.0 - claim) / std::max(others, 1.0 - claim);
  std::vector<FractionField::Part> parts;
  fractions.ForParts(thin.Cell,
    [&](int material, double fraction)
    {
      if (material > 0)
      {
        parts.push_back({ material, material == label ? claim : fraction * scale });
      }
    });
  return parts;
}

} // namespace

WithClaims::WithClaims(
  const FractionField& fractions, const LabelArray& labels, const std::vector<ThinCell>& thin) :
  Fractions(fractions)
{
  if (thin.empty())
  {
    return;
  }
  this->Claims = fractions;
  for (const ThinCell& cell : thin)
  {
    this->Claims->SetParts(cell.Cell, ClaimParts(fractions, cell, labels[cell.Cell]));
  }
}

} // namespace vfm
