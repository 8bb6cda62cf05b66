#include "Labels/LabelFlips.h"

#include "Base/Sorted.h"
#include "Fractions/FractionSum.h"
#include "Labels/LabelCondition.h"

namespace vfm
{
namespace
{

constexpr double CostOffset = 0.05; // price of a flip that loses no fraction

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

/// Returns whether a node touches a unit whose change competes with changes of owned units. Owned
/// boxes consist of complete base cells, so these units are in Reach.
bool IsNear(const LabelFlips& work, Index node)
{
  return work.Reach.Touches(work.Grid.Position(node));
}

/// Returns the violations of a star: of the label condition, and on a flat seam of the condition
/// there.
int Violations(const std::array<int, 8>& star, int flatSeams)
{
  return CountViolations(star) + (flatSeams != 0 ? CountSeamViolations(star, flatSeams) : 0);
}

int Violations(const LabelFlips& work, Index node)
{
  return Violations(StarOfNode(work.Grid, work.Labels, node),
    work.KeepsSeam ? work.Grid.FlatSeams(work.Grid.Position(node)) : 0);
}

} // namespace

void KeepViolated(LabelFlips& work)
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

std::vector<int> FindGains(
  const LabelFlips& work, const IndexBox& cells, const std::vector<int>& labels)
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

double Cost(const LabelFlips& work, const IndexBox& cells, int current, int label)
{
  const FractionSum mean = MeanOfCells(work.Grid, work.Fractions, cells);
  return static_cast<double>(work.Leaves ? cells.Size(0) : cells.NumberOfCells()) *
    std::max(0.0, mean.Fraction(current) - mean.Fraction(label));
}

double Price(const LabelFlips& work, const IndexBox& cells, int current, int label)
{
  return work.Sizes->Factor(cells.NumberOfCells(), current, label) *
    (CostOffset + Cost(work, cells, current, label));
}

void ApplyChanges(
  LabelFlips& work, const std::vector<LabelChange>& changes, const std::vector<IndexBox>& others)
{
  std::vector<std::pair<Index, int>> before; // labels of `others`
  for (const IndexBox& cells : others)
  {
    ForParts(work, cells, [&](Index n, Index) { before.emplace_back(n, work.Labels[n]); });
  }
  for (const LabelChange& change : changes)
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

} // namespace vfm
