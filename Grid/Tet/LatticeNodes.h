/**
 * LatticeNodes: the labels of the nodes of the body-centred lattice, and which of them are snapped.
 *
 * A node is a vertex of the grid or the centre of a cell. The fractions of a centre are those of its cell, the
 * fractions of a vertex the mean of its eight cells (clamped at the domain). Void where void is more than
 * 1 - isoValue, else the material of the largest fraction, ties to the smaller.
 *
 * A node is snapped when an interface passes near to it: on some edge to a node of another label, not snapped, the
 * interface lies within the first 45 % (vertex to centre) or 30 % (along an axis). A snapped node has no
 * label: the interface may run through it, and lattice tets around it need fewer cuts. Nodes become snapped in
 * four passes: even cells, odd cells, even vertices, odd vertices (parity of i + j + k). No two nodes of
 * one pass share a lattice edge, so the result depends on neither order nor ranks.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionSum.h"

namespace vfm
{

class LatticeNodes
{
public:
  /// What stands for the label of snapped nodes, and of nodes outside the domain.
  static constexpr int Snapped = -1;
  enum Kind
  {
    Vertex,
    Centre
  };
  struct Node
  {
    Kind Type;
    Index3 Position; ///< (i,j,k) of the vertex or of the cell
  };

  LatticeNodes(
    const CartesianGrid& grid, const FractionField& fractions, double isoValue, Runtime& runtime);

  /// Labels by linear index of the grid. Valid on the cells of CartesianGrid::HexBox and their vertices.
  const int* Labels(Kind kind) const { return this->Label[kind].data(); }

  /// Takes a node of HexBox out of the snapped: it gets its label.
  void Unsnap(const Node& node);

  /// The label by the mean of the fractions of four nodes.
  int LabelOfMean(const std::array<Node, 4>& nodes) const;

private:
  void LabelCentres(Index j, Index k);
  void LabelVertices(const IndexBox& box, Index j, Index k);
  std::array<Index, 8> StarOf(const Index3& vertex) const;
  void AddParts(const Node& node, double weight, FractionSum& sum) const;
  double Fraction(const Node& node, int material) const;
  double Lead(const Node& node, int label, int other) const;
  void Snap(Kind kind, int parity, int level);
  bool IsNearInterface(const Node& node, Index n) const;

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  double IsoValue;
  Runtime& Run;
  std::array<std::vector<int, LargeAllocator<int>>, 2> Label; // of each kind
};

} // namespace vfm
