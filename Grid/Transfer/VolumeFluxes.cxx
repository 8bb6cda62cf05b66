#include "Transfer/VolumeFluxes.h"

#include "Base/DisjointSets.h"
#include "Base/ExactSum.h"
#include "Base/Sorted.h"
#include "Labels/Fragments.h"
#include "Transfer/PotentialFlow.h"

namespace vfm
{
namespace
{

constexpr int MostRounds = 64; // a few do, unless cells give many times what they hold

/// The donors between which contents move.
class ContentMover
{
public:
  ContentMover(const StateSource& source, const MisfitCells& misfits, const Partition& partition,
    const DonorLinks& links, Runtime& runtime, DonorTable& donors, DonorValues& values) :
    Grid(source.Request.Grid),
    Columns(source.Columns),
    Ghosts(links.Narrow(
      [&](int s) {
        return misfits.IsNear(donors[s].Cell, FluxLayers) && this->TouchesOwned(donors[s].Cell);
      })),
    TheRanks(partition.Group()),
    Run(runtime),
    Donors(donors),
    Values(values),
    Numbers(donors.Count(), -1),
    Factors(source.IsMeshed.size(), { { 1.0, 1.0 } })
  {
    for (int s = 0; s < donors.Count(); ++s)
    {
      if (donors[s].IsOwned && misfits.IsNear(donors[s].Cell, FluxLayers))
      {
        this->AddNode(s);
      }
    }
    this->Owned = this->DonorOf.size();
    this->Ghosts.Exchange(
      1, [&](int s, double* v) { v[0] = donors[s].Volume; },
      [&](int s, const double* v)
      {
        donors[s].Volume = v[0];
        this->AddNode(s);
      });
  }

  VolumeFactors Move()
  {
    this->JoinNodes();
    this->MatchTotals();
    this->FindWidths();
    this->FindFlows();
    for (int round = 0; round < MostRounds && this->MoveOnce(); ++round)
    {
    }
    return std::move(this->Factors);
  }

private:
  bool TouchesOwned(Index cell) const
  {
    bool touches = false;
    for (int f = 0; f < 6; ++f)
    {
      touches =
        touches || this->Grid.Owned().Contains(this->Grid.Position(this->Grid.Neighbour(cell, f)));
    }
    return touches;
  }

  void AddNode(int s)
  {
    this->Numbers[s] = static_cast<int>(this->DonorOf.size());
    this->DonorOf.push_back(s);
  }

  /// Finds the neighbours, and which nodes hang together.
  void JoinNodes()
  {
    this->Graph.Nodes.resize(this->Owned);
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      this->Graph.Places.push_back(this->Grid.Position(this->Donors[this->DonorOf[i]].Cell));
    }
    this->Graph.Copies = static_cast<int>(this->DonorOf.size() - this->Owned);
    this->Graph.Update = [this](std::vector<double>& values)
    {
      this->Ghosts.Exchange(
        1, [&](int s, double* v) { v[0] = values[this->Numbers[s]]; },
        [&](int s, const double* v) { values[this->Numbers[s]] = v[0]; });
    };
    std::vector<Index> parent = MakeSets(this->DonorOf.size());
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      const Donor& donor = this->Donors[this->DonorOf[i]];
      for (int f = 0; f < 6; ++f)
      {
        const int other = this->Donors.Find(this->Grid.Neighbour(donor.Cell, f), donor.Fragment);
        const bool isNode = other >= 0 && this->Numbers[other] >= 0;
        this->Graph.Nodes[i].Others[f] = isNode ? this->Numbers[other] : static_cast<int>(i);
        Join(parent, i, this->Graph.Nodes[i].Others[f]);
      }
    }
    this->NumberPieces(parent);
  }

  /// From the cell and the place among its donors, the same on all ranks; as ids of points.
  Index IdOf(const Donor& donor) const
  {
    Index place = 0;
    this->Donors.ForCell(
      donor.Cell, [&](int s) { place += this->Donors[s].Fragment < donor.Fragment; });
    return this->Grid.CellKey(this->Grid.Position(donor.Cell)) * TetIds.PointSlots +
      std::min(place, TetIds.PointSlots - 1);
  }

  /// Pieces over all ranks.
  void NumberPieces(std::vector<Index>& parent)
  {
    std::vector<Piece> pieces;
    std::vector<double> pieceOf(this->DonorOf.size());
    for (std::size_t i = 0; i < this->DonorOf.size(); ++i)
    {
      const Index root = FindRoot(parent, i), id = this->IdOf(this->DonorAt(i));
      if (root == static_cast<Index>(i))
      {
        pieceOf[i] = static_cast<double>(pieces.size());
        pieces.push_back({ id, this->DonorAt(i).Material });
      }
      pieceOf[i] = pieceOf[root];
      Index& lowest = pieces[static_cast<std::size_t>(pieceOf[i])].Lowest;
      lowest = std::min(lowest, id);
    }
    const Index offset = OffsetOfPieces(this->TheRanks, static_cast<Index>(pieces.size()));
    std::vector<double> known = pieceOf;
    for (double& piece : known)
    {
      piece += static_cast<double>(offset);
    }
    const std::vector<double> mine = known;
    this->Graph.Update(known);
    PiecePairs same;
    for (std::size_t i = this->Owned; i < known.size(); ++i)
    {
      same.push_back({ { static_cast<Index>(mine[i]), static_cast<Index>(known[i]) } });
    }
    SortUnique(same);
    const std::vector<int> numbers =
      NumberFragments(pieces, same, offset, this->TheRanks, this->PieceMaterials);
    this->Graph.Pieces.resize(this->DonorOf.size());
    for (std::size_t i = 0; i < this->DonorOf.size(); ++i)
    {
      this->Graph.Pieces[i] = numbers[static_cast<std::size_t>(pieceOf[i])];
    }
  }

  /// Of what nodes have, by piece and over all ranks, in mean cells.
  std::vector<double> SumPieces(const std::function<double(std::size_t node)>& valueOf)
  {
    const double unit = std::ldexp(std::pow(this->Grid.MeanWidth(), 3.0), -FinerBits);
    std::vector<ExactSum> sums(this->PieceMaterials.size());
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

  const Donor& DonorAt(std::size_t node) const { return this->Donors[this->DonorOf[node]]; }

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
      if (this->Overlaps[p] > LeastPiece)
      {
        std::array<double, 2>& range = this->Factors[this->PieceMaterials[p]];
        range = { { std::min(range[0], factors[p]), std::max(range[1], factors[p]) } };
      }
    }
    for (std::size_t i = 0; i < this->DonorOf.size(); ++i)
    {
      const double factor = factors[this->Graph.Pieces[i]];
      Donor& donor = this->Donors[this->DonorOf[i]];
      donor.Volume = factor > 0.0 ? donor.Volume / factor : 0.0;
      double* values = this->Values.Of(this->DonorOf[i]);
      for (int c = 0; c < this->Columns.Count(); ++c)
      {
        values[c] *= this->Columns.Base(c) < 0 ? factor : 1.0;
      }
    }
  }

  /// As wide as the smaller of two: little flows through a cell that holds little.
  void FindWidths()
  {
    const auto sizeOf = [this](int i)
    {
      const Donor& donor = this->Donors[this->DonorOf[i]];
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
    this->Shares.assign(this->DonorOf.size(), 0.0);
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

  /// Each gives what it has of what it must still give. Whether some were short of it.
  bool MoveOnce()
  {
    bool isShort = false;
    for (std::size_t i = 0; i < this->Owned; ++i)
    {
      double& share = this->Shares[i];
      share = this->Outflow[i] > 0.0
        ? std::min(this->Left[i], this->Donors[this->DonorOf[i]].Volume / this->Outflow[i])
        : 0.0;
      this->Left[i] -= share;
      isShort = isShort || (this->Left[i] > LeastLeft && this->Outflow[i] > 0.0);
    }
    this->UpdateCopies();
    std::vector<double> volumes(this->Owned);
    std::vector<double> moved(this->Owned * this->Columns.Count());
    ForEach(this->Run, this->Owned,
      [&](Index i) { volumes[i] = this->Receive(i, moved.data() + i * this->Columns.Count()); });
    ForEach(this->Run, this->Owned,
      [&](Index i)
      {
        this->Donors[this->DonorOf[i]].Volume = volumes[i];
        std::copy_n(moved.data() + i * this->Columns.Count(), this->Columns.Count(),
          this->Values.Of(this->DonorOf[i]));
      });
    return this->TheRanks.Any(isShort);
  }

  void UpdateCopies()
  {
    const int count = this->Columns.Count();
    this->Ghosts.Exchange(
      1 + count,
      [&](int s, double* numbers)
      {
        numbers[0] = this->Shares[this->Numbers[s]];
        std::copy_n(this->Values.Of(s), count, numbers + 1);
      },
      [&](int s, const double* numbers)
      {
        this->Shares[this->Numbers[s]] = numbers[0];
        std::copy_n(numbers + 1, count, this->Values.Of(s));
      });
  }

  /// What a node has after a round: the volume, and in values what is in it.
  double Receive(std::size_t i, double* values) const
  {
    const int s = this->DonorOf[i];
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
          this->Columns.Mix(volume, values, part, this->Values.Of(this->DonorOf[other]));
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
  const DonorLinks Ghosts;
  Ranks& TheRanks;
  Runtime& Run;
  DonorTable& Donors;
  DonorValues& Values;
  std::vector<int> Numbers; // of donors among the nodes; -1: none
  std::vector<int> DonorOf; // of nodes; copies last
  std::size_t Owned = 0;    // nodes
  VolumeFactors Factors;
  FlowGraph Graph;
  std::vector<int> PieceMaterials;   // of pieces
  std::vector<double> Overlaps;      // of pieces, in mean cells
  std::vector<double> Potential;     // of nodes
  std::vector<double> Outflow, Left; // of owned nodes: in total; what part is still to be given
  std::vector<double> Shares;        // of the outflow, given in this round; of nodes
};

} // namespace

VolumeFactors MoveContents(const StateSource& source, const MisfitCells& misfits,
  const Partition& partition, const DonorLinks& links, Runtime& runtime, DonorTable& donors,
  DonorValues& values)
{
  return ContentMover(source, misfits, partition, links, runtime, donors, values).Move();
}

} // namespace vfm
