/**
 * HexStars: the nodes of a refined grid with several labels around them that are no nodes of finest cells alone, and the hexes at each.
 */
#pragma once

#include "Labels/Labels.h"
#include "Octree/RefinedGrid.h"
#include "Octree/TwoRefinement.h"

namespace vfm
{

/// Where a label is too far away to be known.
constexpr int UnknownLabel = -1;

/// The label of a leaf, or of a cell that a hex of it lies in.
int LabelOfLeaf(
  const RefinedGrid& grid, const LabelArray& labels, const OctreeKeys::LevelIndex& cell);

class HexStars
{
public:
  /// As in SplitNodes. Keeps references.
  HexStars(const RefinedGrid& grid, const RefinedMesh& refined, const IndexBox& region,
    const LabelArray& labels);

  enum class Kind
  {
    Refined, ///< a hex of the refined mesh
    Base,    ///< an untouched base cell
    Fine     ///< a finest cell
  };
  /// What a face of a hex has on one side.
  struct Side
  {
    OctreeKeys::LevelIndex Cell; ///< that the hex is, or lies in
    Index HexKey;                ///< OctreeKeys::HexKey; -1: a finest cell
    int Label;
  };
  struct Hex
  {
    Kind What;
    Index Id; ///< index of the hex, or key of the cell
    HexStars::Side Side;
  };
  struct Corner
  {
    Index Node; ///< its number
    Index Hex;  ///< index
    int Bits;
  };
  using Star = std::vector<Corner>;

  /// Keys of the nodes (OctreeKeys::NodeOfKey), ascending; they are numbered by their place.
  const std::vector<Index>& Nodes() const { return this->Keys; }
  /// The number of the node with a key, or -1.
  Index Find(Index key) const;
  /// The hexes with such a node.
  const std::vector<Hex>& Hexes() const { return this->TheHexes; }
  /// The corners at a node, by hex.
  Star StarOf(Index n) const
  {
    return Star(this->Corners.begin() + this->Begin[n], this->Corners.begin() + this->Begin[n + 1]);
  }

  /// Key and place (length units of the grid) of a corner of a hex.
  Index KeyAt(const Hex& hex, int corner) const;
  Vector3 PointAt(const Hex& hex, int corner) const;
  /// Of the smallest hexes at a node.
  Vector3 WidthsAt(const Star& star) const;
  /// Bit f set when a node lies on side f of the domain.
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
  std::vector<bool> IsTouched; // of the base cells of Region
  std::vector<Index> Keys;
  std::vector<Hex> TheHexes;
  std::vector<Corner> Corners; // by node
  std::vector<Index> Begin;    // of each node's corners, and the end
};

} // namespace vfm
