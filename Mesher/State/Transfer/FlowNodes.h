/**
 * FlowNodes: the donors between which contents move, as nodes of a graph. These are the donors near
 * mismatch cells. If the donors of a fragment near mismatch cells are not connected, as in a thick
 * shell, all its donors are nodes. The volumes of such a fragment match in total,
 * but not on each side.
 */
#pragma once

#include "Labels/JoinPieces.h"
#include "State/Transfer/MismatchCells.h"
#include "State/Transfer/PotentialFlow.h"

namespace vfm
{

/// Determines which donors are nodes.
struct FlowRegion
{
  const MismatchCells& Mismatches;
  /// Fragments of this rank whose donors are all nodes, ascending.
  std::vector<int> Divided;

  /// Returns whether a donor is a node.
  bool Holds(const Donor& donor) const;
  /// Returns whether all donors of a fragment are nodes.
  bool HoldsAll(int fragment) const;
};

/// Nodes of the graph on this rank: owned donors first, then copies of their neighbours. Grid and
/// donors must outlive this object.
class FlowNodes
{
public:
  /// Makes the nodes, and numbers their connected components over all ranks.
  /// @param links  links of all donors
  /// @pre Collective.
  FlowNodes(const CartesianGrid& grid, const FlowRegion& region, const DonorLinks& links,
    const DonorTable& donors, Ranks& ranks);
  FlowNodes(const FlowNodes&) = delete;
  FlowNodes& operator=(const FlowNodes&) = delete;

  /// Returns the graph. The caller sets its widths, which are 0.
  FlowGraph& Graph() { return this->TheGraph; }
  /// Returns the number of nodes that this rank owns.
  std::size_t Owned() const { return this->TheGraph.Nodes.size(); }
  /// Returns the number of nodes, copies included.
  std::size_t Count() const { return this->DonorOf.size(); }
  int DonorAt(std::size_t node) const { return this->DonorOf[node]; }
  /// Returns the node of a donor, or -1 if it is not a node.
  int NodeOf(int donor) const { return this->Numbers[donor]; }
  /// Returns the links between the donors of owned nodes and of copies.
  const DonorLinks& Links() const { return this->Ghosts; }

private:
  bool TouchesOwned(Index cell) const;
  void AddNode(int donor);
  std::vector<Index> FindNeighbours();
  Index IdOf(const Donor& donor) const;
  void NumberPieces(std::vector<Index> parent, Ranks& ranks);
  PiecePairs FindSame(const std::vector<Index>& pieceOf, const Ranks& ranks) const;

  const CartesianGrid& Grid;
  const DonorTable& Donors;
  const DonorLinks Ghosts;
  std::vector<int> Numbers; // node of each donor, or -1
  std::vector<int> DonorOf; // donor of each node
  FlowGraph TheGraph;
};

/// Returns the fragments of the donors of this rank whose donors near mismatch cells form several
/// connected components, ascending.
/// @pre Collective.
std::vector<int> FindDivided(const CartesianGrid& grid, const MismatchCells& mismatches,
  const DonorLinks& links, const DonorTable& donors, Ranks& ranks);

} // namespace vfm
