#include "LabelCondition.h"
#include "Labels.h"

#include <algorithm>
#include <unordered_map>

namespace vfm
{
namespace
{

constexpr int Kicks = 40;           // ways out of dead ends before one order of labels must end it
constexpr int GreedyRounds = 400;   // likewise
constexpr double CostOffset = 0.05; // a flip that gives up no fraction still has a price

/// The change of one cell that scores best.
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

class Resolver
{
public:
  Resolver(const CartesianGrid& grid, const FractionField& fractions, LabelArray& labels,
    const Partition& partition) :
    Grid(grid), Fractions(fractions), Labels(labels), Parts(partition), Reach(grid.Extended(1))
  {
  }

  /// Greedy rounds remove violations. In a dead end one round of kicks lets cells take a smaller label in an order
  /// of the labels that turns from kick to kick. At last the order stays, so the sum of labels falls until
  /// no star is violated: a violated star always has a cell that can take a smaller label of the star.
  ResolveReport Run()
  {
    this->Violated = FindMixedNodes(this->Grid, this->Labels);
    this->KeepViolated();
    Ranks& ranks = this->Parts.Group();
    ResolveReport report;
    int kicks = 0;
    while (ranks.Any(!this->Violated.empty()))
    {
      const bool greedy = kicks <= Kicks && report.Rounds < GreedyRounds;
      this->FindCandidates(!greedy);
      if (!ranks.Any(!this->Candidates.empty()))
      {
        this->Turn = ++kicks <= Kicks ? kicks : 0;
        this->FindCandidates(true);
      }
      this->Flip();
      this->KeepViolated();
      ++report.Rounds;
    }
    std::vector<Index> flipped{ this->CountChanges() };
    ranks.Sum(flipped);
    report.FlippedCells = flipped[0];
    return report;
  }

private:
  /// The cell in the domain that a star's cell is or mirrors.
  Index Source(const Index3& cell) const
  {
    Index3 inside = cell;
    for (int a = 0; a < 3; ++a)
    {
      inside[a] =
        std::min(std::max(cell[a], this->Grid.Local().Lower[a]), this->Grid.Local().Upper[a] - 1);
    }
    return this->Grid.Linear(inside);
  }

  /// The cells in the domain around a node; a cell beside the boundary stands for its mirrors.
  std::array<Index, 8> Cells(const Index3& node) const
  {
    std::array<Index, 8> cells;
    for (int c = 0; c < 8; ++c)
    {
      cells[c] = this->Source(
        { { node[0] - 1 + (c & 1), node[1] - 1 + (c >> 1 & 1), node[2] - 1 + (c >> 2 & 1) } });
    }
    return cells;
  }

  /// Whether a node touches a cell whose change competes with those of the owned cells.
  bool IsNear(Index node) const { return this->Reach.Touches(this->Grid.Position(node)); }

  int Violations(Index node) const { return CountViolations(StarOfNode(Grid, Labels, node)); }

  void KeepViolated()
  {
    std::vector<Index>& nodes = this->Violated;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    nodes.erase(
      std::remove_if(nodes.begin(), nodes.end(),
        [this](Index node) { return !this->IsNear(node) || this->Violations(node) == 0; }),
      nodes.end());
  }

  /// Violations removed at the eight nodes of a cell when it takes the label.
  int Gain(Index cell, const Index3& position, int label) const
  {
    int gain = 0;
    for (int c = 0; c < 8; ++c)
    {
      const Index node = this->Grid.NodeOfCell(cell, c);
      std::array<int, 8> star = StarOfNode(this->Grid, this->Labels, node);
      gain += CountViolations(star);
      const std::array<Index, 8> cells = this->Cells(
        { { position[0] + (c & 1), position[1] + (c >> 1 & 1), position[2] + (c >> 2 & 1) } });
      for (int s = 0; s < 8; ++s)
      {
        star[s] = cells[s] == cell ? label : star[s];
      }
      gain -= CountViolations(star);
    }
    return gain;
  }

  /// Place of a label in the present order: it begins at label Turn and wraps around.
  int Order(int label) const
  {
    const int count = this->Fractions.NumberOfMaterials() + 1;
    return (label + count - this->Turn % count) % count;
  }

  void Consider(Index cell, int label, bool decreasing)
  {
    const int current = this->Labels[cell];
    if (label == current || (decreasing && this->Order(label) > this->Order(current)))
    {
      return;
    }
    const Index3 position = this->Grid.Position(cell);
    const int gain = this->Gain(cell, position, label);
    if (gain <= 0 && !decreasing)
    {
      return;
    }
    const double cost = std::max(
      0.0, this->Fractions.Fraction(cell, current) - this->Fractions.Fraction(cell, label));
    const double price = CostOffset + cost;
    const double score = gain > 0 ? gain / price : (gain - 1) * price;
    const Candidate found{ score, label, this->Grid.CellKey(position) };
    const auto at = this->Candidates.emplace(cell, found);
    Candidate& best = at.first->second;
    if (found.Score > best.Score || (found.Score == best.Score && label < best.Label))
    {
      best = found;
    }
  }

  void FindCandidates(bool decreasing)
  {
    this->Candidates.clear();
    std::vector<std::pair<Index, int>> changes;
    for (Index node : this->Violated)
    {
      const StarLabels labels(StarOfNode(this->Grid, this->Labels, node));
      for (Index cell : this->Cells(this->Grid.Position(node)))
      {
        for (int label : labels)
        {
          changes.emplace_back(cell, label);
        }
      }
    }
    std::sort(changes.begin(), changes.end());
    changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
    for (const auto& change : changes)
    {
      this->Consider(change.first, change.second, decreasing);
    }
  }

  bool IsBestAround(Index cell, const Candidate& mine) const
  {
    for (int dz = -1; dz <= 1; ++dz)
    {
      for (int dy = -1; dy <= 1; ++dy)
      {
        for (int dx = -1; dx <= 1; ++dx)
        {
          const auto other = this->Candidates.find(
            cell + dx + dy * this->Grid.Stride(1) + dz * this->Grid.Stride(2));
          if (other != this->Candidates.end() && other->second.Beats(mine))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  void Flip()
  {
    std::vector<std::pair<Index, int>> flips;
    for (const auto& candidate : this->Candidates)
    {
      if (this->Parts.OwnsCell(this->Grid.Position(candidate.first)) &&
        this->IsBestAround(candidate.first, candidate.second))
      {
        flips.emplace_back(candidate.first, candidate.second.Label);
      }
    }
    const auto update = [this](Index cell)
    {
      const int label = this->Labels[cell];
      this->Grid.ForMirrors(cell, [&](Index mirror) { this->Labels.Set(mirror, label); });
      for (int c = 0; c < 8; ++c)
      {
        this->Violated.push_back(this->Grid.NodeOfCell(cell, c));
      }
    };
    for (const auto& flip : flips)
    {
      this->Original.emplace(flip.first, this->Labels[flip.first]);
      this->Labels.Set(flip.first, flip.second);
      update(flip.first);
    }
    this->Parts.ExchangeCells(this->Labels, update);
  }

  Index CountChanges() const
  {
    return std::count_if(this->Original.begin(), this->Original.end(),
      [this](const auto& cell) { return this->Labels[cell.first] != cell.second; });
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  LabelArray& Labels;
  const Partition& Parts;
  IndexBox Reach;
  std::vector<Index> Violated;
  std::unordered_map<Index, int> Original; // labels of the owned cells that were flipped
  int Turn = 0;
  std::unordered_map<Index, Candidate> Candidates;
};

} // namespace

ResolveReport ResolveLabels(const CartesianGrid& grid, const FractionField& fractions,
  LabelArray& labels, const Partition& partition)
{
  return Resolver(grid, fractions, labels, partition).Run();
}

} // namespace vfm
