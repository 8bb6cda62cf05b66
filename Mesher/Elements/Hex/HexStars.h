/**
 * HexStars: the nodes of a refined grid where labels meet, and the hexes at each. Nodes that only
 * finest cells share are left out.
 */
#pragma once

#include "Labels/Labels.h"
#include "Octree/RefinedGrid.h"
#include "Octree/TwoRefinement.h"

namespace vfm
{

/// Label of cells that are too far away to be known.
constexpr int UnknownLabel = -1;

/// Returns the label of a leaf, the cell that a hex is or lies in; UnknownLabel if it is outside
/// the local box.
int LabelOfLeaf(
  const RefinedGrid& grid, const LabelArray& labels, const OctreeKeys::LevelIndex& cell);

/// Nodes with several labels around them, with their hexes. Refers to grid, refined mesh and
/// labels, which must outlive it.
class HexStars
{
public:
  /// Finds the nodes and their hexes. Stores references to grid, refined and labels. The arguments
  /// are explained at FindSplitNodes.
  HexStars(const RefinedGrid& grid, const RefinedMesh& refined, const IndexBox& region,
    const LabelArray& labels);

  enum class Kind
  {
    Refined, ///< hex of the refined mesh
    Base,    ///< untouched base cell
    Fine     ///< finest cell
  };
  /// Where a hex is, and its label.
  struct HexPlace
  {
    OctreeKeys::LevelIndex Cell; ///< cell that the hex is or lies in
    Index HexKey;                ///< OctreeKeys::HexKey, or -1 for a finest cell
    int Label;
  };
  struct Hex
  {
    Kind What;
    Index Id; ///< index of the hex, or key of the cell
    HexPlace Place;
  };
  struct Corner
  {
    Index Node; ///< number of the node
    Index Hex;  ///< index of the hex
    int Bits;
  };
  using Star = std::vector<Corner>;

  /// Returns the keys of the nodes (OctreeKeys::NodeOfKey), ascending. The number of a node is its
  /// index here.
  const std::vector<Index>& Nodes() const { return this->Keys; }
  /// Returns the number of the node with a key, or -1.
  Index Find(Index key) const;
  /// Returns the hexes that have such a node.
  const std::vector<Hex>& Hexes() const { return this->TheHexes; }
  /// Returns the corners at a node, by hex.
  Star StarOf(Index n) const
  {
    return Star(this->Corners.begin() + this->Begin[n], this->Corners.begin() + this->Begin[n + 1]);
  }

  /// Return key and position (length units of the grid) of a corner of a hex.
  Index KeyAt(const Hex& hex, int corner) const;
  Vector3 PointAt(const Hex& hex, int corner) const;
  /// Returns the widths of the smallest hexes at a node.
  Vector3 WidthsAt(const Star& star) const;
  /// Returns the sides of the domain on which a node lies: bit f is set for side f.
  int DomainSides(Index n) const;

private:
  static constexpr Index HexSlots = OctreeKeys::HexSlots;

  void FindNodes();
  void CompareBaseCells(std::vector<int>& least, std::vector<int>& most);
  void GatherHexes();
  void AddCells(Kind kind, int level, const Index3& node, std::vector<Index>& cells) const;
  Hex MakeHex(Kind kind, Index id) const;
  void LinkHexes();
  bool IsBaseTouched(const Index3& cell) const
  {
    return this->IsTouched[IndexInBox(this->Region, cell)];
  }
  bool IsFineCell(const Index3& cell) const
  {
    return this->Grid.Finest().Local().Contains(cell) && this->Grid.IsFine(cell);
  }

  const RefinedGrid& Grid;
  const OctreeKeys& Lattice;
  const RefinedMesh& Refined;
  const IndexBox Region;
  const LabelArray& Labels;
  std::vector<bool> IsTouched; // whether each base cell of Region is touched
  std::vector<Index> Keys;
  std::vector<Hex> TheHexes;
  std::vector<Corner> Corners; // sorted by node
  std::vector<Index> Begin;    // first corner of each node, and the end
};

} // namespace vfm
