#include "State/Transfer/FlowNodes.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"

namespace vfm
{
namespace
{

constexpr Index MaximumDonors = Index(1) << 16; // of a cell

} // namespace

bool FlowRegion::Holds(const Donor& donor) const
{
  return this->Mismatches.IsNear(donor.Cell, FluxLayers) || this->HoldsAll(donor.Fragment);
}

bool FlowRegion::HoldsAll(int fragment) const
{
  return std::binary_search(this->Divided.begin(), this->Divided.end(), fragment);
}

FlowNodes::FlowNodes(const CartesianGrid& grid, const FlowRegion& region, const DonorLinks& links,
  const DonorTable& donors, Ranks& ranks) :
  Grid(grid),
  Donors(donors),
  Ghosts(links.Narrow(
    [&](int s) { return region.Holds(donors[s]) && this->TouchesOwned(donors[s].Cell); })),
  Numbers(donors.Count(), -1)
{
  for (int s = 0; s < donors.Count(); ++s)
  {
    if (donors[s].IsOwned && region.Holds(donors[s]))
    {
      this->AddNode(s);
      this->TheGraph.Places.push_back(grid.Position(donors[s].Cell));
    }
  }
  this->TheGraph.Nodes.resize(this->DonorOf.size());
  this->Ghosts.ForCopies(
    [&](int s)
    {
      this->AddNode(s);
      this->TheGraph.Places.push_back(grid.Canonical(grid.Position(donors[s].Cell)));
    });
  this->TheGraph.Copies = static_cast<int>(this->Count() - this->Owned());
  this->TheGraph.Update = [this](std::vector<double>& values)
  {
    this->Ghosts.Exchange(
      1, [&](int s, double* v) { v[0] = values[this->Numbers[s]]; },
      [&](int s, const double* v) { values[this->Numbers[s]] = v[0]; });
  };
  this->NumberPieces(this->FindNeighbours(), ranks);
}

bool FlowNodes::TouchesOwned(Index cell) const
{
  bool touches = false;
  for (int f = 0; f < 6; ++f)
  {
    touches =
      touches || this->Grid.Owned().Contains(this->Grid.Position(this->Grid.Neighbour(cell, f)));
  }
  return touches;
}

void FlowNodes::AddNode(int donor)
{
  this->Numbers[donor] = static_cast<int>(this->DonorOf.size());
  this->DonorOf.push_back(donor);
}

/// Finds the neighbours of owned nodes. Returns the disjoint sets of connected nodes.
std::vector<Index> FlowNodes::FindNeighbours()
{
  std::vector<Index> parent = MakeSets(this->Count());
  for (std::size_t i = 0; i < this->Owned(); ++i)
  {
    const Donor& donor = this->Donors[this->DonorOf[i]];
    for (int f = 0; f < 6; ++f)
    {
      const int other = this->Donors.Find(this->Grid.Neighbour(donor.Cell, f), donor.Fragment);
      const bool isNode = other >= 0 && this->Numbers[other] >= 0;
      int& neighbour = this->TheGraph.Nodes[i].Others[f];
      neighbour = isNode ? this->Numbers[other] : static_cast<int>(i);
      Join(parent, i, neighbour);
    }
  }
  return parent;
}

/// Returns an id that is equal on all ranks and for all copies, and that no other donor has. It is
/// formed from the cell and the position among the donors of the cell.
Index FlowNodes::IdOf(const Donor& donor) const
{
  Index place = 0;
  this->Donors.ForCell(
    donor.Cell, [&](int s) { place += this->Donors[s].Fragment < donor.Fragment; });
  const Index3 cell = this->Grid.Canonical(this->Grid.Position(donor.Cell));
  return this->Grid.CellKey(cell) * MaximumDonors + place;
}

/// Numbers the connected components over all ranks. Collective.
void FlowNodes::NumberPieces(std::vector<Index> parent, Ranks& ranks)
{
  std::vector<Piece> pieces;
  std::vector<Index> pieceOf(this->Count());
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    const Donor& donor = this->Donors[this->DonorOf[i]];
    const Index root = FindRoot(parent, static_cast<Index>(i)), id = this->IdOf(donor);
    if (root == static_cast<Index>(i))
    {
      pieceOf[i] = static_cast<Index>(pieces.size());
      pieces.push_back({ id, donor.Fragment });
    }
    pieceOf[i] = pieceOf[root];
    Index& lowest = pieces[pieceOf[i]].Lowest;
    lowest = std::min(lowest, id);
  }
  JoinedPieces joined =
    JoinPieces(pieces, this->FindSame(pieceOf, ranks), this->Ghosts.Peers(), ranks);
  for (Index piece : pieceOf)
  {
    this->TheGraph.Pieces.push_back(joined.Fragments[piece]);
  }
  this->TheGraph.Components = std::move(joined.Share);
}

/// Returns the pairs of local components that have the same copies. Collective among peers.
/// @param pieceOf  local component of each node
PiecePairs FlowNodes::FindSame(const std::vector<Index>& pieceOf, const Ranks& ranks) const
{
  // A double does not hold all 64 bits of a number, so two have 32 bits each.
  constexpr int half = 32;
  const auto numberOf = [&](int s) { return OffsetOfRank(ranks) + pieceOf[this->Numbers[s]]; };
  PiecePairs same;
  this->Ghosts.Exchange(
    2,
    [&](int s, double* v)
    {
      const Index number = numberOf(s), high = number >> half;
      v[0] = static_cast<double>(high);
      v[1] = static_cast<double>(number - (high << half));
    },
    [&](int s, const double* v)
    {
      const Index high = static_cast<Index>(v[0]), low = static_cast<Index>(v[1]);
      same.push_back({ { numberOf(s), (high << half) + low } });
    });
  SortUnique(same);
  return same;
}

std::vector<int> FindDivided(const CartesianGrid& grid, const MismatchCells& mismatches,
  const DonorLinks& links, const DonorTable& donors, Ranks& ranks)
{
  const FlowRegion region{ mismatches, {} };
  FlowNodes nodes(grid, region, links, donors, ranks);
  const FragmentShare& pieces = nodes.Graph().Components;
  std::vector<Index> fragments;
  for (int s = 0; s < donors.Count(); ++s)
  {
    fragments.push_back(donors[s].Fragment);
  }
  SortUnique(fragments);
  std::vector<std::int64_t> counts(fragments.size(), 0); // of components
  for (std::size_t p = 1; p < pieces.Size(); ++p)
  {
    if (pieces.IsMine[p])
    {
      ++counts[FindSorted(fragments, pieces.Materials[p])];
    }
  }
  KeyMerge<Index>(fragments, ranks)
    .Merge(counts, 1, [](std::int64_t& a, std::int64_t b) { a += b; });
  std::vector<int> divided;
  for (std::size_t f = 0; f < fragments.size(); ++f)
  {
    if (counts[f] > 1)
    {
      divided.push_back(static_cast<int>(fragments[f]));
    }
  }
  return divided;
}

} // namespace vfm
