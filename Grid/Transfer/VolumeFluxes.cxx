#include "Transfer/VolumeFluxes.h"

#include "Base/ExactSum.h"
#include "Ranks/MaxOfEach.h"

namespace vfm
{
namespace
{

/// The donors between which contents move.
class ContentMover
{
public:
  ContentMover(const StateSource& source, const FlowRegion& region, const DonorLinks& links,
    Runtime& runtime, DonorTable& donors, DonorValues& values) :
    Grid(source.Request.Grid),
    Columns(source.Columns),
    TheRanks(runtime.Group()),
    Run(runtime),
    Donors(donors),
    Values(values),
    Nodes(this->Grid, region, links, donors, this->TheRanks),
    Graph(this->Nodes.Graph()),
    Owned(this->Nodes.Owned()),
    Factors(source.IsMeshed.size(), { { 1.0, 1.0 } })
  {
    this->Nodes.Links().Exchange(
      1, [&](int s, double* v) { v[0] = donors[s].Volume; },
      [&](int s, const double* v) { donors[s].Volume = v[0]; });
  }

  VolumeFactors Move()
  {
    this->MatchTotals();
    this->FindWidths();
    this->FindFlows();
    while (this->MoveOnce())
    {
    }
    return std::move(this->Factors);
  }

private:
  /// Of what nodes have, by piece and over all ranks, in mean cells.
  std::vector<double> SumPieces(const std::function<double(std::size_t node)>& valueOf)
  {
    const double unit = std::ldexp(std::pow(this->Grid.MeanWidth(), 3.0), -FinerBits);
    std::vector<ExactSum> sums(this->Nodes.FragmentsOfPieces().size());
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      sums[this->Graph.Pieces[i]].Add(valueOf(i) / unit);
    }
    std::vector<double> totals = SumOverRanks(sums, this->TheRanks);
    for (double& total : totals)
    {
      total = std::ldexp(total, -FinerBits);
    }
    return totals;
  }

  const Donor& DonorAt(std::size_t node) const { return this->Donors[this->Nodes.DonorAt(node)]; }

  /// Multiplies the volumes of each piece so that they have the sum of the overlaps.
  void MatchTotals()
  {
    const std::vector<double> held =
      this->SumPieces([this](std::size_t i) { return this->DonorAt(i).Volume; });
    this->Overlaps = this->SumPieces([this](std::size_t i) { return this->DonorAt(i).Overlap; });
    std::vector<double> factors(held.size(), 0.0);
    for (std::size_t p = 1; p < held.size(); ++p)
    {
      factors[p] = held[p] > 0.0 && this->Overlaps[p] > 0.0 ? held[p] / this->Overlaps[p] : 0.0;
    }
    this->Tell(factors);
    for (std::size_t i = 0; i < this->Nodes.Count(); ++i)
    {
      const double factor = factors[this->Graph.Pieces[i]];
      Donor& donor = this->Donors[this->Nodes.DonorAt(i)];
      donor.Volume = factor > 0.0 ? donor.Volume / factor : 0.0;
      double* values = this->Values.Of(this->Nodes.DonorAt(i));
      for (int c = 0; c < this->Columns.Count(); ++c)
      {
        values[c] *= this->Columns.Base(c) < 0 ? factor : 1.0;
      }
    }
  }

  /// Of materials, over all ranks.
  void Tell(const std::vector<double>& factors)
  {
    std::vector<double> ranges(2 * this->Factors.size(), -1.0); // -least, most
    std::fill(ranges.begin() + this->Factors.size(), ranges.end(), 1.0);
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      const int piece = this->Graph.Pieces[i];
      if (this->Overlaps[piece] > LeastPiece)
      {
        double* range = ranges.data() + this->DonorAt(i).Material;
        double& most = range[this->Factors.size()];
        *range = std::max(*range, -factors[piece]);
        most = std::max(most, factors[piece]);
      }
    }
    MaxOfEach(ranges, this->TheRanks);
    for (std::size_t m = 0; m < this->Factors.size(); ++m)
    {
      this->Factors[m] = { { -ranges[m], ranges[this->Factors.size() + m] } };
    }
  }

  /// As wide as the smaller of two: little flows through a cell that holds little.
  void FindWidths()
  {
    const auto sizeOf = [this](int i)
    {
      const Donor& donor = this->Donors[this->Nodes.DonorAt(i)];
      return std::max(donor.Volume, donor.Overlap);
    };
    ForEach(this->Run, this->Owned,
      [&](Index i)
      {
        FlowNode& node = this->Graph.Nodes[i];
        const Index3& p = this->Graph.Places[i];
        for (int f = 0; f < 6; ++f)
        {
          if (node.Others[f] != i)
          {
            const int a = f / 2;
            const Index q = p[a] + (f & 1 ? 1 : -1);
            const double distance = this->Grid.Width(a, p[a]) + this->Grid.Width(a, q);
            node.Widths[f] =
              std::min(sizeOf(static_cast<int>(i)), sizeOf(node.Others[f])) / (distance * distance);
          }
        }
      });
  }

  void FindFlows()
  {
    std::vector<double> excess(this->Owned), sizes(this->Owned);
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      excess[i] = this->DonorAt(i).Volume - this->DonorAt(i).Overlap;
      sizes[i] = this->Grid.CellVolume(this->Graph.Places[i]);
    }
    // What rounding leaves in all of a piece, or all of it where cells hold nothing, flows nowhere.
    const std::vector<double> rest =
      this->SumPieces([&excess](std::size_t i) { return excess[i]; });
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      const int piece = this->Graph.Pieces[i];
      excess[i] -= this->Overlaps[piece] > 0.0
        ? this->DonorAt(i).Overlap * (rest[piece] / this->Overlaps[piece])
        : 0.0;
    }
    this->Potential = FindPotential(this->Graph, std::move(excess), sizes, this->Run);
    this->Outflow.assign(this->Owned, 0.0);
    this->Left.assign(this->Owned, 1.0);
    this->Shares.assign(this->Nodes.Count(), 0.0);
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      for (int f = 0; f < 6; ++f)
      {
        this->Outflow[i] += std::max(this->FlowOut(i, f), 0.0);
      }
    }
  }

  /// Over a face of a node's cell; of the other side exactly the negative.
  double FlowOut(std::size_t i, int f) const
  {
    const FlowNode& node = this->Graph.Nodes[i];
    return node.Widths[f] * (this->Potential[i] - this->Potential[node.Others[f]]);
  }

  /// Each gives what it has of what it must still give. Whether some were short of it, and may get more: then to give once more makes
  /// sense, as often as there are steps down the potential.
  bool MoveOnce()
  {
    std::vector<std::int64_t> isAny(2, 0); // short, giving
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      double& share = this->Shares[i];
      share = this->Outflow[i] > 0.0
        ? std::min(this->Left[i], this->DonorAt(i).Volume / this->Outflow[i])
        : 0.0;
      this->Left[i] -= share;
      isAny[0] |= this->Left[i] > LeastLeft && this->Outflow[i] > 0.0;
      isAny[1] |= share > LeastLeft;
    }
    this->UpdateCopies();
    std::vector<double> volumes(this->Owned);
    std::vector<double> moved(this->Owned * this->Columns.Count());
    ForEach(this->Run, this->Owned,
      [&](Index i) { volumes[i] = this->Receive(i, moved.data() + i * this->Columns.Count()); });
    ForEach(this->Run, this->Owned,
      [&](Index i)
      {
        this->Donors[this->Nodes.DonorAt(i)].Volume = volumes[i];
        std::copy_n(moved.data() + i * this->Columns.Count(), this->Columns.Count(),
          this->Values.Of(this->Nodes.DonorAt(i)));
      });
    this->TheRanks.Sum(isAny);
    return isAny[0] > 0 && isAny[1] > 0;
  }

  void UpdateCopies()
  {
    const int count = this->Columns.Count();
    this->Nodes.Links().Exchange(
      1 + count,
      [&](int s, double* numbers)
      {
        numbers[0] = this->Shares[this->Nodes.NodeOf(s)];
        std::copy_n(this->Values.Of(s), count, numbers + 1);
      },
      [&](int s, const double* numbers)
      {
        this->Shares[this->Nodes.NodeOf(s)] = numbers[0];
        std::copy_n(numbers + 1, count, this->Values.Of(s));
      });
  }

  /// What a node has after a round: the volume, and in values what is in it.
  double Receive(std::size_t i, double* values) const
  {
    const int s = this->Nodes.DonorAt(i);
    std::copy_n(this->Values.Of(s), this->Columns.Count(), values);
    double volume = std::max(this->Donors[s].Volume - this->Shares[i] * this->Outflow[i], 0.0);
    for (int f = 0; f < 6; ++f)
    {
      const double inflow = -this->FlowOut(i, f);
      if (inflow > 0.0)
      {
        const int other = this->Graph.Nodes[i].Others[f];
        const double part = this->Shares[other] * inflow;
        if (part > 0.0)
        {
          this->Columns.Mix(volume, values, part, this->Values.Of(this->Nodes.DonorAt(other)));
        }
      }
    }
    return volume;
  }

  static constexpr int FinerBits = 30;        // than those of ExactSum
  static constexpr double LeastPiece = 1e-13; // of a mean cell: what is told of
  static constexpr double LeastLeft = 1e-12;

  const CartesianGrid& Grid;
  const StateColumns& Columns;
  Ranks& TheRanks;
  Runtime& Run;
  DonorTable& Donors;
  DonorValues& Values;
  FlowNodes Nodes;
  FlowGraph& Graph;
  const std::size_t Owned; // nodes
  VolumeFactors Factors;
  std::vector<double> Overlaps;      // of pieces, in mean cells
  std::vector<double> Potential;     // of nodes
  std::vector<double> Outflow, Left; // of owned nodes: in total; what part is still to be given
  std::vector<double> Shares;        // of the outflow, given in this round; of nodes
};

} // namespace

VolumeFactors MoveContents(const StateSource& source, const FlowRegion& region,
  const DonorLinks& links, Runtime& runtime, DonorTable& donors, DonorValues& values)
{
  return ContentMover(source, region, links, runtime, donors, values).Move();
}

} // namespace vfm
