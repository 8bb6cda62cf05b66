/**
 * SplitNodes: where interfaces run through coarser cells and transitions of a refined grid (LevelPlan::FineInterfaces false).
 *
 * A node of the hexes with several labels around it is split, as a mixed grid node is (HexTopology.h): into a surface point S at
 * its place, and an inner point I for each label around it. In a regular star the label condition says where each I may
 * stand; in an irregular one that is tested: the corner normals of a label's interface faces at the node, outward, must have
 * a common visible direction d, all n.d > 0. Then S - t d is inside the label for small t. d is the direction of the point of the
 * normals' convex hull nearest to 0, which makes the smallest n.d as large as can be.
 *
 * Where there is none, or a hex at such a node would not be positive everywhere, the leaves around want to be refined: in
 * cells that are fine all around the label condition holds, so this ends.
 */
#pragma once

#include "Hex/HexStars.h"

namespace vfm
{

struct SplitNodes
{
  using Side = HexStars::Side;
  /// A face between two labels; not both sides are finest cells.
  struct Face
  {
    /// Numbers of split nodes, around it; the normal points out of the first side.
    std::array<Index, 4> Nodes;
    std::array<Side, 2> Sides; ///< the first has the smaller label
  };

  std::vector<Index> Keys; ///< of the nodes (OctreeKeys::NodeOfKey), ascending
  std::vector<Index> LabelOffset{ 0 };
  std::vector<int> Labels;    ///< around the nodes, ascending: those of n from LabelOffset[n] on
  std::vector<Vector3> Inner; ///< of each label: where its I starts, length units of the grid
  std::vector<Face> Faces;
  /// Key and faces of hexes of the refined mesh and of untouched base cells, ascending: bit f set when face f (-x +x -y +y -z +z) is on an
  /// interface.
  std::vector<std::pair<Index, int>> HexFaces;
  /// Families that owned cells want to refine because no valid mesh would start there: of each refinement, ascending.
  std::vector<std::vector<Index>> BadFamilies;

  Index Count() const { return static_cast<Index>(this->Keys.size()); }
  /// The number of the node with a key, or -1 where it is not split.
  Index Find(Index key) const;
  /// The labels around a node, ascending.
  const int* LabelsBegin(Index n) const { return this->Labels.data() + this->LabelOffset[n]; }
  const int* LabelsEnd(Index n) const { return this->Labels.data() + this->LabelOffset[n + 1]; }
  /// Position of a label among them.
  int RankOf(Index n, int label) const;
  const Vector3& InnerPoint(Index n, int rank) const
  {
    return this->Inner[this->LabelOffset[n] + rank];
  }
  /// The faces of HexFaces of a hex.
  int FacesOfHex(Index hexKey) const;
};

/// refined: the hexes of the base cells of region, without the finest ones. labels: of the finest grid, alike in each leaf.
SplitNodes FindSplitNodes(const RefinedGrid& grid, const RefinedMesh& refined,
  const IndexBox& region, const LabelArray& labels, bool meshVoid);

} // namespace vfm
