/**
 * SplitNodes: the interfaces through coarser cells and transitions of a refined grid
 * (LevelPlan::FineInterfaces false).
 *
 * A node of such hexes with several labels around it is split like a mixed grid node
 * (HexTopology.h). It becomes a surface point S at its position and an inner point I per label
 * around it. In a regular star, the label condition gives the position of each I. In an irregular
 * star, this is tested: the outward normals n of a label's interface faces at the node must have a
 * common visible direction d, with all n.d > 0. S - t d is then inside the label for small t. d is
 * the direction of the point nearest to 0 in the convex hull of the normals, which maximises the
 * smallest n.d.
 *
 * If there is no such direction, or a hex at such a node would not be positive everywhere,
 * refinement of the leaves around it is requested. This ends, because the label condition holds in
 * cells that are fine all around.
 */
#pragma once

#include "Elements/Hex/HexStars.h"

#include <functional>

namespace vfm
{

/// Split nodes, their labels, inner points and faces.
struct SplitNodes
{
  /// Face between two labels; at most one side is a finest cell.
  struct InterfaceQuad
  {
    /// Numbers of split nodes in circular order; the normal points out of the first side.
    std::array<Index, 4> Nodes;
    /// The first side has the smaller label.
    std::array<HexStars::HexPlace, 2> Sides;
  };

  std::vector<Index> Keys; ///< keys of the nodes (OctreeKeys::NodeOfKey), ascending
  std::vector<Index> LabelOffset{ 0 };
  /// Labels around the nodes, ascending at each node; node n starts at LabelOffset[n].
  std::vector<int> Labels;
  /// Whether each label has a point I, because a cell of it at the node has hexes.
  std::vector<unsigned char> HasPoint;
  /// Initial position of point I of each label, length units of the grid.
  std::vector<Vector3> Inner;
  std::vector<InterfaceQuad> Faces;
  /// Keys, ascending, and faces of hexes of the refined mesh and of untouched base cells: bit f is
  /// set if face f (-x +x -y +y -z +z) is on an interface.
  std::vector<std::pair<Index, int>> HexFaces;
  /// Families per refinement, ascending, whose refinement owned cells request because no valid mesh
  /// would start there.
  std::vector<std::vector<Index>> BadFamilies;

  Index Count() const { return static_cast<Index>(this->Keys.size()); }
  /// Returns the number of the node with a key, or -1 if it is not split.
  Index Find(Index key) const;
  /// Return the range of the labels around a node, ascending.
  const int* LabelsBegin(Index n) const { return this->Labels.data() + this->LabelOffset[n]; }
  const int* LabelsEnd(Index n) const { return this->Labels.data() + this->LabelOffset[n + 1]; }
  /// Returns the position of a label among the labels around a node.
  int RankOf(Index n, int label) const;
  bool HasInner(Index n, int rank) const
  {
    return this->HasPoint[this->LabelOffset[n] + rank] != 0;
  }
  /// Returns the number of points I at a node.
  int CountInner(Index n) const
  {
    return this->CountBefore(n, static_cast<int>(this->LabelsEnd(n) - this->LabelsBegin(n)));
  }
  /// Returns the number of the point I of a label among those at the node, from 0.
  int NumberOfInner(Index n, int label) const
  {
    return this->CountBefore(n, this->RankOf(n, label));
  }
  const Vector3& InnerPoint(Index n, int rank) const
  {
    return this->Inner[this->LabelOffset[n] + rank];
  }
  /// Returns the entry of a hex in HexFaces, 0 if it has none.
  int FacesOfHex(Index hexKey) const;

private:
  int CountBefore(Index n, int rank) const
  {
    const auto first = this->HasPoint.begin() + this->LabelOffset[n];
    return static_cast<int>(std::count(first, first + rank, 1));
  }
};

/// Finds the split nodes of a refined grid.
/// @param refined  hexes of the base cells of region, without the finest ones
/// @param region  base cells
/// @param labels  labels of the finest grid, equal in each leaf
/// @param hasHexes  whether the hexes in a cell are made
SplitNodes FindSplitNodes(const RefinedGrid& grid, const RefinedMesh& refined,
  const IndexBox& region, const LabelArray& labels,
  const std::function<bool(const OctreeKeys::LevelIndex& cell)>& hasHexes);

} // namespace vfm
