#include "Labels/ResolveLabels.h"

#include "Base/Sorted.h"
#include "Fractions/FractionSum.h"
#include "Labels/LabelCondition.h"
#include "Labels/LeafLabels.h"

#include <algorithm>
#include <unordered_map>

namespace vfm
{
namespace
{

constexpr int Perturbations = 40;   // ways out of dead ends before one order of labels must end it
constexpr int GreedyRounds = 400;   // likewise
constexpr double CostlyFlip = 0.3;  // of a flip, in cells of the grid
constexpr double CostOffset = 0.05; // a flip that gives up no fraction still has a price
constexpr Index SmallLabel = 1000;  // cells; of labels with fewer each cell costs more
constexpr double PriceOfGrowth = 0.3; // of a cell too many, in prices of one too few

/// The change of one unit that scores best.
struct Candidate
{
  double Score;
  int Label;
  Index Key;
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

/// How many cells of the domain each label has had at first and has now: what a flip costs the smaller of both labels.
class LabelSizes
{
public:
  /// Collective.
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

  /// Of a label at first, no more than a small one may have.
  Index CappedSize(int label) const { return std::min<Index>(this->First[label], SmallLabel); }

  bool IsLast(Index cells, int label) const { return this->Now[label] <= cells; }

  /// Times which a flip of some cells costs: 1 between large labels. A small one that has as many cells as at first, or fewer, can
  /// less afford to lose some, and one that has as many or more to get some.
  double Factor(Index cells, int current, int label) const
  {
    const auto partOf = [&](int l)
    { return static_cast<double>(SmallLabel * cells) / static_cast<double>(this->First[l]); };
    return std::max({ 1.0, this->Now[current] <= this->First[current] ? partOf(current) : 0.0,
      this->Now[label] >= this->First[label] ? PriceOfGrowth * partOf(label) : 0.0 });
  }

  /// Counts what this rank flips.
  void Add(Index cells, int current, int label)
  {
    this->Change.resize(this->Now.size(), 0);
    this->Change[current] -= cells;
    this->Change[label] += cells;
  }
  /// Makes it known. Collective.
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
  bool HasSmall = false; // else no size matters
};

class Resolver
{
public:
  Resolver(const CartesianGrid& grid, const FractionField& fractions, LabelArray& labels,
    const Partition& partition, Runtime& runtime, const RefinedGrid* leaves) :
    Grid(grid),
    Fractions(fractions),
    Labels(labels),
    Parts(partition),
    Run(runtime),
    Units(grid, leaves),
    Reach(grid.Extended(this->Units.LargestWidth()))
  {
  }

  /// Greedy rounds remove violations. In a dead end one round of perturbations lets units take a smaller label in an order
  /// of the labels that turns from perturbation to perturbation. At last the order stays, so the sum of the units' labels falls until
  /// no star is violated: a violated star has several labels, hence a unit that can take a smaller label of the star; the best
  /// of all candidates flips, and units that flip at once have no star in common. Only where the last order leaves nothing else, a label loses
  /// its last unit.
  ResolveReport Resolve()
  {
    this->Violated = FindMixedNodes(this->Grid, this->Labels);
    this->KeepViolated();
    Ranks& ranks = this->Parts.Group();
    ResolveReport report;
    if (!ranks.Any(!this->Violated.empty()))
    {
      return report;
    }
    this->Sizes = std::make_unique<LabelSizes>(
      this->Grid, this->Labels, this->Fractions.NumberOfMaterials() + 1, this->Parts);
    int perturbations = 0;
    while (ranks.Any(!this->Violated.empty()))
    {
      this->InOrder = perturbations > Perturbations || report.Rounds >= GreedyRounds;
      this->KeepsLast = true;
      this->FindCandidates(this->InOrder);
      if (!ranks.Any(!this->Candidates.empty()))
      {
        this->InOrder = this->InOrder || ++perturbations > Perturbations;
        this->Turn = this->InOrder ? 0 : perturbations;
        this->KeepsLast = !this->InOrder;
        this->FindCandidates(true);
      }
      this->Flip();
      this->KeepViolated();
      ++report.Rounds;
    }
    report.Rounds += this->Restore();
    std::vector<Index> flipped{ this->CountChanges() };
    ranks.Sum(flipped);
    report.FlippedCells = flipped[0];
    report.CostlyFlips = this->FindCostlyFlips();
    return report;
  }

private:
  /// Whether a node touches a unit whose change competes with those of the owned ones. Owned boxes consist of whole
  /// base cells, so these units lie in Reach.
  bool IsNear(Index node) const { return this->Reach.Touches(this->Grid.Position(node)); }

  int Violations(Index node) const { return CountViolations(StarOfNode(Grid, Labels, node)); }

  void KeepViolated()
  {
    std::vector<Index>& nodes = this->Violated;
    SortUnique(nodes);
    ForEach(this->Run, nodes.size(),
      [&](Index n)
      {
        const bool isKept = this->IsNear(nodes[n]) && this->Violations(nodes[n]) > 0;
        nodes[n] = isKept ? nodes[n] : -1;
      });
    nodes.erase(std::remove(nodes.begin(), nodes.end(), -1), nodes.end());
  }

  /// Violations removed at the nodes of a unit when it takes each of some labels.
  std::vector<int> FindGains(const IndexBox& cells, const std::vector<int>& labels) const
  {
    std::vector<int> gains(labels.size(), 0);
    ForSurfaceNodes(cells,
      [&](const Index3& node)
      {
        std::array<int, 8> star = StarOfNode(this->Grid, this->Labels, this->Grid.Linear(node));
        const int before = CountViolations(star);
        const int region = this->Units.RegionAt(node, cells);
        for (std::size_t n = 0; n < labels.size(); ++n)
        {
          for (int s = 0; s < 8; ++s)
          {
            star[s] = region >> s & 1 ? labels[n] : star[s];
          }
          gains[n] += before - CountViolations(star);
        }
      });
    return gains;
  }

  /// Place of a label in the present order: it begins at label Turn and wraps around. In the last one, small labels come first.
  Index Order(int label) const
  {
    const Index count = this->Fractions.NumberOfMaterials() + 1;
    const Index size = this->InOrder ? this->Sizes->CappedSize(label) : 0;
    return size * count + (label + count - this->Turn % count) % count;
  }

  bool MayTake(int current, int label, bool decreasing) const
  {
    return label != current && !(decreasing && this->Order(label) > this->Order(current));
  }

  /// The best of some labels that a unit may take, ascending; label -1: none.
  Candidate Consider(Index unit, const std::vector<int>& labels, bool decreasing) const
  {
    const IndexBox cells = this->Units.CellsOf(unit);
    const std::vector<int> gains = this->FindGains(cells, labels);
    Candidate best{ 0.0, -1, this->Grid.CellKey(cells.Lower) };
    for (std::size_t n = 0; n < labels.size(); ++n)
    {
      const int gain = gains[n];
      if (gain <= 0 && !decreasing)
      {
        continue;
      }
      const double price = this->Price(cells, this->Labels[unit], labels[n]);
      const double score = gain > 0 ? gain / price : (gain - 1) * price;
      if (best.Label < 0 || score > best.Score)
      {
        best.Score = score;
        best.Label = labels[n];
      }
    }
    return best;
  }

  /// The fraction that a unit gives up times its width: how far the interface moves, in cells of the grid.
  double Cost(const IndexBox& cells, int current, int label) const
  {
    const FractionSum mean = MeanOfCells(this->Grid, this->Fractions, cells);
    return static_cast<double>(cells.Size(0)) *
      std::max(0.0, mean.Fraction(current) - mean.Fraction(label));
  }

  double Price(const IndexBox& cells, int current, int label) const
  {
    return this->Sizes->Factor(cells.NumberOfCells(), current, label) *
      (CostOffset + this->Cost(cells, current, label));
  }

  void FindCandidates(bool decreasing)
  {
    this->Candidates.clear();
    std::vector<std::pair<Index, int>> changes;
    for (Index node : this->Violated)
    {
      const StarLabels labels(StarOfNode(this->Grid, this->Labels, node));
      const Index3 position = this->Grid.Position(node);
      for (int s = 0; s < 8; ++s)
      {
        const Index unit = this->Units.UnitOf(CellOfStar(position, s));
        for (int label : labels)
        {
          changes.emplace_back(unit, label);
        }
      }
    }
    SortUnique(changes);
    std::vector<std::size_t> begins; // of the changes of each unit, and the end
    for (std::size_t n = 0; n < changes.size(); ++n)
    {
      if (n == 0 || changes[n].first != changes[n - 1].first)
      {
        begins.push_back(n);
      }
    }
    begins.push_back(changes.size());
    std::vector<Candidate> found(begins.size() - 1);
    ForEach(this->Run, found.size(),
      [&](Index n)
      {
        const Index unit = changes[begins[n]].first;
        const bool isKept = this->KeepsLast &&
          this->Sizes->IsLast(this->Units.CellsOf(unit).NumberOfCells(), this->Labels[unit]);
        std::vector<int> allowed;
        for (std::size_t c = begins[n]; !isKept && c < begins[n + 1]; ++c)
        {
          if (this->MayTake(this->Labels[unit], changes[c].second, decreasing))
          {
            allowed.push_back(changes[c].second);
          }
        }
        found[n] =
          allowed.empty() ? Candidate{ 0.0, -1, 0 } : this->Consider(unit, allowed, decreasing);
      });
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      if (found[n].Label >= 0)
      {
        this->Candidates.emplace(changes[begins[n]].first, found[n]);
      }
    }
  }

  /// Whether a candidate beats those of all units around that share a node with it.
  bool IsBestAround(const IndexBox& cells, const Candidate& mine) const
  {
    bool isBest = true;
    ForCells({ CellOfStar(cells.Lower, 0), CornerOfCell(cells.Upper, 7) },
      [&](const Index3& cell)
      {
        if (isBest && !cells.Contains(cell))
        {
          const auto other = this->Candidates.find(this->Units.UnitOf(cell));
          isBest = other == this->Candidates.end() || !other->second.Beats(mine);
        }
      });
    return isBest;
  }

  /// Flips the best candidates. Each rank remembers the first labels of the units that may flip around its own, too.
  void Flip()
  {
    std::vector<std::pair<IndexBox, int>> flips;
    std::vector<std::pair<Index, int>> others; // candidates of other ranks, and their labels
    for (const auto& candidate : this->Candidates)
    {
      const IndexBox cells = this->Units.CellsOf(candidate.first);
      const int label = this->Labels[candidate.first];
      if (!this->Parts.OwnsCell(cells.Lower))
      {
        others.emplace_back(candidate.first, label);
      }
      else if (this->IsBestAround(cells, candidate.second))
      {
        this->Original.emplace(candidate.first, label);
        this->Sizes->Add(cells.NumberOfCells(), label, candidate.second.Label);
        flips.emplace_back(cells, candidate.second.Label);
      }
    }
    this->Sizes->Share();
    for (const auto& flip : flips)
    {
      FillLabels(this->Grid, flip.first, flip.second, this->Labels);
      ForSurfaceNodes(
        flip.first, [&](const Index3& node) { this->Violated.push_back(this->Grid.Linear(node)); });
    }
    this->Parts.ExchangeCells(this->Labels,
      [this](Index cell)
      {
        const int label = this->Labels[cell];
        this->Grid.ForMirrors(cell, [&](Index mirror) { this->Labels.Set(mirror, label); });
        for (int c = 0; c < 8; ++c)
        {
          this->Violated.push_back(this->Grid.NodeOfCell(cell, c));
        }
      });
    for (const auto& other : others)
    {
      if (this->Labels[other.first] != other.second)
      {
        this->Original.insert(other);
      }
    }
  }

  /// Lets units take their first labels again where no star minds, until none can: what perturbations changed in vain. Returns the
  /// rounds. Ends, since each gives fewer units another label. Of units beyond Reach not all flips are known.
  int Restore()
  {
    for (int rounds = 0;; ++rounds)
    {
      this->FindRestorable();
      if (!this->Parts.Group().Any(!this->Candidates.empty()))
      {
        return rounds;
      }
      this->Flip();
      this->Violated.clear();
    }
  }

  /// Makes the first labels of units candidates where no star minds.
  void FindRestorable()
  {
    this->Candidates.clear();
    const std::vector<std::pair<Index, int>> units(this->Original.begin(), this->Original.end());
    std::vector<Candidate> found(units.size());
    ForEach(this->Run, units.size(),
      [&](Index n)
      {
        const auto& [unit, first] = units[n];
        const IndexBox cells = this->Units.CellsOf(unit);
        const int label = this->Labels[unit];
        const bool may = this->Reach.Contains(cells.Lower) && label != first &&
          this->FindGains(cells, { first })[0] == 0;
        found[n] = may
          ? Candidate{ this->Price(cells, first, label), first, this->Grid.CellKey(cells.Lower) }
          : Candidate{ 0.0, -1, 0 };
      });
    for (std::size_t n = 0; n < units.size(); ++n)
    {
      if (found[n].Label >= 0)
      {
        this->Candidates.emplace(units[n].first, found[n]);
      }
    }
  }

  /// Units of several cells whose flip moves the interface by more than CostlyFlip.
  std::vector<Index3> FindCostlyFlips() const
  {
    std::vector<Index3> flips;
    for (const auto& unit : this->Original)
    {
      const IndexBox cells = this->Units.CellsOf(unit.first);
      if (cells.Size(0) > 1 && this->Parts.OwnsCell(cells.Lower) &&
        this->Cost(cells, unit.second, this->Labels[unit.first]) > CostlyFlip)
      {
        flips.push_back(cells.Lower);
      }
    }
    return flips;
  }

  Index CountChanges() const
  {
    return std::count_if(this->Original.begin(), this->Original.end(),
      [this](const auto& unit)
      {
        return this->Parts.OwnsCell(this->Grid.Position(unit.first)) &&
          this->Labels[unit.first] != unit.second;
      });
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  LabelArray& Labels;
  const Partition& Parts;
  Runtime& Run;
  const LabelUnits Units;
  const IndexBox Reach;
  std::vector<Index> Violated;
  std::unordered_map<Index, int>
    Original; // labels of the flipped units, owned ones and those around
  std::unique_ptr<LabelSizes> Sizes;
  int Turn = 0;
  bool InOrder = false;  // whether units take smaller labels in the last order alone
  bool KeepsLast = true; // whether no label may lose its last unit
  std::unordered_map<Index, Candidate> Candidates;
};

} // namespace

ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition, Runtime& runtime, const RefinedGrid* leaves)
{
  return Resolver(grid, fractions, labels, partition, runtime, leaves).Resolve();
}

} // namespace vfm
