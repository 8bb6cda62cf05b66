#include "State/Transfer/FlowNodes.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Labels/Fragments.h"

namespace vfm
{

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
  this->Ghosts.ForCopies([this](int s) { this->AddNode(s); });
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

/// Returns an id that is equal on all ranks and for all copies. It is formed like the id of a
/// point, from the cell and the position among the donors of the cell.
Index FlowNodes::IdOf(const Donor& donor) const
{
  Index place = 0;
  this->Donors.ForCell(
    donor.Cell, [&](int s) { place += this->Donors[s].Fragment < donor.Fragment; });
  const Index3 cell = this->Grid.Canonical(this->Grid.Position(donor.Cell));
  return this->Grid.CellKey(cell) * TetIds.PointSlots + std::min(place, TetIds.PointSlots - 1);
}

/// Numbers the connected components over all ranks. Collective.
void FlowNodes::NumberPieces(std::vector<Index> parent, Ranks& ranks)
{
  std::vector<Piece> pieces;
  std::vector<double> pieceOf(this->Count());
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    const Donor& donor = this->Donors[this->DonorOf[i]];
    const Index root = FindRoot(parent, i), id = this->IdOf(donor);
    if (root == static_cast<Index>(i))
    {
      pieceOf[i] = static_cast<double>(pieces.size());
      pieces.push_back({ id, donor.Fragment });
    }
    pieceOf[i] = pieceOf[root];
    Index& lowest = pieces[static_cast<std::size_t>(pieceOf[i])].Lowest;
    lowest = std::min(lowest, id);
  }
  const Index offset = OffsetOfPieces(ranks, static_cast<Index>(pieces.size()));
  std::vector<double> known = pieceOf;
  for (double& piece : known)
  {
    piece += static_cast<double>(offset);
  }
  const std::vector<double> mine = known;
  this->TheGraph.Update(known);
  PiecePairs same;
  for (std::size_t i = this->Owned(); i < known.size(); ++i)
  {
    same.push_back({ { static_cast<Index>(mine[i]), static_cast<Index>(known[i]) } });
  }
  SortUnique(same);
  const std::vector<int> numbers =
    NumberFragments(pieces, same, offset, ranks, this->PieceFragments);
  for (double piece : pieceOf)
  {
    this->TheGraph.Pieces.push_back(numbers[static_cast<std::size_t>(piece)]);
  }
}

std::vector<int> FindDivided(const CartesianGrid& grid, const MismatchCells& mismatches,
  const DonorLinks& links, const DonorTable& donors, Ranks& ranks)
{
  const FlowRegion region{ mismatches, {} };
  std::vector<int> fragments = FlowNodes(grid, region, links, donors, ranks).FragmentsOfPieces();
  fragments.erase(fragments.begin()); // entry 0 is unused
  std::sort(fragments.begin(), fragments.end());
  std::vector<int> divided;
  for (std::size_t p = 1; p < fragments.size(); ++p)
  {
    if (fragments[p] == fragments[p - 1])
    {
      divided.push_back(fragments[p]);
    }
  }
  SortUnique(divided);
  return divided;
}

} // namespace vfm
