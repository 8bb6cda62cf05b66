/**
 * CoarseGraph: the coarse level of the solver in PotentialFlow.h. Nodes are grouped into blocks,
 * and the total flows between blocks are found directly. The iterations on the whole graph then
 * only have to find local flows.
 *
 * Connected components do not depend on each other. Each has blocks of its own size and a matrix of
 * its own. A component of one rank is solved there, a component of several ranks on one of all
 * ranks, its home: sums go to the home and potentials come back (KeyMerge.h).
 */
#pragma once

#include "State/Transfer/PotentialFlow.h"

#include <Eigen/SparseCholesky>

#include <memory>

namespace vfm
{

/// Block of nodes: number of the connected component over all ranks, position in blocks.
using BlockName = std::array<Index, 4>;

/// Total width of the edges from one block to another, in integer units.
struct BlockLink
{
  int From, To;
  std::int64_t Width;
};

/// Factors of the matrices of connected components.
class BlockSystems
{
public:
  /// Factorises the matrices.
  /// @param names  names of all blocks of the components, ascending
  /// @param links  one in each direction; blocks by their positions in `names`
  /// @param unit  value of a width of 1
  /// @param widest  largest width of an edge
  void Make(
    const std::vector<BlockName>& names, std::vector<BlockLink> links, double unit, double widest);
  /// Replaces the excess of each block by its potential. The mean excess of each component is
  /// ignored: due to rounding, it cannot flow anywhere.
  void Solve(std::vector<double>& values) const;

private:
  struct System
  {
    std::size_t First, Count; // blocks
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Factors;
  };
  std::vector<std::unique_ptr<System>> Systems; // of components of several blocks
};

/// Blocks of the nodes of a graph. A rank stores the blocks of its nodes and copies, and the blocks
/// and factors of the components of which it is the home. Widths are summed as integers, and the
/// blocks of a component do not depend on others, so results are bitwise identical on any number of
/// ranks.
class CoarseGraph
{
public:
  /// Makes the blocks and factorises the matrices. Does not keep the graph.
  /// @pre Collective.
  CoarseGraph(const FlowGraph& graph, Ranks& ranks);

  /// Returns the number of blocks of nodes of this rank, owned or copies.
  int NumberOfBlocks() const { return static_cast<int>(this->Names.size()); }
  /// Returns the block of a node, owned or copy.
  int BlockOf(Index node) const { return this->BlockOfNode[node]; }
  /// Returns the potential of the blocks of this rank.
  /// @param excess  excess of each block, in integer units, as far as it is due to nodes of this
  ///   rank
  /// @param unit  value of an excess of 1
  /// @pre Collective.
  std::vector<double> Solve(const std::vector<std::int64_t>& excess, double unit) const;

private:
  void Number(const FlowGraph& graph, Ranks& ranks);
  bool MakeBlocks(const FlowGraph& graph, std::vector<Index>& sizes, Ranks& ranks);
  std::vector<BlockLink> FindLinks(const FlowGraph& graph, double unit) const;
  void MakeSystems(const FlowGraph& graph, Ranks& ranks);
  void MakeSystemsAtHome(
    const std::vector<BlockLink>& links, double unit, double widest, Ranks& ranks);

  std::vector<BlockName> Names;  // of the blocks of this rank, ascending
  std::vector<int> BlockOfNode;  // block of each node, owned or copy
  std::vector<int> SharedBlocks; // blocks of components of several ranks
  std::vector<int> LocalBlocks;  // the other blocks
  KeyMerge<BlockName> Ways;      // of SharedBlocks
  bool HasShared = false;        // whether any rank has shared blocks
  BlockSystems Local, AtHome;
};

} // namespace vfm
