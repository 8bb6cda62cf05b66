/**
 * LatticeNodes: labels the nodes of the body-centred lattice and determines which are snapped.
 *
 * A node is a vertex of the grid or the centre of a cell. A centre has the fractions of its cell; a
 * vertex has the mean of its eight cells, clamped at the domain boundary. The label is void if the
 * fraction of void exceeds 1 - isoValue, else the material with the largest fraction; ties go to
 * the smaller number.
 *
 * A node is snapped if an interface is near. This means: on an edge to a node that has another
 * label and is not snapped, the interface is within the first 45 % (edges between vertex and
 * centre) or 30 % (edges along an axis). A snapped node has no label. The interface may run through
 * it, so the lattice tets around it need fewer cuts. Nodes are snapped in four passes: even cells,
 * odd cells, even vertices, odd vertices (parity of i + j + k). No two nodes of one pass share a
 * lattice edge, so the result does not depend on order or ranks.
 *
 * Snapping follows F. Labelle and J. R. Shewchuk, Isosurface stuffing, ACM Transactions on Graphics
 * 26 (2007), extended to several labels.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionSum.h"

namespace vfm
{

/// Labels of the nodes in and around CartesianGrid::HexBox. Only Unsnap changes them. Grid,
/// fractions and runtime must outlive this object.
class LatticeNodes
{
public:
  /// Replaces the label of snapped nodes and of nodes outside the domain.
  static constexpr int Snapped = -1;
  enum Kind
  {
    Vertex,
    Centre
  };
  struct Node
  {
    Kind Type;
    Index3 Position; ///< (i,j,k) of the vertex or the cell
  };

  /// Labels and snaps the nodes.
  /// @param isoValue  limit of void, in (0,1): a node is void if its materials fill less
  LatticeNodes(
    const CartesianGrid& grid, const FractionField& fractions, double isoValue, Runtime& runtime);

  /// Returns labels by linear index of the grid. Valid for the cells of CartesianGrid::HexBox and
  /// their vertices.
  const int* Labels(Kind kind) const { return this->Label[kind].data(); }

  /// Gives a snapped node of HexBox the label of its fractions.
  void Unsnap(const Node& node);

  /// Returns the label of the mean of the fractions of four nodes.
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
  std::array<std::vector<int, LargeAllocator<int>>, 2> Label; // one array per kind
};

} // namespace vfm
