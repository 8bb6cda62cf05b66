#include "Labels/ResolveLabels.h"

#include "Base/Sorted.h"
#include "Fractions/FractionSum.h"
#include "Labels/LabelCondition.h"
#include "Labels/LeafLabels.h"
#include "Labels/SeamBlocks.h"
#include "Ranks/Agreement.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace vfm
{
namespace
{

// Perturbations of dead ends before one order of labels must end them.
constexpr int Perturbations = 40;
constexpr int GreedyRounds = 400; // rounds before the same
// Shift of the interface by a costly flip, in cells of the grid.
constexpr double CostlyFlip = 0.3;
constexpr double CostOffset = 0.05;   // price of a flip that loses no fraction
constexpr Index SmallLabel = 1000;    // cells; each cell of a label with fewer costs more
constexpr double PriceOfGrowth = 0.3; // price of a cell too many, relative to a cell too few

/// New label of some cells.
struct Change
{
  IndexBox Cells;
  int Label;
};

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

/// Calls body(node) for the nodes on the surface of a box of cells.
template <class Body>
void ForSurfaceNodes(const IndexBox& cells, const Body& body)
{
  ForCells(NodesOf(cells),
    [&](const Index3& node)
    {
      bool isInside = true;
      for (int a = 0; a < 3; ++a)
      {
        isInside = isInside && node[a] > cells.Lower[a] && node[a] < cells.Upper[a];
      }
      if (!isInside)
      {
        body(node);
      }
    });
}

/// Number of cells of each label in the domain, initially and now. It determines how much a flip
/// costs the smaller of both labels.
class LabelSizes
{
public:
  /// @pre Collective.
  LabelSizes(
    const CartesianGrid& grid, const LabelArray& labels, int count, const Partition& partition) :
    First(count, 0), Group(&partition.Group())
  {
    partition.ForRows(grid.Owned(),
      [&](Index first, Index last)
      {
        labels.Visit(
          first, last,
          [&](Index begin, Index end, int label) { this->First[label] += end - begin; },
          [&](Index begin, Index end, const int* own)
          { std::for_each(own, own + (end - begin), [&](int label) { ++this->First[label]; }); });
      });
    this->Group->Sum(this->First);
    this->Now = this->First;
    this->HasSmall = std::any_of(this->First.begin(), this->First.end(),
      [](Index cells) { return cells > 0 && cells < SmallLabel; });
  }

  /// Returns the initial size of a label, at most SmallLabel.
  Index CappedSize(int label) const { return std::min<Index>(this->First[label], SmallLabel); }

  bool IsLast(Index cells, int label) const { return this->Now[label] <= cells; }

  /// Returns the factor on the price of a flip of some cells; 1 between large labels. A small label
  /// pays more for the loss of cells if it has at most its initial number, and for a gain if it has
  /// at least that number.
  double Factor(Index cells, int current, int label) const
  {
    const auto partOf = [&](int l)
    { return static_cast<double>(SmallLabel * cells) / static_cast<double>(this->First[l]); };
    return std::max({ 1.0, this->Now[current] <= this->First[current] ? partOf(current) : 0.0,
      this->Now[label] >= this->First[label] ? PriceOfGrowth * partOf(label) : 0.0 });
  }

  /// Counts a flip of this rank.
  void Add(Index cells, int current, int label)
  {
    this->Change.resize(this->Now.size(), 0);
    this->Change[current] -= cells;
    this->Change[label] += cells;
  }
  /// Sums the flips of all ranks.
  /// @pre Collective.
  void Share()
  {
    this->Change.resize(this->Now.size(), 0);
    if (this->HasSmall)
    {
      this->Group->Sum(this->Change);
      std::transform(
        this->Now.begin(), this->Now.end(), this->Change.begin(), this->Now.begin(), std::plus<>());
    }
    std::fill(this->Change.begin(), this->Change.end(), 0);
  }

private:
  std::vector<std::int64_t> First, Now, Change;
  Ranks* Group;
  bool HasSmall = false; // if false, sizes do not matter
};

struct Work
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  LabelArray& Labels;
  const Partition& Parts;
  Runtime& Run;
  const RefinedGrid* Leaves;
  const bool KeepsSeam;                        // whether the condition of flat seams holds too
  const bool HasBlocks = KeepsSeam && !Leaves; // whether cells glued across a seam are one unit
  const LabelUnits Units{ Grid, Leaves, HasBlocks ? &Labels : nullptr };
  /// Holds the units that compete with units of owned cells. A block of an owned cell ends one cell
  /// beyond it, so adjacent units end two cells beyond it.
  const IndexBox Near = Grid.Extended(HasBlocks ? 2 : Units.LargestWidth());
  /// Holds the units of cells in Near. All their nodes are known.
  const IndexBox Reach = Grid.Extended(HasBlocks ? 3 : Units.LargestWidth());
  std::vector<Index> Violated{};
  /// Initial labels of flipped cells or leaves that are owned or in Near, and of others.
  std::unordered_map<Index, int> Original{};
  std::unique_ptr<LabelSizes> Sizes{};
  int Turn = 0;
  bool InOrder = false;  // whether units may only take smaller labels, in the last order
  bool KeepsLast = true; // whether no label may lose its last unit
  std::unordered_map<Index, Candidate> Candidates{};
};

/// Returns whether a node touches a unit whose change competes with changes of owned units. Owned
/// boxes consist of complete base cells, so these units are in Reach.
bool IsNear(const Work& work, Index node)
{
  return work.Reach.Touches(work.Grid.Position(node));
}

bool OwnsSome(const Work& work, const IndexBox& cells)
{
  return Intersect(cells, work.Grid.Owned()).NumberOfCells() > 0;
}

/// Calls body(n, size) for the linear index n and the number of cells of each cell or leaf of a
/// unit or block.
template <class Body>
void ForParts(const Work& work, const IndexBox& cells, const Body& body)
{
  if (work.Leaves)
  {
    body(work.Grid.Linear(cells.Lower), cells.NumberOfCells());
    return;
  }
  ForCells(cells, [&](const Index3& cell) { body(work.Grid.Linear(cell), 1); });
}

/// Returns the violations of a star: of the label condition, and on a flat seam of the condition
/// there.
int Violations(const std::array<int, 8>& star, int flatSeams)
{
  return CountViolations(star) + (flatSeams != 0 ? CountSeamViolations(star, flatSeams) : 0);
}

int Violations(const Work& work, Index node)
{
  return Violations(StarOfNode(work.Grid, work.Labels, node),
    work.KeepsSeam ? work.Grid.FlatSeams(work.Grid.Position(node)) : 0);
}

void KeepViolated(Work& work)
{
  std::vector<Index>& nodes = work.Violated;
  SortUnique(nodes);
  ForEach(work.Run, nodes.size(),
    [&](Index n)
    {
      const bool isKept = IsNear(work, nodes[n]) && Violations(work, nodes[n]) > 0;
      nodes[n] = isKept ? nodes[n] : -1;
    });
  nodes.erase(std::remove(nodes.begin(), nodes.end(), -1), nodes.end());
}

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

/// Returns the violations removed at the nodes of a unit by each of some labels.
std::vector<int> FindGains(const Work& work, const IndexBox& cells, const std::vector<int>& labels)
{
  std::vector<int> gains(labels.size(), 0);
  ForSurfaceNodes(cells,
    [&](const Index3& node)
    {
      std::array<int, 8> star = StarOfNode(work.Grid, work.Labels, work.Grid.Linear(node));
      const int seams = work.KeepsSeam ? work.Grid.FlatSeams(node) : 0;
      const int before = Violations(star, seams);
      const int region = work.Units.RegionAt(node, cells);
      for (std::size_t n = 0; n < labels.size(); ++n)
      {
        for (int s = 0; s < 8; ++s)
        {
          star[s] = region >> s & 1 ? labels[n] : star[s];
        }
        gains[n] += before - Violations(star, seams);
      }
    });
  return gains;
}

/// Returns the fraction that a unit loses times its width: how far the interface moves, in
/// cells of the grid.
double Cost(const Work& work, const IndexBox& cells, int current, int label)
{
  const FractionSum mean = MeanOfCells(work.Grid, work.Fractions, cells);
  return static_cast<double>(cells.Size(0)) *
    std::max(0.0, mean.Fraction(current) - mean.Fraction(label));
}

double Price(const Work& work, const IndexBox& cells, int current, int label)
{
  return work.Sizes->Factor(cells.NumberOfCells(), current, label) *
    (CostOffset + Cost(work, cells, current, label));
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

/// Applies changes on all ranks. Each rank also stores the initial labels of cells that change
/// around its own.
/// @param changes  changes of boxes that hold owned cells
/// @param others  boxes without owned cells that may change
void Apply(Work& work, const std::vector<Change>& changes, const std::vector<IndexBox>& others)
{
  std::vector<std::pair<Index, int>> before; // labels of `others`
  for (const IndexBox& cells : others)
  {
    ForParts(work, cells, [&](Index n, Index) { before.emplace_back(n, work.Labels[n]); });
  }
  for (const Change& change : changes)
  {
    ForParts(work, change.Cells,
      [&](Index n, Index size)
      {
        const int label = work.Labels[n];
        if (label != change.Label)
        {
          work.Original.emplace(n, label);
          work.Sizes->Add(
            work.Parts.OwnsCell(work.Grid.Position(n)) ? size : 0, label, change.Label);
        }
      });
    FillLabels(work.Grid, change.Cells, change.Label, work.Labels);
    ForSurfaceNodes(
      change.Cells, [&](const Index3& node) { work.Violated.push_back(work.Grid.Linear(node)); });
  }
  work.Sizes->Share();
  work.Parts.ExchangeCells(work.Labels,
    [&](Index cell)
    {
      const int label = work.Labels[cell];
      work.Grid.ForMirrors(cell, [&](Index mirror) { work.Labels.Set(mirror, label); });
      for (int c = 0; c < 8; ++c)
      {
        work.Violated.push_back(work.Grid.NodeOfCell(cell, c));
      }
    });
  for (const auto& other : before)
  {
    if (work.Labels[other.first] != other.second)
    {
      work.Original.insert(other);
    }
  }
}

/// Flips the best candidates.
void Flip(Work& work)
{
  std::vector<Change> flips;
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
  Apply(work, flips, others);
}

/// Returns the axes across which labels of cells of blocks break the condition of flat seams, by
/// the lowest cell of the block.
std::map<Index, int> FindBroken(const Work& work)
{
  std::map<Index, int> broken;
  for (Index node : work.Violated)
  {
    const Index3 position = work.Grid.Position(node);
    const int seams = work.Grid.FlatSeams(position);
    const std::array<int, 8> star = StarOfNode(work.Grid, work.Labels, node);
    for (int n = 0; seams != 0 && n < 24; ++n)
    {
      if ((seams >> n / 8 & 1) != 0 && BreaksSeam(star, n % 8, n / 8))
      {
        const IndexBox block = BlockOfCell(work.Grid, CellOfStar(position, n % 8));
        broken[work.Grid.Linear(block.Lower)] |= 1 << n / 8;
      }
    }
  }
  return broken;
}

/// Returns the label of a box of cells for which the prices of all changes of cells have the
/// smallest sum; -1 if each label costs another label its last cell.
int CheapestLabel(const Work& work, const IndexBox& cells)
{
  std::map<int, Index> counts;
  ForCells(cells, [&](const Index3& cell) { ++counts[work.Labels[work.Grid.Linear(cell)]]; });
  int best = -1;
  double lowest = 0.0;
  for (const auto& [label, count] : counts)
  {
    const int kept = label;
    const bool may = std::none_of(counts.begin(), counts.end(),
      [&](const auto& other)
      { return other.first != kept && work.Sizes->IsLast(other.second, other.first); });
    double price = 0.0;
    ForCells(cells,
      [&](const Index3& cell)
      {
        const int current = work.Labels[work.Grid.Linear(cell)];
        price += current != kept ? Price(work, BoxOfCell(cell), current, kept) : 0.0;
      });
    if (may && (best < 0 || price < lowest))
    {
      best = kept;
      lowest = price;
    }
  }
  return best;
}

/// Returns the changes that glue a block along some axes, in addition to the axes along which it
/// is glued; empty if there is no way without the loss of a label.
std::vector<Change> FindGluing(const Work& work, const IndexBox& block, int axes)
{
  axes |= FindGluedAxes(work.Grid, work.Labels, block);
  std::vector<Change> changes;
  bool may = true;
  ForCells(block,
    [&](const Index3& cell)
    {
      const IndexBox part = PartOfBlock(block, axes, cell);
      if (part.Lower == cell)
      {
        changes.push_back({ part, CheapestLabel(work, part) });
        may = may && changes.back().Label >= 0;
      }
    });
  return may ? changes : std::vector<Change>{};
}

/// Glues blocks that break the condition of flat seams, until there is none that can be glued. It
/// ends because blocks remain glued along each axis. Returns the number of rounds.
int GlueBlocks(Work& work)
{
  for (int rounds = 0;; ++rounds)
  {
    std::vector<Change> changes;
    std::vector<IndexBox> others;
    for (const auto& [lowest, axes] : FindBroken(work))
    {
      const IndexBox block = BlockOfCell(work.Grid, work.Grid.Position(lowest));
      const std::vector<Change> gluing = FindGluing(work, block, axes);
      if (OwnsSome(work, block))
      {
        changes.insert(changes.end(), gluing.begin(), gluing.end());
      }
      else if (!gluing.empty())
      {
        others.push_back(block);
      }
    }
    if (!work.Parts.Group().Any(!changes.empty()))
    {
      return rounds;
    }
    Apply(work, changes, others);
    KeepViolated(work);
  }
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
  const bool may = label != first && Intersect(cells, work.Near) == cells &&
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
/// other choice, a label loses its last unit.
ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition, Runtime& runtime, const RefinedGrid* leaves,
  bool keepsSeam)
{
  Work work{ grid, fractions, labels, partition, runtime, leaves,
    keepsSeam && grid.FlatSeams(grid.Domain().Lower) != 0 };
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
  report.Rounds += work.HasBlocks ? GlueBlocks(work) : 0;
  int perturbations = 0;
  while (ranks.Any(!work.Violated.empty()))
  {
    work.InOrder = perturbations > Perturbations || report.Rounds >= GreedyRounds;
    work.KeepsLast = true;
    FindCandidates(work, work.InOrder);
    if (!ranks.Any(!work.Candidates.empty()))
    {
      const int glued = work.HasBlocks ? GlueBlocks(work) : 0;
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
