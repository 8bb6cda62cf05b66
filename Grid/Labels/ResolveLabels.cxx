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

class Resolver
{
public:
  Resolver(const CartesianGrid& grid, const FractionField& fractions, LabelArray& labels,
    const Partition& partition, const RefinedGrid* leaves) :
    Grid(grid),
    Fractions(fractions),
    Labels(labels),
    Parts(partition),
    Units(grid, leaves),
    Reach(grid.Extended(this->Units.LargestWidth()))
  {
  }

  /// Greedy rounds remove violations. In a dead end one round of perturbations lets units take a smaller label in an order
  /// of the labels that turns from perturbation to perturbation. At last the order stays, so the sum of the units' labels falls until
  /// no star is violated: a violated star has several labels, hence a unit that can take a smaller label of the star; the best
  /// of all candidates flips, and units that flip at once have no star in common.
  ResolveReport Run()
  {
    this->Violated = FindMixedNodes(this->Grid, this->Labels);
    this->KeepViolated();
    Ranks& ranks = this->Parts.Group();
    ResolveReport report;
    int perturbations = 0;
    while (ranks.Any(!this->Violated.empty()))
    {
      const bool greedy = perturbations <= Perturbations && report.Rounds < GreedyRounds;
      this->FindCandidates(!greedy);
      if (!ranks.Any(!this->Candidates.empty()))
      {
        this->Turn = ++perturbations <= Perturbations ? perturbations : 0;
        this->FindCandidates(true);
      }
      this->Flip();
      this->KeepViolated();
      ++report.Rounds;
    }
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
    nodes.erase(
      std::remove_if(nodes.begin(), nodes.end(),
        [this](Index node) { return !this->IsNear(node) || this->Violations(node) == 0; }),
      nodes.end());
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

  /// Place of a label in the present order: it begins at label Turn and wraps around.
  int Order(int label) const
  {
    const int count = this->Fractions.NumberOfMaterials() + 1;
    return (label + count - this->Turn % count) % count;
  }

  bool MayTake(int current, int label, bool decreasing) const
  {
    return label != current && !(decreasing && this->Order(label) > this->Order(current));
  }

  /// Makes the best of some labels that a unit may take, ascending, its candidate.
  void Consider(Index unit, const std::vector<int>& labels, bool decreasing)
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
      const double price = CostOffset + this->Cost(cells, this->Labels[unit], labels[n]);
      const double score = gain > 0 ? gain / price : (gain - 1) * price;
      if (best.Label < 0 || score > best.Score)
      {
        best.Score = score;
        best.Label = labels[n];
      }
    }
    if (best.Label >= 0)
    {
      this->Candidates.emplace(unit, best);
    }
  }

  /// The fraction that a unit gives up times its width: how far the interface moves, in cells of the grid.
  double Cost(const IndexBox& cells, int current, int label) const
  {
    const FractionSum mean = MeanOfCells(this->Grid, this->Fractions, cells);
    return static_cast<double>(cells.Size(0)) *
      std::max(0.0, mean.Fraction(current) - mean.Fraction(label));
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
    std::vector<int> allowed;
    for (std::size_t n = 0; n < changes.size();)
    {
      const Index unit = changes[n].first;
      allowed.clear();
      for (; n < changes.size() && changes[n].first == unit; ++n)
      {
        if (this->MayTake(this->Labels[unit], changes[n].second, decreasing))
        {
          allowed.push_back(changes[n].second);
        }
      }
      if (!allowed.empty())
      {
        this->Consider(unit, allowed, decreasing);
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

  void Flip()
  {
    std::vector<std::pair<IndexBox, int>> flips;
    for (const auto& candidate : this->Candidates)
    {
      const IndexBox cells = this->Units.CellsOf(candidate.first);
      if (this->Parts.OwnsCell(cells.Lower) && this->IsBestAround(cells, candidate.second))
      {
        this->Original.emplace(candidate.first, this->Labels[candidate.first]);
        flips.emplace_back(cells, candidate.second.Label);
      }
    }
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
  }

  /// Units of several cells whose flip moves the interface by more than CostlyFlip.
  std::vector<Index3> FindCostlyFlips() const
  {
    std::vector<Index3> flips;
    for (const auto& unit : this->Original)
    {
      const IndexBox cells = this->Units.CellsOf(unit.first);
      if (cells.Size(0) > 1 &&
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
      [this](const auto& unit) { return this->Labels[unit.first] != unit.second; });
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  LabelArray& Labels;
  const Partition& Parts;
  const LabelUnits Units;
  const IndexBox Reach;
  std::vector<Index> Violated;
  std::unordered_map<Index, int> Original; // labels of the owned units that were flipped
  int Turn = 0;
  std::unordered_map<Index, Candidate> Candidates;
};

} // namespace

ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition, const RefinedGrid* leaves)
{
  return Resolver(grid, fractions, labels, partition, leaves).Run();
}

} // namespace vfm
