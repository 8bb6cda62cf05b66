#include "Labels/ResolveLabels.h"

#include "Base/Sorted.h"
#include "Labels/GlueBlocks.h"
#include "Labels/LabelCondition.h"

#include <numeric>

namespace vfm
{
namespace
{

// Perturbations of dead ends before one order of labels must end them.
constexpr int Perturbations = 40;
constexpr int GreedyRounds = 400; // rounds before the same
// Shift of the interface by a costly flip, in cells of the grid.
constexpr double CostlyFlip = 0.3;

/// Best change of one unit.
struct Candidate
{
  double Score;
  int Label;
  Index Key;
  IndexBox Cells; // the cells that change
  bool Beats(const Candidate& other) const
  {
    return this->Score > other.Score || (this->Score == other.Score && this->Key < other.Key);
  }
};

/// Labels and candidates for the next flips.
struct Work : LabelFlips
{
  int Turn = 0;
  bool InOrder = false;  // whether units may only take smaller labels, in the last order
  bool KeepsLast = true; // whether no label may lose its last unit
  std::unordered_map<Index, Candidate> Candidates{}; // by unit
};

/// Returns the position of a label in the current order, which begins at label Turn and wraps
/// around. In the last order, small labels come first.
Index Order(const Work& work, int label)
{
  const Index count = work.Fractions.NumberOfMaterials() + 1;
  const Index size = work.InOrder ? work.Sizes->CappedSize(label) : 0;
  return size * count + (label + count - work.Turn % count) % count;
}

bool MayTake(const Work& work, int current, int label, bool decreasing)
{
  return label != current && !(decreasing && Order(work, label) > Order(work, current));
}

/// Returns the key that decides between equal scores, equal for all copies of a unit.
Index TieKey(const Work& work, const IndexBox& cells)
{
  return work.Grid.CellKey(work.Grid.Canonical(cells.Lower));
}

/// Returns the best of some labels, ascending, that a unit may take; its label is -1
/// if there is none.
Candidate Consider(const Work& work, Index unit, const std::vector<int>& labels, bool decreasing)
{
  const IndexBox cells = work.Units.CellsOf(unit);
  const std::vector<int> gains = FindGains(work, cells, labels);
  Candidate best{ 0.0, -1, TieKey(work, cells), cells };
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    const int gain = gains[n];
    if (gain <= 0 && !decreasing)
    {
      continue;
    }
    const double price = Price(work, cells, work.Labels[unit], labels[n]);
    const double score = gain > 0 ? gain / price : (gain - 1) * price;
    if (best.Label < 0 || score > best.Score)
    {
      best.Score = score;
      best.Label = labels[n];
    }
  }
  return best;
}

void FindCandidates(Work& work, bool decreasing)
{
  work.Candidates.clear();
  std::vector<std::pair<Index, int>> changes;
  for (Index node : work.Violated)
  {
    const StarLabels labels(StarOfNode(work.Grid, work.Labels, node));
    const Index3 position = work.Grid.Position(node);
    for (int s = 0; s < 8; ++s)
    {
      const Index unit = work.Units.UnitOf(CellOfStar(position, s));
      for (int label : labels)
      {
        changes.emplace_back(unit, label);
      }
    }
  }
  SortUnique(changes);
  std::vector<std::size_t> begins; // first change of each unit, and the end
  for (std::size_t n = 0; n < changes.size(); ++n)
  {
    if (n == 0 || changes[n].first != changes[n - 1].first)
    {
      begins.push_back(n);
    }
  }
  begins.push_back(changes.size());
  std::vector<Candidate> found(begins.size() - 1);
  ForEach(work.Run, found.size(),
    [&](Index n)
    {
      const Index unit = changes[begins[n]].first;
      const bool isKept = work.KeepsLast &&
        work.Sizes->IsLast(work.Units.CellsOf(unit).NumberOfCells(), work.Labels[unit]);
      std::vector<int> allowed;
      for (std::size_t c = begins[n]; !isKept && c < begins[n + 1]; ++c)
      {
        if (MayTake(work, work.Labels[unit], changes[c].second, decreasing))
        {
          allowed.push_back(changes[c].second);
        }
      }
      found[n] =
        allowed.empty() ? Candidate{ 0.0, -1, 0, {} } : Consider(work, unit, allowed, decreasing);
    });
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    if (found[n].Label >= 0)
    {
      work.Candidates.emplace(changes[begins[n]].first, found[n]);
    }
  }
}

/// Returns whether no candidate around that shares a node with this one beats it.
bool IsBestAround(const Work& work, const IndexBox& cells, const Candidate& mine)
{
  bool isBest = true;
  ForCells({ CellOfStar(cells.Lower, 0), CornerOfCell(cells.Upper, 7) },
    [&](const Index3& cell)
    {
      if (isBest && !cells.Contains(cell))
      {
        const auto other = work.Candidates.find(work.Units.UnitOf(cell));
        isBest = other == work.Candidates.end() || !other->second.Beats(mine);
      }
    });
  return isBest;
}

/// Flips the best candidates.
void Flip(Work& work)
{
  std::vector<LabelChange> flips;
  std::vector<IndexBox> others;
  for (const auto& candidate : work.Candidates)
  {
    const Candidate& change = candidate.second;
    if (!OwnsSome(work, change.Cells))
    {
      others.push_back(change.Cells);
    }
    else if (IsBestAround(work, change.Cells, change))
    {
      flips.push_back({ change.Cells, change.Label });
    }
  }
  ApplyChanges(work, flips, others);
}

/// Returns the change to the initial label of a cell or leaf, or of its unit if that was its label
/// everywhere; the label is -1 if that would add a violation.
Candidate FindRestoration(const Work& work, Index part, int first)
{
  const Index unit = work.Units.UnitOf(work.Grid.Position(part));
  IndexBox cells = work.Units.CellsOf(unit);
  const int label = work.Labels[part];
  bool isWhole = true;
  ForParts(work, cells,
    [&](Index n, Index)
    {
      const auto at = work.Original.find(n);
      isWhole = isWhole && at != work.Original.end() && at->second == first;
    });
  cells = isWhole ? cells : BoxOfCell(work.Grid.Position(part));
  // A label that lost its initial cells can have others that it got as blocks were glued.
  const bool isKept = work.HasBlocks && work.Sizes->IsLast(cells.NumberOfCells(), label);
  const bool may = label != first && !isKept && Intersect(cells, work.Near) == cells &&
    FindGains(work, cells, { first })[0] == 0;
  return may ? Candidate{ Price(work, cells, first, label), first, TieKey(work, cells), cells }
             : Candidate{ 0.0, -1, 0, {} };
}

/// Makes initial labels candidates where they leave the number of violations unchanged.
void FindRestorable(Work& work)
{
  work.Candidates.clear();
  const std::vector<std::pair<Index, int>> parts(work.Original.begin(), work.Original.end());
  std::vector<Candidate> found(parts.size());
  ForEach(work.Run, parts.size(),
    [&](Index n) { found[n] = FindRestoration(work, parts[n].first, parts[n].second); });
  for (std::size_t n = 0; n < parts.size(); ++n)
  {
    if (found[n].Label >= 0)
    {
      const Index unit = work.Units.UnitOf(work.Grid.Position(parts[n].first));
      const auto at = work.Candidates.emplace(unit, found[n]);
      if (found[n].Beats(at.first->second))
      {
        at.first->second = found[n];
      }
    }
  }
}

/// Restores the initial labels of units where that adds no violation, until no unit is left:
/// reverts useless perturbations. It ends because each round reduces the number of changed units.
/// Not all flips of units beyond Near are known. Returns the number of rounds.
int Restore(Work& work)
{
  for (int rounds = 0;; ++rounds)
  {
    FindRestorable(work);
    if (!work.Parts.Group().Any(!work.Candidates.empty()))
    {
      return rounds;
    }
    Flip(work);
    work.Violated.clear();
  }
}

/// Lists units of several cells whose flip moves the interface by more than CostlyFlip.
std::vector<Index3> FindCostlyFlips(const Work& work)
{
  std::vector<Index3> flips;
  if (!work.Leaves)
  {
    return flips;
  }
  for (const auto& unit : work.Original)
  {
    const IndexBox cells = work.Units.CellsOf(unit.first);
    if (cells.Size(0) > 1 && work.Parts.OwnsCell(cells.Lower) &&
      Cost(work, cells, unit.second, work.Labels[unit.first]) > CostlyFlip)
    {
      flips.push_back(cells.Lower);
    }
  }
  return flips;
}

/// Counts the flipped units of all ranks, by their initial and by their present label.
void CountChanges(const Work& work, ResolveReport& report)
{
  const std::size_t labels = report.LostCells.size();
  std::vector<std::int64_t> counts(2 * labels, 0);
  for (const auto& [unit, first] : work.Original)
  {
    const int label = work.Labels[unit];
    if (label != first && work.Parts.OwnsCell(work.Grid.Position(unit)))
    {
      ++counts[first];
      ++counts[labels + label];
    }
  }
  work.Parts.Group().Sum(counts);
  report.LostCells.assign(counts.begin(), counts.begin() + labels);
  report.GainedCells.assign(counts.begin() + labels, counts.end());
  report.FlippedCells =
    std::accumulate(report.LostCells.begin(), report.LostCells.end(), Index{ 0 });
}

} // namespace

/// Greedy rounds remove violations. In a dead end, one round of perturbations lets units take a
/// smaller label in an order of labels that rotates with each perturbation. In the end the order is
/// fixed, so the sum of the labels of units decreases until no star is violated. A violated star
/// has several labels, hence a unit that can take a smaller label of the star. The best of all
/// candidates flips, and units that flip at once share no star. Only if the last order leaves no
/// other choice, a label loses its last unit. Flat seams: blocks are glued at first and in dead
/// ends. Flips keep them glued, so that ends too.
ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition, Runtime& runtime, const RefinedGrid* leaves,
  bool keepsSeam)
{
  Work work{ { grid, fractions, labels, partition, runtime, leaves,
    keepsSeam && grid.FlatSeams(grid.Domain().Lower) != 0 } };
  work.Violated = FindMixedNodes(work.Grid, work.Labels);
  KeepViolated(work);
  Ranks& ranks = work.Parts.Group();
  ResolveReport report;
  report.LostCells.assign(fractions.NumberOfMaterials() + 1, 0);
  report.GainedCells = report.LostCells;
  if (!ranks.Any(!work.Violated.empty()))
  {
    return report;
  }
  work.Sizes = std::make_unique<LabelSizes>(
    work.Grid, work.Labels, work.Fractions.NumberOfMaterials() + 1, work.Parts);
  report.Rounds += GlueBlocks(work);
  int perturbations = 0;
  while (ranks.Any(!work.Violated.empty()))
  {
    work.InOrder = perturbations > Perturbations || report.Rounds >= GreedyRounds;
    work.KeepsLast = true;
    FindCandidates(work, work.InOrder);
    if (!ranks.Any(!work.Candidates.empty()))
    {
      const int glued = GlueBlocks(work);
      report.Rounds += glued;
      if (glued > 0)
      {
        continue;
      }
      work.InOrder = work.InOrder || ++perturbations > Perturbations;
      work.Turn = work.InOrder ? 0 : perturbations;
      work.KeepsLast = !work.InOrder;
      FindCandidates(work, true);
    }
    Flip(work);
    KeepViolated(work);
    ++report.Rounds;
  }
  report.Rounds += Restore(work);
  CountChanges(work, report);
  report.CostlyFlips = FindCostlyFlips(work);
  return report;
}

} // namespace vfm
