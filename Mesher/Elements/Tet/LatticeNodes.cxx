#include "Elements/Tet/LatticeNodes.h"

#include <cmath>

namespace vfm
{
namespace
{

// Fractions of an edge within which an interface is near, for edges from a vertex to a centre and
// edges along an axis. They are not round numbers: if a plane of the input were exactly there,
// rounding would decide differently from node to node.
constexpr double DiagonalReach = 0.45 - 1e-6;
constexpr double AxisReach = 0.30 - 1e-6;

using Star = std::array<int, 8>; // labels of the cells around a vertex

/// Returns whether a cell of `other` shares a face with a cell of `label`.
bool Touches(const Star& star, int label, int other)
{
  bool touches = false;
  for (int c = 0; c < 8; ++c)
  {
    touches = touches ||
      (star[c] == other && (star[c ^ 1] == label || star[c ^ 2] == label || star[c ^ 4] == label));
  }
  return touches;
}

bool TouchesAll(const Star& star, int label)
{
  return std::all_of(star.begin(), star.end(),
    [&](int other) { return other == label || Touches(star, label, other); });
}

} // namespace

LatticeNodes::LatticeNodes(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& cells, double isoValue, const Partition& partition, Runtime& runtime) :
  Grid(grid),
  Fractions(fractions),
  CellLabels(cells),
  IsoValue(isoValue),
  Run(runtime),
  Mixed(FindMixedNodes(grid, cells))
{
  // Extends arrays by the offset across a cell, so that nodes on the upper side have all neighbours
  // in memory.
  const Index size = grid.NumberOfEntries() + grid.CornerOffset(7);
  for (auto& labels : this->Label)
  {
    labels.assign(size, Snapped);
  }
  ForRows(runtime, grid.Local(), [this](Index j, Index k, Index) { this->LabelCentres(j, k); });
  const auto around = [&](Index layers) { return Grow(grid.HexBox(), layers, grid.Local()); };
  this->LabelVertices(around(3));
  if (this->HasOddPeriods())
  {
    for (Kind kind : { Centre, Vertex })
    {
      for (int current = 0; current < 16; ++current)
      {
        this->Snap(kind, current, around(1));
        partition.ExchangeCells(this->Label[kind].data());
      }
    }
    return;
  }
  // Each pass reads one layer more than it writes.
  this->Snap(Centre, 0, around(3));
  this->Snap(Centre, 1, around(2));
  this->Snap(Vertex, 0, around(1));
  this->Snap(Vertex, 1, around(0));
}

bool LatticeNodes::Settle(const std::vector<Index>& ids, const Partition& partition)
{
  bool changed = false;
  for (Index id : ids)
  {
    changed = this->SettleHere(id, {}) || changed;
  }
  const std::vector<std::vector<Index>> lists =
    partition.Exchange(std::vector<std::vector<Index>>(partition.Peers().size(), ids));
  for (std::size_t peer = 0; peer < lists.size(); ++peer)
  {
    for (Index id : lists[peer])
    {
      changed = this->SettleHere(id, partition.ShiftOf(peer)) || changed;
    }
  }
  return partition.Group().Any(changed);
}

/// Settles the copy of a node that is some cells higher, if this rank has it. Returns whether this
/// changes the node.
bool LatticeNodes::SettleHere(Index id, const Index3& shift)
{
  Node node{ Kind(SlotOfPoint(id)), this->Grid.NodeOfKey((id - 1) / TetIds.PointSlots) };
  for (int a = 0; a < 3; ++a)
  {
    node.Position[a] += shift[a];
  }
  const IndexBox hexes = this->Grid.HexBox();
  if (node.Type == Centre ? !hexes.Contains(node.Position) : !hexes.Touches(node.Position))
  {
    return false;
  }
  int& label = this->Label[node.Type][this->Grid.Linear(node.Position)];
  const int before = label;
  label = this->SettledLabel(node);
  return label != before;
}

int LatticeNodes::SettledLabel(const Node& node) const
{
  const Index n = this->Grid.Linear(node.Position);
  const int label = this->CellLabels[n];
  if (node.Type == Centre)
  {
    return label;
  }
  return IsMixedStar(StarOfNode(this->Grid, this->CellLabels, n)) ? Snapped : label;
}

void LatticeNodes::LabelCentres(Index j, Index k)
{
  const IndexBox& box = this->Grid.Local();
  const Index first = this->Grid.Linear({ { box.Lower[0], j, k } });
  int* labels = this->Label[Centre].data();
  this->CellLabels.Visit(
    first, first + box.Size(0),
    [&](Index begin, Index end, int label) { std::fill(labels + begin, labels + end, label); },
    [&](Index begin, Index end, const int* own)
    { std::copy(own, own + (end - begin), labels + begin); });
}

/// Labels the vertices of a box of cells.
void LatticeNodes::LabelVertices(const IndexBox& box)
{
  const IndexBox vertices = NodesOf(box);
  int* labels = this->Label[Vertex].data();
  ForRows(this->Run, vertices,
    [&](Index j, Index k, Index)
    {
      const Index first = this->Grid.Linear({ { vertices.Lower[0], j, k } });
      const LabelArray::RowView row = this->CellLabels.Row(first);
      const Index at = this->CellLabels.InRow(first);
      for (Index i = 0; i < vertices.Size(0); ++i)
      {
        labels[first + i] = row[at + i];
      }
    });
  ForEach(this->Run, this->Mixed.size(),
    [&](Index m)
    {
      const Index3 p = this->Grid.Position(this->Mixed[m]);
      if (vertices.Contains(p))
      {
        const bool isInside = this->Grid.DomainSides(p) == 0 && this->Grid.FlatSeams(p) == 0;
        labels[this->Mixed[m]] = isInside ? this->LabelOfMixed(p) : Snapped;
      }
    });
}

int LatticeNodes::LabelOfMixed(const Index3& vertex) const
{
  const Star star = StarOfNode(this->Grid, this->CellLabels, this->Grid.Linear(vertex));
  FractionSum sum;
  for (Index cell : this->StarOf(vertex))
  {
    sum.Add(this->Fractions, cell, 0.125);
  }
  int label = sum.Material(this->IsoValue);
  if (std::find(star.begin(), star.end(), label) == star.end())
  {
    label = star[0];
    for (int other : star)
    {
      const double lead = sum.Fraction(other) - sum.Fraction(label);
      label = lead > 0.0 || (lead == 0.0 && other < label) ? other : label;
    }
  }
  return TouchesAll(star, label) ? label : Snapped;
}

/// Returns the cells around a vertex; a cell outside the domain is replaced by the nearest
/// cell inside.
std::array<Index, 8> LatticeNodes::StarOf(const Index3& vertex) const
{
  const IndexBox& box = this->Grid.Local();
  Index low[3], high[3];
  for (int a = 0; a < 3; ++a)
  {
    const Index cell = vertex[a] - box.Lower[a] + 1; // relative to the origin of the arrays
    low[a] = std::max<Index>(cell - 1, 1) * this->Grid.Stride(a);
    high[a] = std::min<Index>(cell, box.Size(a)) * this->Grid.Stride(a);
  }
  std::array<Index, 8> star;
  for (int c = 0; c < 8; ++c)
  {
    star[c] = (c & 1 ? high[0] : low[0]) + (c & 2 ? high[1] : low[1]) + (c & 4 ? high[2] : low[2]);
  }
  return star;
}

double LatticeNodes::Fraction(const Node& node, int material) const
{
  if (node.Type == Centre)
  {
    return this->Fractions.Fraction(this->Grid.Linear(node.Position), material);
  }
  double sum = 0.0;
  for (Index cell : this->StarOf(node.Position))
  {
    sum += this->Fractions.Fraction(cell, material);
  }
  return 0.125 * sum;
}

/// Returns the lead of a node's label over another label in their fractions. It measures the
/// distance to the interface between them.
double LatticeNodes::Lead(const Node& node, int label, int other) const
{
  if (label == 0 || other == 0)
  {
    return std::abs(this->Fraction(node, 0) - (1.0 - this->IsoValue));
  }
  return std::max(this->Fraction(node, label) - this->Fraction(node, other), 0.0);
}

/// Returns whether a node may be snapped. A centre may not if its cell is at the domain boundary or
/// a flat seam, or thin: along two axes, neither neighbour has the label of the cell.
bool LatticeNodes::MaySnap(const Node& node, Index n) const
{
  bool isInside = true;
  int thinAxes = 0;
  for (int a = 0; node.Type == Centre && isInside && a < 3; ++a)
  {
    const Index stride = this->Grid.Stride(a);
    const int label = this->CellLabels[n];
    Index3 next = node.Position;
    ++next[a];
    isInside = node.Position[a] > 0 && next[a] < this->Grid.Global().Upper[a] &&
      !this->Grid.IsOnFlatSeam(node.Position, a) && !this->Grid.IsOnFlatSeam(next, a);
    thinAxes +=
      isInside && this->CellLabels[n - stride] != label && this->CellLabels[n + stride] != label;
  }
  return isInside && thinAxes < 2;
}

/// Snaps nodes of one kind and class (the parity of i + j + k, or ClassOf if there are odd
/// periods), among some cells or their vertices.
void LatticeNodes::Snap(Kind kind, int current, const IndexBox& cells)
{
  const bool hasParities = !this->HasOddPeriods();
  const int extra = kind == Vertex;
  const IndexBox box = extra ? NodesOf(cells) : cells;
  Index offsets[14]; // offsets of all neighbours: 8 of the other kind, then 6 along the axes
  const int* neighbours[14];
  for (int c = 0; c < 14; ++c)
  {
    const Index step = this->Grid.Stride(c < 8 ? 0 : (c - 8) / 2);
    offsets[c] = c < 8 ? this->Grid.CornerOffset(c) - extra * this->Grid.CornerOffset(7)
                       : (c & 1 ? step : -step);
    neighbours[c] = this->Label[c < 8 ? 1 - kind : kind].data() + offsets[c];
  }
  ForRows(this->Run, box,
    [&](Index j, Index k, Index)
    {
      const Index begin = box.Lower[0] + (hasParities ? (box.Lower[0] + j + k + current) & 1 : 0);
      const Index step = hasParities ? 2 : 1;
      Index n = this->Grid.Linear({ { begin, j, k } });
      for (Index i = begin; i < box.Upper[0]; i += step, n += step)
      {
        const int label = this->Label[kind][n];
        int differs = 0;
        for (const int* neighbour : neighbours)
        {
          differs |= neighbour[n] ^ label;
        }
        const Node node{ kind, { { i, j, k } } };
        if (label != Snapped && differs &&
          (hasParities || this->ClassOf(node.Position) == current) && this->MaySnap(node, n) &&
          this->IsNearInterface(node, n))
        {
          this->Label[kind][n] = Snapped;
        }
      }
    });
}

/// Returns the class of a node on a grid with odd periods: its parity, and along which of these
/// axes it is the last one of the period. Nodes of one class share no lattice edge, also across the
/// seam.
int LatticeNodes::ClassOf(const Index3& position) const
{
  const Index3 own = this->Grid.Canonical(position);
  int result = static_cast<int>((own[0] + own[1] + own[2]) & 1);
  for (int a = 0; a < 3; ++a)
  {
    const bool isOdd = (this->Grid.Period(a) & 1) != 0;
    result |= (isOdd && own[a] == this->Grid.Domain().Upper[a] - 1) << (a + 1);
  }
  return result;
}

bool LatticeNodes::IsNearInterface(const Node& node, Index n) const
{
  const Kind otherKind = node.Type == Vertex ? Centre : Vertex;
  const int label = this->Label[node.Type][n];
  const auto isNear = [&](const Node& other, int otherLabel, double reach)
  {
    if (otherLabel == Snapped || otherLabel == label)
    {
      return false;
    }
    const double here = this->Lead(node, label, otherLabel);
    const double there = this->Lead(other, otherLabel, label);
    return here + there > 0.0 && here / (here + there) < reach;
  };
  const Index back = node.Type == Vertex ? 1 : 0;
  for (int c = 0; c < 8; ++c)
  {
    const Node other{ otherKind,
      back ? CellOfStar(node.Position, c) : CornerOfCell(node.Position, c) };
    const Index m = n + this->Grid.CornerOffset(c) - back * this->Grid.CornerOffset(7);
    if (isNear(other, this->Label[otherKind][m], DiagonalReach))
    {
      return true;
    }
  }
  for (int face = 0; face < 6; ++face)
  {
    Node other = node;
    other.Position[face / 2] += face & 1 ? 1 : -1;
    if (isNear(other, this->Label[node.Type][this->Grid.Neighbour(n, face)], AxisReach))
    {
      return true;
    }
  }
  return false;
}

} // namespace vfm
