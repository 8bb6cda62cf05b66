/**
 * TwoRefinement: a conforming mesh of hexes across the levels of a refined Cartesian grid.
 *
 * Every cell of a refined family is eight cells of the next level, exact ones; a cell of one level that shares a face or an
 * edge with a refined one of that level becomes transition hexes, which join both sides without hanging nodes. All other
 * cells of the base grid stay and are not stored: memory follows the refined families.
 *
 * A part of the mesh is made from the closed family sets alone, without the rest and without communication; points and
 * hexes are the same bit for bit in every part that has them.
 */
#pragma once

#include "Octree/OctantFamilies.h"

namespace vfm
{

struct RefinedMesh
{
  /// A point that only transition hexes have; all others are nodes of the lattice and stay there.
  struct FreePoint
  {
    int Point;    ///< index
    Index Anchor; ///< OctreeKeys::NodeKey on the level of its hexes, also of lattice nodes
  };

  std::vector<double> Points;              ///< xyz a point, length units of the grid
  std::vector<Index> PointKeys;            ///< ascending (OctreeKeys::NodeOfKey)
  std::vector<unsigned char> DomainSides;  ///< of each point: bit f set on side f of the domain
  std::vector<FreePoint> FreePoints;       ///< by Anchor: the copies of one lattice node in turn
  std::vector<Index> Anchors;              ///< of each point (AnchorOfNode)
  std::vector<Index> Hexes;                ///< 8 point indices a hex, VTK order
  std::vector<Index> HexKeys;              ///< ascending (OctreeKeys::HexOfKey)
  std::vector<unsigned char> IsTransition; ///< of each hex; else it is a cell of a level above 0
  std::vector<Index> TouchedCells; ///< keys of the base cells that hexes stand for, ascending

  Index NumberOfPoints() const { return static_cast<Index>(this->PointKeys.size()); }
  Index NumberOfHexes() const { return static_cast<Index>(this->HexKeys.size()); }
};

/// The anchor of a point is the lattice node with which it moves when transition hexes are smoothed: a corner of a cell that
/// consists of transition hexes. A lattice node is its own anchor on the coarsest level where it is such a corner. Given
/// the key of a node, returns its anchor as OctreeKeys::NodeKey on that level; -1: on none. A node that appears only when the cells
/// of the level before are cut may have an anchor there, another node: RefinedMesh::Anchors knows these.
Index AnchorOfNode(const OctantFamilies& sets, Index key);

/// The same of any point, of the mesh or not: where the mesh has it, as the mesh knows it.
Index AnchorOfPoint(const OctantFamilies& sets, const RefinedMesh& mesh, Index key);

/// The hexes in a box of base cells, before anything is untangled: all but those of untouched base cells. withFinest:
/// false leaves out the cells of the last level, and those of their points that have no anchor and no other hex.
RefinedMesh MakeRefinedMesh(
  const OctantFamilies& sets, const IndexBox& box, bool withFinest = true);
inline RefinedMesh MakeRefinedMesh(const OctantFamilies& sets)
{
  return MakeRefinedMesh(sets, sets.Lattice().Base().Global());
}

/// Calls visit(cell) for the base cells of the box that the mesh was made in and that it leaves as they are, by key.
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
