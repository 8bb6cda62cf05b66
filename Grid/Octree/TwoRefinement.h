/**
 * TwoRefinement: makes a conforming mesh of hexes across the levels of a refined Cartesian grid.
 * SlabPillow.h names the paper.
 *
 * Each cell of a refined family becomes eight exact cells of the next level. A cell that shares a
 * face or an edge with a refined cell of its level becomes transition hexes, which join both sides
 * without hanging nodes. All other cells of the base grid are unchanged and not stored, so memory
 * is proportional to the refined families.
 *
 * A part of the mesh is made from the closed family sets only, without the rest and without
 * communication. Points and hexes are bitwise identical in all parts that have them.
 */
#pragma once

#include "Octree/OctantFamilies.h"

namespace vfm
{

/// Hexes of a refined grid in a box of base cells, except untouched base cells. Plain arrays, owned
/// by the object.
struct RefinedMesh
{
  /// Point that only transition hexes have. All other points are nodes of the lattice and are
  /// fixed there.
  struct FreePoint
  {
    int Point; ///< index of the point
    /// OctreeKeys::NodeKey on the level of its hexes, also for lattice nodes.
    Index Anchor;
  };

  std::vector<double> Points;   ///< xyz of each point, length units of the grid
  std::vector<Index> PointKeys; ///< key of each point (OctreeKeys::NodeOfKey), ascending
  /// Sides of the domain of each point: bit f is set on side f.
  std::vector<unsigned char> DomainSides;
  /// Free points, sorted by Anchor, so that copies of a lattice node are in sequence.
  std::vector<FreePoint> FreePoints;
  std::vector<Index> Anchors; ///< anchor of each point (AnchorOfNode)
  std::vector<Index> Hexes;   ///< 8 point indices per hex, VTK order
  std::vector<Index> HexKeys; ///< key of each hex (OctreeKeys::HexOfKey), ascending
  /// Whether each hex is a transition hex; otherwise it is a cell of a level above 0.
  std::vector<unsigned char> IsTransition;
  /// Keys of the base cells that the hexes replace, ascending.
  std::vector<Index> TouchedCells;

  Index NumberOfPoints() const { return static_cast<Index>(this->PointKeys.size()); }
  Index NumberOfHexes() const { return static_cast<Index>(this->HexKeys.size()); }
};

/// Returns the anchor of a node, as OctreeKeys::NodeKey on its level; -1 if it has none. The anchor
/// of a point is the lattice node with which it moves when transition hexes are smoothed, a corner
/// of a cell that consists of transition hexes. A lattice node is its own anchor, on the coarsest
/// level where it is such a corner. A node that appears only when cells of the previous level are
/// divided may have another node of that level as anchor; only RefinedMesh::Anchors has these.
/// @param key  key of the node
Index AnchorOfNode(const OctantFamilies& sets, Index key);

/// Returns the anchor of any point, from the mesh if the mesh has the point, otherwise
/// by AnchorOfNode.
Index AnchorOfPoint(const OctantFamilies& sets, const RefinedMesh& mesh, Index key);

/// Makes the hexes in a box of base cells, except untouched base cells, before untangling.
/// @param withFinest  false: omits the cells of the last level, and points that have neither an
/// anchor nor another hex
RefinedMesh MakeRefinedMesh(
  const OctantFamilies& sets, const IndexBox& box, bool withFinest = true);
inline RefinedMesh MakeRefinedMesh(const OctantFamilies& sets)
{
  return MakeRefinedMesh(sets, sets.Lattice().Base().Global());
}

/// Calls visit(cell) for the untouched base cells of the box in which the mesh was made, by key.
template <class Visitor>
void ForUntouchedCells(
  const CartesianGrid& base, const IndexBox& box, const RefinedMesh& mesh, const Visitor& visit)
{
  auto touched = mesh.TouchedCells.begin();
  ForCells(box,
    [&](const Index3& cell)
    {
      if (touched != mesh.TouchedCells.end() && *touched == base.CellKey(cell))
      {
        ++touched;
        return;
      }
      visit(cell);
    });
}

} // namespace vfm
