#include "Labels/ThinParts.h"

#include "Labels/ThinSizes.h"
#include "Labels/Thinning.h"

namespace vfm
{
namespace
{

constexpr int MostPasses = 3;      // of the removal of cells with small loads
constexpr double LeastClaim = 0.6; // fraction that a thin cell claims if it has no load

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
      FindLoad(grid, fractions, cell, label, [&](Index at) { return labels[at] == label; }) });
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
