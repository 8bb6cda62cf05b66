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
bool IsNear(const LabelFlips& flips, Index node)
{
  return flips.Reach.Touches(flips.Grid.Position(node));
}

/// Returns the violations of a star: of the label condition, and on a flat seam of the condition
/// there.
int Violations(const std::array<int, 8>& star, int flatSeams)
{
  return CountViolations(star) + (flatSeams != 0 ? CountSeamViolations(star, flatSeams) : 0);
}

/// Number of axes that each region violates.
constexpr std::array<unsigned char, 256> MakeViolatedAxes()
{
  std::array<unsigned char, 256> axes{};
  for (int region = 0; region < 256; ++region)
  {
    axes[region] = static_cast<unsigned char>(RegionNormalsTable[region].ViolatedAxes());
  }
  return axes;
}
constexpr std::array<unsigned char, 256> ViolatedAxes = MakeViolatedAxes();

/// A star in which the cells of a region change to one label.
class ChangedStar
{
public:
  ChangedStar(const std::array<int, 8>& star, int region) : Star(star), Region(region)
  {
    int seen = 0;
    for (int c = 0; c < 8; ++c)
    {
      if (!(seen >> c & 1))
      {
        const int own = RegionOfLabel(star, star[c]);
        seen |= own;
        this->Before += ViolatedAxes[own];
        this->OfRest += ViolatedAxes[own & ~region];
      }
    }
  }

  /// Returns by how much CountViolations is smaller with a new label.
  int GainOf(int label) const
  {
    const int rest = RegionOfLabel(this->Star, label) & ~this->Region;
    return this->Before - this->OfRest + ViolatedAxes[rest] - ViolatedAxes[rest | this->Region];
  }

private:
  const std::array<int, 8>& Star;
  int Region;
  int Before = 0; // CountViolations
  int OfRest = 0; // violations of all labels in the other cells
};

int Violations(const LabelFlips& flips, Index node)
{
  return Violations(StarOfNode(flips.Grid, flips.Labels, node),
    flips.KeepsSeam ? flips.Grid.FlatSeams(flips.Grid.Position(node)) : 0);
}

} // namespace

void KeepViolated(LabelFlips& flips, Runtime& runtime)
{
  std::vector<Index>& nodes = flips.Violated;
  SortUnique(nodes);
  ForEach(runtime, nodes.size(),
    [&](Index n)
    {
      const bool isKept = IsNear(flips, nodes[n]) && Violations(flips, nodes[n]) > 0;
      nodes[n] = isKept ? nodes[n] : -1;
    });
  nodes.erase(std::remove(nodes.begin(), nodes.end(), -1), nodes.end());
}

std::vector<int> FindGains(
  const LabelFlips& flips, const IndexBox& cells, const std::vector<int>& labels)
{
  std::vector<int> gains(labels.size(), 0);
  ForSurfaceNodes(cells,
    [&](const Index3& node)
    {
      std::array<int, 8> star = StarOfNode(flips.Grid, flips.Labels, flips.Grid.Linear(node));
      const int seams = flips.KeepsSeam ? flips.Grid.FlatSeams(node) : 0;
      const int region = flips.Units.RegionAt(node, cells);
      if (seams == 0)
      {
        const ChangedStar changed(star, region);
        for (std::size_t n = 0; n < labels.size(); ++n)
        {
          gains[n] += changed.GainOf(labels[n]);
        }
        return;
      }
      const int before = Violations(star, seams);
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

double Cost(const LabelFlips& flips, const IndexBox& cells, int current, int label)
{
  const FractionSum mean = MeanOfCells(flips.Grid, flips.Fractions, cells);
  return static_cast<double>(flips.Leaves ? cells.Size(0) : cells.NumberOfCells()) *
    std::max(0.0, mean.Fraction(current) - mean.Fraction(label));
}

double Price(const LabelFlips& flips, const IndexBox& cells, int current, int label)
{
  return flips.Sizes->Factor(cells.NumberOfCells(), current, label) *
    (CostOffset + Cost(flips, cells, current, label));
}

void ApplyChanges(
  LabelFlips& flips, const std::vector<LabelChange>& changes, const std::vector<IndexBox>& others)
{
  std::vector<std::pair<Index, int>> before; // labels of `others`
  for (const IndexBox& cells : others)
  {
    ForParts(flips, cells, [&](Index n, Index) { before.emplace_back(n, flips.Labels[n]); });
  }
  for (const LabelChange& change : changes)
  {
    ForParts(flips, change.Cells,
      [&](Index n, Index size)
      {
        const int label = flips.Labels[n];
        if (label != change.Label)
        {
          flips.Original.emplace(n, label);
          flips.Sizes->Add(
            flips.Parts.OwnsCell(flips.Grid.Position(n)) ? size : 0, label, change.Label);
        }
      });
    FillLabels(flips.Grid, change.Cells, change.Label, flips.Labels);
    ForSurfaceNodes(
      change.Cells, [&](const Index3& node) { flips.Violated.push_back(flips.Grid.Linear(node)); });
  }
  flips.Sizes->Share();
  flips.Parts.ExchangeCells(flips.Labels,
    [&](Index cell)
    {
      const int label = flips.Labels[cell];
      flips.Grid.ForMirrors(cell, [&](Index mirror) { flips.Labels.Set(mirror, label); });
      for (int c = 0; c < 8; ++c)
      {
        flips.Violated.push_back(flips.Grid.NodeOfCell(cell, c));
      }
    });
  for (const auto& other : before)
  {
    if (flips.Labels[other.first] != other.second)
    {
      flips.Original.insert(other);
    }
  }
}

} // namespace vfm
