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

using Candidates = std::unordered_map<Index, Candidate>; // by unit

/// Which labels units may take in a round.
struct FlipRules
{
  int Turn = 0;          // label that is first in the order of labels
  bool InOrder = false;  // whether units may only take smaller labels, in the last order
  bool KeepsLast = true; // whether no label may lose its last unit
};

/// Returns the position of a label in the current order, which begins at label Turn and wraps
/// around. In the last order, small labels come first.
Index Order(const LabelFlips& flips, const FlipRules& rules, int label)
{
  const Index count = flips.Fractions.NumberOfMaterials() + 1;
  const Index size = rules.InOrder ? flips.Sizes->CappedSize(label) : 0;
  return size * count + (label + count - rules.Turn % count) % count;
}

/// Returns whether a unit may take a label.
/// @param decreasing  whether it must come before the current label in the order
bool MayTake(
  const LabelFlips& flips, const FlipRules& rules, bool decreasing, Index unit, int label)
{
  const int current = flips.Labels[unit];
  return label != current &&
    !(decreasing && Order(flips, rules, label) > Order(flips, rules, current));
}

/// Returns the key that decides between equal scores, equal for all copies of a unit.
Index TieKey(const CartesianGrid& grid, const IndexBox& cells)
{
  return grid.CellKey(grid.Canonical(cells.Lower));
}

/// Returns the best of some labels, ascending, that a unit may take; its label is -1
/// if there is none.
Candidate Consider(
  const LabelFlips& flips, Index unit, const std::vector<int>& labels, bool decreasing)
{
  const IndexBox cells = flips.Units.CellsOf(unit);
  const std::vector<int> gains = FindGains(flips, cells, labels);
  Candidate best{ 0.0, -1, TieKey(flips.Grid, cells), cells };
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    const int gain = gains[n];
    if (gain <= 0 && !decreasing)
    {
      continue;
    }
    const double price = Price(flips, cells, flips.Labels[unit], labels[n]);
    const double score = gain > 0 ? gain / price : (gain - 1) * price;
    if (best.Label < 0 || score > best.Score)
    {
      best.Score = score;
      best.Label = labels[n];
    }
  }
  return best;
}

/// Returns the labels around violated nodes that each unit there could take, as pairs, ascending.
std::vector<std::pair<Index, int>> ListChoices(const LabelFlips& flips)
{
  std::vector<std::pair<Index, int>> choices;
  for (Index node : flips.Violated)
  {
    const StarLabels labels(StarOfNode(flips.Grid, flips.Labels, node));
    const Index3 position = flips.Grid.Position(node);
    for (int s = 0; s < 8; ++s)
    {
      const Index unit = flips.Units.UnitOf(CellOfStar(position, s));
      for (int label : labels)
      {
        choices.emplace_back(unit, label);
      }
    }
  }
  SortUnique(choices);
  return choices;
}

/// Returns the best changes of units at violated nodes.
/// @param decreasing  whether units only take labels before their own in the order
Candidates FindCandidates(
  const LabelFlips& flips, const FlipRules& rules, bool decreasing, Runtime& runtime)
{
  const std::vector<std::pair<Index, int>> choices = ListChoices(flips);
  std::vector<std::size_t> begins; // first choice of each unit, and the end
  for (std::size_t n = 0; n < choices.size(); ++n)
  {
    if (n == 0 || choices[n].first != choices[n - 1].first)
    {
      begins.push_back(n);
    }
  }
  begins.push_back(choices.size());
  std::vector<Candidate> found(begins.size() - 1);
  ForEach(runtime, found.size(),
    [&](Index n)
    {
      const Index unit = choices[begins[n]].first;
      const bool isKept = rules.KeepsLast &&
        flips.Sizes->IsLast(flips.Units.CellsOf(unit).NumberOfCells(), flips.Labels[unit]);
      std::vector<int> allowed;
      for (std::size_t c = begins[n]; !isKept && c < begins[n + 1]; ++c)
      {
        if (MayTake(flips, rules, decreasing, unit, choices[c].second))
        {
          allowed.push_back(choices[c].second);
        }
      }
      found[n] =
        allowed.empty() ? Candidate{ 0.0, -1, 0, {} } : Consider(flips, unit, allowed, decreasing);
    });
  Candidates candidates;
  for (std::size_t n = 0; n < found.size(); ++n)
  {
    if (found[n].Label >= 0)
    {
      candidates.emplace(choices[begins[n]].first, found[n]);
    }
  }
  return candidates;
}

/// Returns whether no candidate around that shares a node with this one beats it.
bool IsBestAround(const Candidates& candidates, const LabelUnits& units, const Candidate& mine)
{
  const IndexBox& cells = mine.Cells;
  bool isBest = true;
  ForCells({ CellOfStar(cells.Lower, 0), CornerOfCell(cells.Upper, 7) },
    [&](const Index3& cell)
    {
      if (isBest && !cells.Contains(cell))
      {
        const auto other = candidates.find(units.UnitOf(cell));
        isBest = other == candidates.end() || !other->second.Beats(mine);
      }
    });
  return isBest;
}

/// Flips the best candidates.
void Flip(const Candidates& candidates, LabelFlips& flips)
{
  std::vector<LabelChange> changes;
  std::vector<IndexBox> others;
  for (const auto& candidate : candidates)
  {
    const Candidate& change = candidate.second;
    if (!OwnsSome(flips, change.Cells))
    {
      others.push_back(change.Cells);
    }
    else if (IsBestAround(candidates, flips.Units, change))
    {
      changes.push_back({ change.Cells, change.Label });
    }
  }
  ApplyChanges(flips, changes, others);
}

/// Returns the change to the initial label of a cell or leaf, or of its unit if that was its label
/// everywhere; the label is -1 if that would add a violation.
Candidate FindRestoration(const LabelFlips& flips, Index part, int first)
{
  const Index unit = flips.Units.UnitOf(flips.Grid.Position(part));
  IndexBox cells = flips.Units.CellsOf(unit);
  const int label = flips.Labels[part];
  bool isWhole = true;
  ForParts(flips, cells,
    [&](Index n, Index)
    {
      const auto at = flips.Original.find(n);
      isWhole = isWhole && at != flips.Original.end() && at->second == first;
    });
  cells = isWhole ? cells : BoxOfCell(flips.Grid.Position(part));
  // A label that lost its initial cells can have others that it got as blocks were glued.
  const bool isKept = flips.HasBlocks && flips.Sizes->IsLast(cells.NumberOfCells(), label);
  const bool may = label != first && !isKept && Intersect(cells, flips.Near) == cells &&
    FindGains(flips, cells, { first })[0] == 0;
  return may
    ? Candidate{ Price(flips, cells, first, label), first, TieKey(flips.Grid, cells), cells }
    : Candidate{ 0.0, -1, 0, {} };
}

/// Returns the changes to initial labels that leave the number of violations unchanged.
Candidates FindRestorable(const LabelFlips& flips, Runtime& runtime)
{
  const std::vector<std::pair<Index, int>> parts(flips.Original.begin(), flips.Original.end());
  std::vector<Candidate> found(parts.size());
  ForEach(runtime, parts.size(),
    [&](Index n) { found[n] = FindRestoration(flips, parts[n].first, parts[n].second); });
  Candidates candidates;
  for (std::size_t n = 0; n < parts.size(); ++n)
  {
    if (found[n].Label >= 0)
    {
      const Index unit = flips.Units.UnitOf(flips.Grid.Position(parts[n].first));
      const auto at = candidates.emplace(unit, found[n]);
      if (found[n].Beats(at.first->second))
      {
        at.first->second = found[n];
      }
    }
  }
  return candidates;
}

/// Restores the initial labels of units where that adds no violation, until no unit is left:
/// reverts useless perturbations. It ends because each round reduces the number of changed units.
/// Not all flips of units beyond Near are known. Returns the number of rounds.
int Restore(LabelFlips& flips, Runtime& runtime)
{
  for (int rounds = 0;; ++rounds)
  {
    const Candidates candidates = FindRestorable(flips, runtime);
    if (!flips.Parts.Group().Any(!candidates.empty()))
    {
      return rounds;
    }
    Flip(candidates, flips);
    flips.Violated.clear();
  }
}

/// Lists units of several cells whose flip moves the interface by more than CostlyFlip.
std::vector<Index3> FindCostlyFlips(const LabelFlips& flips)
{
  std::vector<Index3> costly;
  if (!flips.Leaves)
  {
    return costly;
  }
  for (const auto& unit : flips.Original)
  {
    const IndexBox cells = flips.Units.CellsOf(unit.first);
    if (cells.Size(0) > 1 && flips.Parts.OwnsCell(cells.Lower) &&
      Cost(flips, cells, unit.second, flips.Labels[unit.first]) > CostlyFlip)
    {
      costly.push_back(cells.Lower);
    }
  }
  return costly;
}

/// Counts the flipped units of all ranks, by their initial and by their present label.
void CountChanges(const LabelFlips& flips, ResolveReport& report)
{
  const std::size_t labels = report.LostCells.size();
  std::vector<std::int64_t> counts(2 * labels, 0);
  for (const auto& [unit, first] : flips.Original)
  {
    const int label = flips.Labels[unit];
    if (label != first && flips.Parts.OwnsCell(flips.Grid.Position(unit)))
    {
      ++counts[first];
      ++counts[labels + label];
    }
  }
  flips.Parts.Group().Sum(counts);
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
  LabelFlips flips{ grid, fractions, labels, partition, leaves,
    keepsSeam && grid.FlatSeams(grid.Domain().Lower) != 0 };
  flips.Violated = FindMixedNodes(flips.Grid, flips.Labels);
  KeepViolated(flips, runtime);
  Ranks& ranks = flips.Parts.Group();
  ResolveReport report;
  report.LostCells.assign(fractions.NumberOfMaterials() + 1, 0);
  report.GainedCells = report.LostCells;
  if (!ranks.Any(!flips.Violated.empty()))
  {
    return report;
  }
  flips.Sizes = std::make_unique<LabelSizes>(
    flips.Grid, flips.Labels, flips.Fractions.NumberOfMaterials() + 1, flips.Parts);
  report.Rounds += GlueBlocks(flips, runtime);
  FlipRules rules;
  int perturbations = 0;
  while (ranks.Any(!flips.Violated.empty()))
  {
    rules.InOrder = perturbations > Perturbations || report.Rounds >= GreedyRounds;
    rules.KeepsLast = true;
    Candidates candidates = FindCandidates(flips, rules, rules.InOrder, runtime);
    if (!ranks.Any(!candidates.empty()))
    {
      const int glued = GlueBlocks(flips, runtime);
      report.Rounds += glued;
      if (glued > 0)
      {
        continue;
      }
      rules.InOrder = rules.InOrder || ++perturbations > Perturbations;
      rules.Turn = rules.InOrder ? 0 : perturbations;
      rules.KeepsLast = !rules.InOrder;
      candidates = FindCandidates(flips, rules, true, runtime);
    }
    Flip(candidates, flips);
    KeepViolated(flips, runtime);
    ++report.Rounds;
  }
  report.Rounds += Restore(flips, runtime);
  CountChanges(flips, report);
  report.CostlyFlips = FindCostlyFlips(flips);
  return report;
}

} // namespace vfm
