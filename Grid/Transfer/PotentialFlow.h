/**
 * Volumes that flow between neighbours on a graph until what each has too much is gone: L phi = excess, with the Laplacian of the graph.
 */
#pragma once

#include "Base/Runtime.h"
#include "Transfer/Donors.h"

#include <functional>

namespace vfm
{

/// A node of the graph: to which others, across the faces of its cell, and how wide the ways are.
struct FlowNode
{
  std::array<int, 6> Others{};    ///< by face; where there is none any, such as the node itself
  std::array<double, 6> Widths{}; ///< 0 where there is none
};

struct FlowGraph
{
  std::vector<FlowNode> Nodes; ///< of this rank
  std::vector<Index3> Places;  ///< of these in the whole grid
  std::vector<int> Pieces;     ///< of these: the connected part, over all ranks
  int Copies = 0;              ///< nodes of other ranks, numbered after these
  /// Sets the entries of the copies to those of their owners. Collective.
  std::function<void(std::vector<double>&)> Update;
};

/// The potential at all nodes, copies too: volumes Widths x (phi - phi of the other) flow out. excess: of the nodes of this rank; zero in
/// the sum over each connected part. sizes: volumes of their cells, to tell what is small. Conjugate gradients, until only rounding is
/// left. Collective; the same bits on any ranks.
std::vector<double> FindPotential(const FlowGraph& graph, std::vector<double> excess,
  const std::vector<double>& sizes, Runtime& runtime);

} // namespace vfm
