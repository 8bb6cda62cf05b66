/**
 * LatticeNodes: labels the nodes of the body-centred lattice and determines which are snapped.
 *
 * A node is a vertex of the grid or the centre of a cell. Labels of cells are the resolved labels
 * (ResolveLabels.h). The labels of nodes follow them, so the lattice has the fragments of the cells
 * and the same pairs of fragments touch:
 * - A centre has the label of its cell.
 * - A pure vertex, whose cells have one label, has this label. The label of a mixed vertex is the
 *   one with the largest mean fraction in its cells, if this label touches every other label
 *   around the vertex by a face. Else, and on the domain boundary or a flat seam, the vertex is
 *   snapped.
 *
 * A snapped node has no label. The interface may run through it, so the lattice tets around it need
 * fewer cuts. Other nodes are snapped if an interface is near. This means: on an edge to a node
 * that has another label and is not snapped, the interface is within the first 45 % (edges between
 * vertex and centre) or 30 % (edges along an axis). Centres of cells at the domain boundary, and
 * of thin cells, keep their labels. Nodes are snapped in four passes: even cells, odd cells, even
 * vertices, odd vertices (parity of i + j + k); in more passes on a grid with odd periods. No two
 * nodes of one pass share a lattice edge, so the result does not depend on order or ranks.
 *
 * A node is settled if it is as in the method Cells: a centre or pure vertex has its label, a mixed
 * vertex is snapped. LatticeRules.h and LatticeFaults.h list nodes to be settled.
 *
 * Snapping follows F. Labelle and J. R. Shewchuk, Isosurface stuffing, ACM Transactions on Graphics
 * 26 (2007), extended to several labels.
 */
#pragma once

#include "Base/Partition.h"
#include "Base/Runtime.h"
#include "Elements/Tet/TetTopology.h"
#include "Fractions/FractionSum.h"
#include "Labels/Labels.h"

namespace vfm
{

/// Labels of the nodes in and around CartesianGrid::HexBox. Only Settle changes them. The
/// constructor's arguments must outlive this object.
class LatticeNodes
{
public:
  /// Replaces the label of snapped nodes and of nodes outside the domain.
  static constexpr int Snapped = -1;
  enum Kind
  {
    Vertex = VertexSlot,
    Centre = CentreSlot
  };
  struct Node
  {
    Kind Type;
    Index3 Position; ///< (i,j,k) of the vertex or the cell
  };

  /// Labels and snaps the nodes.
  /// @param cells  resolved labels of the cells
  /// @param isoValue  limit of void, in (0,1): a node is void if its materials fill less
  /// @pre Collective among peers.
  LatticeNodes(const CartesianGrid& grid, const FractionField& fractions, const LabelArray& cells,
    double isoValue, const Partition& partition, Runtime& runtime);

  /// Returns labels by linear index of the grid. Valid for the cells of CartesianGrid::HexBox and
  /// their vertices.
  const int* Labels(Kind kind) const { return this->Label[kind].data(); }
  /// Returns the labels of the cells.
  const LabelArray& Cells() const { return this->CellLabels; }
  /// Returns the mixed vertices of the local box by linear index, ascending.
  const std::vector<Index>& MixedVertices() const { return this->Mixed; }
  /// Returns the fraction of a cell's label in the cell.
  double OwnFraction(Index cell) const
  {
    return this->Fractions.Fraction(cell, this->CellLabels[cell]);
  }

  /// Returns the id of the point at a node (TetTopology.h).
  Index IdOf(const Node& node) const
  {
    return TetIds.PointSlots * this->Grid.NodeKey(node.Position) + node.Type + 1;
  }
  /// Settles nodes on all ranks that have them.
  /// @param ids  nodes within three cells of the owned cells; IdOf
  /// @return whether any node was not settled before, on any rank
  /// @pre Collective.
  bool Settle(const std::vector<Index>& ids, const Partition& partition);

private:
  void LabelCentres(Index j, Index k);
  void LabelVertices(const IndexBox& box);
  int LabelOfMixed(const Index3& vertex) const;
  int SettledLabel(const Node& node) const;
  bool SettleHere(Index id, const Index3& shift);
  std::array<Index, 8> StarOf(const Index3& vertex) const;
  double Fraction(const Node& node, int material) const;
  double Lead(const Node& node, int label, int other) const;
  bool MaySnap(const Node& node, Index n) const;
  void Snap(Kind kind, int current, const IndexBox& cells);
  bool HasOddPeriods() const { return this->Grid.NumberOfColours() > 8; }
  int ClassOf(const Index3& position) const;
  bool IsNearInterface(const Node& node, Index n) const;

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const LabelArray& CellLabels;
  double IsoValue;
  Runtime& Run;
  std::vector<Index> Mixed;
  std::array<std::vector<int, LargeAllocator<int>>, 2> Label; // one array per kind
};

} // namespace vfm
