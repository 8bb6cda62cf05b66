/**
 * The nodes of a graph joined to blocks: what flows between blocks in all is found at once, so that a solver of the whole graph is left
 * with what is near.
 *
 * Every rank holds all blocks and their factors, some thousand. Their matrix and what they sum are integers: the same bits on any ranks.
 */
#pragma once

#include "Transfer/PotentialFlow.h"

#include <Eigen/SparseCholesky>

namespace vfm
{

class CoarseGraph
{
public:
  /// Collective.
  CoarseGraph(const FlowGraph& graph, Ranks& ranks);

  int NumberOfBlocks() const { return this->Blocks; }
  /// Of a node of this rank.
  int BlockOf(Index node) const { return this->BlockOfNode[node]; }
  /// The potential of all blocks that some excess of theirs has.
  const Eigen::VectorXd& Solve(Eigen::VectorXd excess);

private:
  void Number(const FlowGraph& graph, Ranks& ranks);
  void MakeMatrix(const FlowGraph& graph, Ranks& ranks);

  void Centre(Eigen::VectorXd& values) const;

  int Blocks = 0;
  std::vector<Index> Pieces;    // the first block of each connected part, and the end
  std::vector<int> BlockOfNode; // copies too
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Factors;
  Eigen::VectorXd Potential;
};

} // namespace vfm
