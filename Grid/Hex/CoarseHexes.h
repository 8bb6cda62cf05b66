/**
 * CoarseHexes: the hexes of a refined grid that are no finest cells: coarser cells, and transition hexes between levels.
 * Each lies in a cell of its level, and has the label of that cell. Where interfaces run through them they are split as
 * finest cells are (SplitNodes.h): the hex itself on inner points, and a buffer hex on each face towards another label.
 *
 * Made for the owned base cells and those around them; a rank keeps its own at the end (KeepOwned).
 * Order: points and hexes by their keys in OctreeKeys, after those of the finest cells; ids ascend among the owned.
 */
#pragma once

#include "Base/Runtime.h"
#include "Hex/SplitNodes.h"
#include "Labels/Labels.h"
#include "Mesh/Mesh.h"
#include "Octree/RefinedGrid.h"

namespace vfm
{

class CoarseHexes
{
public:
  struct Options
  {
    bool MeshVoid = false;  ///< else there are no hexes of label 0
    bool AsCubes = false;   ///< smooths transitions as if all cells were cubes (SmoothTransitions)
    bool HasBuffers = true; ///< splits hexes on interfaces; else these run between unsplit ones
  };

  /// Makes and smooths the transitions; of a grid without refinements there are no coarse hexes. Where BadFamilies of any rank
  /// tells of some these want to be refined first: no valid mesh starts. Collective. Throws InputError as SmoothTransitions does.
  CoarseHexes(
    const RefinedGrid& grid, const LabelArray& labels, const Options& options, Runtime& runtime);

  const RefinedGrid& Levels() const { return this->Grid; }
  /// Families that owned cells want to refine because hexes there are not positive: of each refinement, in any order.
  const std::vector<std::vector<Index>>& BadFamilies() const { return this->Bad; }
  /// What they are made of; once they are written only the keys and anchors of the points, and the touched cells.
  const RefinedMesh& Refined() const { return this->TheRefined; }
  /// Of those that no finest cell of HexBox has.
  Index NumberOfPoints() const { return this->PointCount; }
  Index NumberOfHexes() const { return this->HexCount; }

  /// Which mesh points the nodes of finest cells have; nodes by linear index.
  struct FinePoints
  {
    std::function<Index(Index node)> First;            ///< the only one, or the one on interfaces
    std::function<Index(Index node, int label)> Inner; ///< the one that hexes of a label have
  };

  /// The node of a level that a point of a mesh of these and the finest hexes moves with: of finest cells alone its own, else the one that
  /// it stems from (RefinedMesh::Anchors).
  OctreeKeys::LevelIndex AnchorOf(const Mesh& mesh, Index pointId) const;

  /// Interfaces through these hexes; none where all cells at interfaces are finest ones.
  const SplitNodes& Splits() const { return this->TheSplits; }
  /// Once they are written: the index in the mesh of the point S of each split node, its I follow; -1 where it is no point.
  const std::vector<Index>& SplitPoints() const { return this->SplitPoint; }

  /// Writes points, hexes, their ids and materials into a mesh, from those positions on. To be called once, as it drops what it
  /// has written.
  void Fill(Mesh& mesh, Index firstPoint, Index firstHex, const FinePoints& finePoints);

  using PointVisitor = std::function<void(Index key, const Vector3& x)>;
  using HexVisitor = std::function<void(
    Index key, const OctreeKeys::LevelIndex& cell, int label, const std::array<Index, 8>& corners)>;
  /// Instead of Fill, of hexes that are not split: gives points and hexes one by one. corners: numbered by bits, positions in the
  /// order of the points, or ~(linear index) of a node that a finest cell has.
  void Visit(const PointVisitor& onPoint, const HexVisitor& onHex);

private:
  static constexpr int Unused = -1, Used = -2, Fine = -3;

  /// Of a hex, numbered by bits.
  struct Corner
  {
    int* Number; // index of the point, or what it is
    OctreeKeys::LevelIndex Node;
    Index Key;
  };
  class Writer;

  bool IsRequested(const OctreeKeys::LevelIndex& cell) const;
  /// The number of the split node with a key, or -1.
  Index FindSplit(Index key) const { return this->TheSplits.Find(key); }
  /// Bits of the faces of a hex that have buffer hexes.
  int BufferFaces(Index hexKey) const
  {
    return this->HasBuffers ? this->TheSplits.FacesOfHex(hexKey) : 0;
  }
  int CountPoints(Index key) const;
  bool IsPointOfFine(const OctreeKeys::LevelIndex& node) const;
  /// Linear index of the finest grid.
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
  bool HasBuffers;
  IndexBox Region;                      // base cells whose hexes are made
  RefinedMesh TheRefined;               // without the finest cells; wanted or not
  std::vector<unsigned char> Requested; // of each hex of TheRefined
  Buffer<int> NodeNumber;               // of base nodes: index of the point, or what it is
  std::vector<int> PointNumber;         // of points of TheRefined that are no base nodes
  SplitNodes TheSplits;
  std::vector<std::vector<Index>> Bad;
  std::vector<Index> SplitPoint;
  Index PointCount = 0, HexCount = 0;
};

} // namespace vfm
