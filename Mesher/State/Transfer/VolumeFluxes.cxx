#include "State/Transfer/VolumeFluxes.h"

#include "Base/ExactSum.h"
#include "Base/PortableMath.h"

namespace vfm
{
namespace
{

// Overlap of a connected component, in mean cells, up to which its factor is not reported.
constexpr double LeastPiece = 1e-13;
// Fraction of the outflow that counts as nothing.
constexpr double LeastLeft = 1e-12;

/// Donors between which contents move.
struct Movers
{
  const CartesianGrid& Grid;
  const StateColumns& Columns;
  Runtime& Run;
  DonorTable& Donors;
  DonorValues& Values;
  FlowNodes Nodes;

  const Donor& DonorAt(std::size_t node) const { return this->Donors[this->Nodes.DonorAt(node)]; }
};

/// Returns the sums of values of nodes per connected component of this rank, over all ranks. Sums
/// are in mean cells. Collective.
std::vector<double> SumPieces(
  Movers& movers, const std::function<double(std::size_t node)>& valueOf)
{
  const double unit = Cube(movers.Grid.MeanWidth());
  const FlowGraph& graph = movers.Nodes.Graph();
  std::vector<ExactSum> sums(graph.Components.Size());
  for (std::size_t i = 0; i < movers.Nodes.Owned(); ++i)
  {
    sums[graph.Pieces[i]].Add(valueOf(i) / unit);
  }
  return graph.Components.Sum(std::move(sums));
}

/// Returns the factor by which the volumes of each component must be divided so that their sum is
/// the sum of overlaps; 0 if there is no such factor. Collective.
std::vector<double> FindPieceFactors(Movers& movers, const std::vector<double>& overlaps)
{
  std::vector<double> factors =
    SumPieces(movers, [&](std::size_t i) { return movers.DonorAt(i).Volume; });
  for (std::size_t p = 0; p < factors.size(); ++p)
  {
    factors[p] = p > 0 && factors[p] > 0.0 && overlaps[p] > 0.0 ? factors[p] / overlaps[p] : 0.0;
  }
  return factors;
}

/// Returns the range of the factors of each material over all ranks. Collective.
VolumeFactors FindRanges(Movers& movers, std::size_t materials, const std::vector<double>& overlaps,
  const std::vector<double>& factors)
{
  // Negative of the smallest factor of each material, then the largest.
  std::vector<double> ranges(2 * materials, -1.0);
  std::fill(ranges.begin() + materials, ranges.end(), 1.0);
  for (std::size_t i = 0; i < movers.Nodes.Owned(); ++i)
  {
    const int piece = movers.Nodes.Graph().Pieces[i];
    if (overlaps[piece] > LeastPiece)
    {
      double* range = ranges.data() + movers.DonorAt(i).Material;
      double& most = range[materials];
      *range = std::max(*range, -factors[piece]);
      most = std::max(most, factors[piece]);
    }
  }
  movers.Run.Group().Max(ranges);
  VolumeFactors found;
  for (std::size_t m = 0; m < materials; ++m)
  {
    found.push_back({ { -ranges[m], ranges[materials + m] } });
  }
  return found;
}

/// Divides volumes by factors, and multiplies values per volume by them.
void DivideVolumes(const std::vector<double>& factors, Movers& movers)
{
  for (std::size_t i = 0; i < movers.Nodes.Count(); ++i)
  {
    const double factor = factors[movers.Nodes.Graph().Pieces[i]];
    Donor& donor = movers.Donors[movers.Nodes.DonorAt(i)];
    donor.Volume = factor > 0.0 ? donor.Volume / factor : 0.0;
    double* values = movers.Values.Of(movers.Nodes.DonorAt(i));
    for (int c = 0; c < movers.Columns.Count(); ++c)
    {
      values[c] *= movers.Columns.Base(c) < 0 ? factor : 1.0;
    }
  }
}

/// Sets the width between two nodes from the smaller one, so that little flows through a cell with
/// little content.
void FindWidths(Movers& movers)
{
  FlowGraph& graph = movers.Nodes.Graph();
  const auto sizeOf = [&movers](std::size_t i)
  { return std::max(movers.DonorAt(i).Volume, movers.DonorAt(i).Overlap); };
  ForEach(movers.Run, movers.Nodes.Owned(),
    [&](Index i)
    {
      FlowNode& node = graph.Nodes[i];
      const Index3& p = graph.Places[i];
      for (int f = 0; f < 6; ++f)
      {
        if (node.Others[f] != i)
        {
          const int a = f / 2;
          Index3 q = p;
          q[a] += f & 1 ? 1 : -1;
          q = movers.Grid.Canonical(q); // both sides use the same bits
          const double distance = movers.Grid.Width(a, p[a]) + movers.Grid.Width(a, q[a]);
          node.Widths[f] = std::min(sizeOf(i), sizeOf(node.Others[f])) / (distance * distance);
        }
      }
    });
}

/// Volumes that flow between nodes.
struct Flows
{
  const FlowGraph& Graph;
  std::vector<double> Potential; ///< potential of each node
  std::vector<double> Outflow;   ///< total outflow of each owned node

  /// Returns the flow out of a node across a face; it is exactly the negative of the other side's.
  double Out(std::size_t i, int f) const
  {
    const FlowNode& node = this->Graph.Nodes[i];
    return node.Widths[f] * (this->Potential[i] - this->Potential[node.Others[f]]);
  }
};

/// Finds the flows that make volumes equal to overlaps. Collective.
Flows FindFlows(Movers& movers, const std::vector<double>& overlaps)
{
  const FlowGraph& graph = movers.Nodes.Graph();
  const std::size_t owned = movers.Nodes.Owned();
  std::vector<double> excess(owned), sizes(owned);
  for (std::size_t i = 0; i < owned; ++i)
  {
    excess[i] = movers.DonorAt(i).Volume - movers.DonorAt(i).Overlap;
    sizes[i] = movers.Grid.CellVolume(graph.Places[i]);
  }
  // Removes the total excess of each component, which cannot flow anywhere. It is due to rounding,
  // or is all of the overlap if the cells contain nothing.
  const std::vector<double> rest =
    SumPieces(movers, [&excess](std::size_t i) { return excess[i]; });
  for (std::size_t i = 0; i < owned; ++i)
  {
    const int piece = graph.Pieces[i];
    excess[i] -=
      overlaps[piece] > 0.0 ? movers.DonorAt(i).Overlap * (rest[piece] / overlaps[piece]) : 0.0;
  }
  Flows flows{ graph, FindPotential(movers.Nodes.Graph(), std::move(excess), sizes, movers.Run),
    std::vector<double>(owned, 0.0) };
  for (std::size_t i = 0; i < owned; ++i)
  {
    for (int f = 0; f < 6; ++f)
    {
      flows.Outflow[i] += std::max(flows.Out(i, f), 0.0);
    }
  }
  return flows;
}

/// Updates the shares and values of copies. Collective among peers.
/// @param shares  one share per node
void UpdateCopies(std::vector<double>& shares, Movers& movers)
{
  const int count = movers.Columns.Count();
  movers.Nodes.Links().Exchange(
    1 + count,
    [&](int s, double* numbers)
    {
      numbers[0] = shares[movers.Nodes.NodeOf(s)];
      std::copy_n(movers.Values.Of(s), count, numbers + 1);
    },
    [&](int s, const double* numbers)
    {
      shares[movers.Nodes.NodeOf(s)] = numbers[0];
      std::copy_n(numbers + 1, count, movers.Values.Of(s));
    });
}

/// Returns the volume of a node after a round, and writes its values.
double Receive(const Movers& movers, const Flows& flows, const std::vector<double>& shares,
  std::size_t i, double* values)
{
  const DonorValues& held = movers.Values;
  const int s = movers.Nodes.DonorAt(i);
  std::copy_n(held.Of(s), movers.Columns.Count(), values);
  double volume = std::max(movers.DonorAt(i).Volume - shares[i] * flows.Outflow[i], 0.0);
  for (int f = 0; f < 6; ++f)
  {
    const double inflow = -flows.Out(i, f);
    if (inflow > 0.0)
    {
      const int other = flows.Graph.Nodes[i].Others[f];
      const double part = shares[other] * inflow;
      if (part > 0.0)
      {
        movers.Columns.Mix(volume, values, part, held.Of(movers.Nodes.DonorAt(other)));
      }
    }
  }
  return volume;
}

/// Runs a round, in which each node gives as much of its remaining outflow as it contains.
/// Collective.
/// @param left  fraction of the outflow that each owned node must still give
/// @param shares  gets the fraction of the outflow that each node gives in this round
/// @return whether some nodes contained too little and may still receive more, so that another
/// round is useful. The number of rounds is at most the number of steps down the potential.
bool MoveOnce(
  const Flows& flows, std::vector<double>& left, std::vector<double>& shares, Movers& movers)
{
  const std::size_t owned = movers.Nodes.Owned();
  const int columns = movers.Columns.Count();
  std::vector<std::int64_t> isAny(2, 0); // whether any node contained too little, or gave some
  for (std::size_t i = 0; i < owned; ++i)
  {
    const double outflow = flows.Outflow[i];
    shares[i] = outflow > 0.0 ? std::min(left[i], movers.DonorAt(i).Volume / outflow) : 0.0;
    left[i] -= shares[i];
    isAny[0] |= left[i] > LeastLeft && outflow > 0.0;
    isAny[1] |= shares[i] > LeastLeft;
  }
  UpdateCopies(shares, movers);
  std::vector<double> volumes(owned), moved(owned * columns);
  ForEach(movers.Run, owned,
    [&](Index i) { volumes[i] = Receive(movers, flows, shares, i, moved.data() + i * columns); });
  ForEach(movers.Run, owned,
    [&](Index i)
    {
      movers.Donors[movers.Nodes.DonorAt(i)].Volume = volumes[i];
      std::copy_n(moved.data() + i * columns, columns, movers.Values.Of(movers.Nodes.DonorAt(i)));
    });
  movers.Run.Group().Sum(isAny);
  return isAny[0] > 0 && isAny[1] > 0;
}

} // namespace

VolumeFactors MoveContents(const StateSource& source, const FlowRegion& region,
  const DonorLinks& links, Runtime& runtime, DonorTable& donors, DonorValues& values)
{
  const CartesianGrid& grid = source.Request.Grid;
  Movers movers{ grid, source.Columns, runtime, donors, values,
    FlowNodes(grid, region, links, donors, runtime.Group()) };
  movers.Nodes.Links().Exchange(
    1, [&](int s, double* v) { v[0] = donors[s].Volume; },
    [&](int s, const double* v) { donors[s].Volume = v[0]; });
  const std::vector<double> overlaps =
    SumPieces(movers, [&](std::size_t i) { return movers.DonorAt(i).Overlap; });
  const std::vector<double> factors = FindPieceFactors(movers, overlaps);
  VolumeFactors ranges = FindRanges(movers, source.IsMeshed.size(), overlaps, factors);
  DivideVolumes(factors, movers);
  FindWidths(movers);
  const Flows flows = FindFlows(movers, overlaps);
  std::vector<double> left(movers.Nodes.Owned(), 1.0), shares(movers.Nodes.Count(), 0.0);
  while (MoveOnce(flows, left, shares, movers))
  {
  }
  return ranges;
}

} // namespace vfm
