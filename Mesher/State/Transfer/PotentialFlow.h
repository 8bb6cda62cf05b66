/**
 * PotentialFlow: finds the volumes that must flow between neighbours on a graph to remove the
 * excess of each node. They are differences of a potential phi with L phi = excess, where L is the
 * Laplacian of the graph.
 */
#pragma once

#include "Base/Runtime.h"
#include "Labels/FragmentShare.h"
#include "State/Transfer/Donors.h"

#include <functional>

namespace vfm
{

/// Node of the graph, with neighbours across the six faces of its cell.
struct FlowNode
{
  std::array<int, 6> Others{}; ///< neighbour per face; any node, such as itself, if there is none
  std::array<double, 6> Widths{}; ///< weight of the edge to each neighbour; 0 if there is none
};

struct FlowGraph
{
  std::vector<FlowNode> Nodes; ///< nodes of this rank
  std::vector<Index3> Places;  ///< cell (i,j,k) in the domain of each node and copy
  std::vector<int> Pieces; ///< connected component, as numbered on this rank, of each node and copy
  FragmentShare Components; ///< connected components of this rank; their materials are fragments
  int Copies = 0;           ///< number of copies, nodes of other ranks, which follow
  /// Sets the values at copies to the values of their owners. Collective among peers.
  std::function<void(std::vector<double>&)> Update;
};

/// Returns the potential of all nodes, copies too. The volume Widths * (phi - phi of the other)
/// flows out of a node across a face.
/// Conjugate gradients, preconditioned by the diagonal and by CoarseGraph, until only rounding
/// remains. Sums are of integers, so results are bitwise identical on any number of ranks.
/// @param excess  volume that must flow out of each node of this rank; the sum over each connected
/// component is 0
/// @param sizes  volume of the cell of each node, relative to which residuals are measured
/// @pre Collective.
std::vector<double> FindPotential(const FlowGraph& graph, std::vector<double> excess,
  const std::vector<double>& sizes, Runtime& runtime);

} // namespace vfm
