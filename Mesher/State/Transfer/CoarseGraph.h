/**
 * CoarseGraph: the coarse level of the solver in PotentialFlow.h. Nodes are grouped into blocks,
 * and the total flows between blocks are found directly. The iterations on the whole graph then
 * only have to find local flows.
 */
#pragma once

#include "State/Transfer/PotentialFlow.h"

#include <Eigen/SparseCholesky>

namespace vfm
{

/// Blocks of the nodes of a graph. Every rank stores all blocks of all ranks, up to some thousand,
/// and the factors of their matrix. Widths are summed as integers, so results are bitwise identical
/// on any number of ranks.
class CoarseGraph
{
public:
  /// Makes the blocks and factorises their matrix. Does not keep the graph.
  /// @pre Collective.
  CoarseGraph(const FlowGraph& graph, Ranks& ranks);

  int NumberOfBlocks() const { return this->Blocks; }
  /// Returns the block of a node, owned or copy.
  int BlockOf(Index node) const { return this->BlockOfNode[node]; }
  /// Returns the potential of all blocks for an excess of each block. The mean excess of each
  /// connected component is ignored.
  const Eigen::VectorXd& Solve(Eigen::VectorXd excess);

private:
  void Number(const FlowGraph& graph, Ranks& ranks);
  void MakeMatrix(const FlowGraph& graph, Ranks& ranks);

  void Centre(Eigen::VectorXd& values) const;

  int Blocks = 0;
  std::vector<Index> Pieces;    // first block of each connected component, and the end
  std::vector<int> BlockOfNode; // block of each node, owned or copy
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Factors;
  Eigen::VectorXd Potential;
};

} // namespace vfm
