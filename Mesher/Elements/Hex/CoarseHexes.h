/**
 * CoarseHexes: the coarser cells and the transition hexes of a refined grid, which are all hexes
 * outside the finest cells. Each hex lies in a cell of its level and has the label of that cell.
 * Where interfaces cross such hexes, they are split like finest cells (SplitNodes.h): the hex
 * itself on inner points, and a buffer hex on each face towards another label.
 *
 * They are made for the owned base cells and the cells around them; at the end a rank keeps only
 * its own (KeepOwned). Points and hexes follow the finest cells, sorted by their keys in
 * OctreeKeys; ids ascend among the owned ones.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Hex/SplitNodes.h"
#include "Elements/Mesh.h"
#include "Labels/NarrowVoid.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

/// Coarse hexes of the owned base cells and their neighbours. Refers to the grid and the labels,
/// which must outlive it. Not thread safe.
class CoarseHexes
{
public:
  struct Options
  {
    bool MeshVoid = false; ///< makes hexes of label 0
    /// Splits hexes on interfaces; otherwise interfaces run between unsplit hexes.
    bool HasBuffers = true;
    /// Void cells whose hexes are made as a barrier; must outlive the hexes.
    const NarrowVoid* Narrow = nullptr;
  };

  /// Numbers points and hexes. A grid without refinements has no coarse hexes. If BadFamilies is
  /// not empty on any rank, no valid mesh can start before these families are refined. Stores
  /// references to grid and labels.
  /// @param refined  hexes of the base cells of RegionOf(grid), without the finest ones
  /// @param badCells  cells whose hexes are not positive
  CoarseHexes(const RefinedGrid& grid, const LabelArray& labels, const Options& options,
    RefinedMesh refined = {}, const std::vector<OctreeKeys::LevelIndex>& badCells = {});
  /// Returns the base cells whose hexes are made.
  static IndexBox RegionOf(const RefinedGrid& grid)
  {
    return grid.Base().Extended(grid.HasFineInterfaces() ? 1 : 2);
  }

  const RefinedGrid& Levels() const { return this->Grid; }
  /// Returns the families per refinement, in any order, whose refinement owned cells request
  /// because hexes there are not positive.
  const std::vector<std::vector<Index>>& BadFamilies() const { return this->Bad; }
  /// Returns the refined mesh from which the hexes are made. After Fill it has only keys
  /// and anchors of the points, and the touched cells.
  const RefinedMesh& Refined() const { return this->TheRefined; }
  /// Returns the number of points that no finest cell of HexBox has.
  Index NumberOfPoints() const { return this->PointCount; }
  Index NumberOfHexes() const { return this->HexCount; }

  /// Mesh points of the nodes of finest cells, by linear index of the node.
  struct FinePoints
  {
    std::function<Index(Index node)> First;            ///< only point, or point on the interface
    std::function<Index(Index node, int label)> Inner; ///< point of the hexes of a label
  };

  /// Returns the node of a level with which a point of the mesh moves: its own node for points that
  /// only finest cells share, otherwise the node from which it stems (RefinedMesh::Anchors).
  OctreeKeys::LevelIndex AnchorOf(const Mesh& mesh, Index pointId) const;

  /// Returns the interfaces through these hexes; empty if all cells at interfaces are finest ones.
  const SplitNodes& Splits() const { return this->TheSplits; }
  /// Returns the mesh index of point S of each split node, which its points I follow; -1 if it is
  /// not a point of the mesh.
  /// @pre Fill was called.
  const std::vector<Index>& SplitPoints() const { return this->SplitPoint; }

  /// Writes points, hexes, their ids and materials into a mesh. Only one call is possible, because
  /// it frees what it has written.
  /// @param[in,out] mesh  mesh with the finest cells and enough space
  /// @param firstPoint,firstHex  first indices to write
  void Fill(Mesh& mesh, Index firstPoint, Index firstHex, const FinePoints& finePoints);

private:
  static constexpr int Unused = -1, Used = -2, Fine = -3;

  /// Corner of a hex; corners are numbered by bits.
  struct Corner
  {
    int* Number; // index of the point, or Unused, Used, Fine
    OctreeKeys::LevelIndex Node;
    Index Key;
  };
  class Writer;

  bool IsRequested(const OctreeKeys::LevelIndex& cell) const;
  bool HasHexes(const OctreeKeys::LevelIndex& cell) const;
  /// Returns the number of the split node with a key, or -1.
  Index FindSplit(Index key) const { return this->TheSplits.Find(key); }
  /// Returns the faces of a hex (bits) that have buffer hexes.
  int BufferFaces(Index hexKey) const
  {
    return this->HasBuffers ? this->TheSplits.FacesOfHex(hexKey) : 0;
  }
  int CountPoints(Index key) const;
  bool IsPointOfFine(const OctreeKeys::LevelIndex& node) const;
  /// Returns the linear index of a node in the finest grid.
  Index FinestNode(const OctreeKeys::LevelIndex& node) const
  {
    return this->Grid.Finest().Linear(this->Grid.FinestNode(node.Level, node.At));
  }
  void FindBadFamilies(const std::vector<OctreeKeys::LevelIndex>& badCells);
  void SetFinePoints(Mesh& mesh, const FinePoints& finePoints);
  int& NumberOf(Index point, const OctreeKeys::LevelIndex& index);
  void DropParts();
  void MarkPoints();
  void NumberPoints();
  template <class Visitor>
  void ForHexes(const Visitor& visit);
  template <class Visitor>
  void ForPoints(const Visitor& visit);

  const RefinedGrid& Grid;
  const LabelArray& Labels;
  bool MeshVoid;
  const NarrowVoid* Narrow;
  bool HasBuffers;
  IndexBox Region;                      // base cells whose hexes are made
  RefinedMesh TheRefined;               // mesh without the finest cells, but with all other hexes
  std::vector<unsigned char> Requested; // whether each hex of TheRefined is made
  Buffer<int> NodeNumber;               // Corner::Number of each base node
  std::vector<int> PointNumber;         // Corner::Number of all other points of TheRefined
  SplitNodes TheSplits;
  std::vector<std::vector<Index>> Bad;
  std::vector<Index> SplitPoint;
  Index PointCount = 0, HexCount = 0;
};

} // namespace vfm
