/**
 * The donors between which contents move, as nodes of a graph: those in cells near misfits, and all of fragments whose cells near misfits
 * do not hang together, as those of a shell. Such a fragment has its volume in total, but not at each of its sides.
 */
#pragma once

#include "Transfer/MismatchCells.h"
#include "Transfer/PotentialFlow.h"

namespace vfm
{

/// Which donors are nodes.
struct FlowRegion
{
  const MismatchCells& Mismatches;
  std::vector<int> Divided; ///< fragments of which all donors are, ascending; the same on all ranks

  bool Holds(const Donor& donor) const;
  bool HoldsAll(int fragment) const;
};

class FlowNodes
{
public:
  /// links: of all donors. Collective.
  FlowNodes(const CartesianGrid& grid, const FlowRegion& region, const DonorLinks& links,
    const DonorTable& donors, Ranks& ranks);
  FlowNodes(const FlowNodes&) = delete;
  FlowNodes& operator=(const FlowNodes&) = delete;

  /// But for the widths.
  FlowGraph& Graph() { return this->TheGraph; }
  /// Those of this rank come first, then copies.
  std::size_t Owned() const { return this->TheGraph.Nodes.size(); }
  std::size_t Count() const { return this->DonorOf.size(); }
  int DonorAt(std::size_t node) const { return this->DonorOf[node]; }
  /// Of a donor; -1: none.
  int NodeOf(int donor) const { return this->Numbers[donor]; }
  /// Between the donors of nodes and those of copies.
  const DonorLinks& Links() const { return this->Ghosts; }
  /// Of each piece over all ranks, as in FlowGraph::Pieces.
  const std::vector<int>& FragmentsOfPieces() const { return this->PieceFragments; }

private:
  bool TouchesOwned(Index cell) const;
  void AddNode(int donor);
  std::vector<Index> FindNeighbours();
  Index IdOf(const Donor& donor) const;
  void NumberPieces(std::vector<Index> parent, Ranks& ranks);

  const CartesianGrid& Grid;
  const DonorTable& Donors;
  const DonorLinks Ghosts;
  std::vector<int> Numbers; // of donors among the nodes
  std::vector<int> DonorOf; // of nodes
  FlowGraph TheGraph;
  std::vector<int> PieceFragments;
};

/// The fragments whose donors near misfits are in several pieces, ascending. Collective.
std::vector<int> FindDivided(const CartesianGrid& grid, const MismatchCells& mismatches,
  const DonorLinks& links, const DonorTable& donors, Ranks& ranks);

} // namespace vfm
