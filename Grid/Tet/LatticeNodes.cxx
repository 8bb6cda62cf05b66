#include "Tet/LatticeNodes.h"

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

} // namespace

LatticeNodes::LatticeNodes(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue, Runtime& runtime) :
  Grid(grid), Fractions(fractions), IsoValue(isoValue), Run(runtime)
{
  // Extends arrays by the offset across a cell, so that nodes on the upper side have all neighbours
  // in memory.
  const Index size = grid.NumberOfEntries() + grid.CornerOffset(7);
  for (auto& labels : this->Label)
  {
    labels.assign(size, Snapped);
  }
  ForRows(runtime, grid.Local(), [this](Index j, Index k, Index) { this->LabelCentres(j, k); });
  const IndexBox box = grid.Extended(GhostLayers - 1);
  ForRows(runtime, NodesOf(box), [&](Index j, Index k, Index) { this->LabelVertices(box, j, k); });
  // Each pass reads one layer more than it writes.
  this->Snap(Centre, 0, HexLayers + 3);
  this->Snap(Centre, 1, HexLayers + 2);
  this->Snap(Vertex, 0, HexLayers + 1);
  this->Snap(Vertex, 1, HexLayers);
}

void LatticeNodes::Unsnap(const Node& node)
{
  this->Label[node.Type][this->Grid.Linear(node.Position)] =
    this->LabelOfMean({ { node, node, node, node } });
}

void LatticeNodes::LabelCentres(Index j, Index k)
{
  const IndexBox& box = this->Grid.Local();
  const Index first = this->Grid.Linear({ { box.Lower[0], j, k } });
  for (Index cell = first; cell < first + box.Size(0); ++cell)
  {
    this->Label[Centre][cell] = MaterialOfCell(this->Fractions, cell, this->IsoValue);
  }
}

void LatticeNodes::LabelVertices(const IndexBox& box, Index j, Index k)
{
  const IndexBox& local = this->Grid.Local();
  const Index count = box.Size(0) + 1;
  Index rows[4]; // rows of cells around the vertices, from one cell before the first vertex
  for (int c = 0; c < 4; ++c)
  {
    const Index3 cell = local.Nearest({ { box.Lower[0], j - 1 + (c & 1), k - 1 + (c >> 1) } });
    rows[c] = this->Grid.Linear({ { box.Lower[0] - 1, cell[1], cell[2] } });
  }
  // Returns the label of the four cells of column i, or -1 if any is mixed or they differ.
  const auto pureLabel = [&](Index i)
  {
    const Index x = box.Lower[0] - 1 + i;
    i += (x < local.Lower[0]) - (x >= local.Upper[0]);
    const int label =
      this->Fractions.IsMixed(rows[0] + i) ? -1 : this->Fractions.Label(rows[0] + i);
    bool same = label >= 0;
    for (int c = 1; c < 4 && same; ++c)
    {
      same = !this->Fractions.IsMixed(rows[c] + i) && this->Fractions.Label(rows[c] + i) == label;
    }
    return same ? label : -1;
  };
  int* labels = &this->Label[Vertex][this->Grid.Linear({ { box.Lower[0], j, k } })];
  FractionSum sum;
  int before = pureLabel(0);
  for (Index i = 0; i < count; ++i)
  {
    const int after = pureLabel(i + 1);
    labels[i] = before;
    if (before < 0 || before != after)
    {
      sum.Clear();
      this->AddParts({ Vertex, { { box.Lower[0] + i, j, k } } }, 1.0, sum);
      labels[i] = sum.Material(this->IsoValue);
    }
    before = after;
  }
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

void LatticeNodes::AddParts(const Node& node, double weight, FractionSum& sum) const
{
  if (node.Type == Centre)
  {
    sum.Add(this->Fractions, this->Grid.Linear(node.Position), weight);
    return;
  }
  for (Index cell : this->StarOf(node.Position))
  {
    sum.Add(this->Fractions, cell, 0.125 * weight);
  }
}

int LatticeNodes::LabelOfMean(const std::array<Node, 4>& nodes) const
{
  FractionSum sum;
  for (const Node& node : nodes)
  {
    this->AddParts(node, 0.25, sum);
  }
  return sum.Material(this->IsoValue);
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

/// Snaps nodes of one kind and parity, among the cells of Extended(level) or their vertices.
void LatticeNodes::Snap(Kind kind, int parity, int level)
{
  const int extra = kind == Vertex;
  const IndexBox cells = this->Grid.Extended(level), box = extra ? NodesOf(cells) : cells;
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
      const Index begin = box.Lower[0] + ((box.Lower[0] + j + k + parity) & 1);
      Index n = this->Grid.Linear({ { begin, j, k } });
      for (Index i = begin; i < box.Upper[0]; i += 2, n += 2)
      {
        const int label = this->Label[kind][n];
        int differs = 0;
        for (const int* neighbour : neighbours)
        {
          differs |= neighbour[n] ^ label;
        }
        if (differs && this->IsNearInterface({ kind, { { i, j, k } } }, n))
        {
          this->Label[kind][n] = Snapped;
        }
      }
    });
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
