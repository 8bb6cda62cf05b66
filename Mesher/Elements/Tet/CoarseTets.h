/**
 * CoarseTets: the tets outside the finest cells of a refined grid, which form a graded body-centred
 * lattice.
 *
 * Nodes are the centres and corners of leaves: cells that are not refined (RefinedUnit::Cell). Each
 * face of a leaf has tets:
 * - between two leaves of one level and label, four around the edge between the centres, as in
 * finest cells. Where leaves at an edge of the face are finer, its midpoint halves the tet there.
 * - towards finer leaves, eight from the centre of the leaf to the triangles around the centre of
 *   the face.
 * - towards a coarser leaf, two from the centre to the halves of the face. They meet at the centre
 *   of the face of the coarser leaf.
 * - on interfaces between leaves of one level, the domain boundary and flat seams, two to the
 * halves of the face; if an edge has a midpoint, four to eight to triangles around the centre of
 * the face.
 *
 * Cells that share an edge differ by at most one level (OctantFamilies.h), so no other case exists.
 * In cubes, dihedral angles are from 45 to 120 degrees. Points of larger cells move only if
 * interfaces cross levels (ActiveTets.h).
 *
 * Each leaf has one label. Only if interfaces cross levels are larger leaves at interfaces. Ids are
 * CoarsePointId, CentreId and TetId (LevelIds.h). A tet between leaves of one level belongs to the
 * lower one, all others to the leaf of their centre. Each tet depends only on the sets of refined
 * cells, which all ranks know.
 *
 * After F. Labelle and J. R. Shewchuk, Isosurface stuffing, ACM Transactions on Graphics 26 (2007);
 * the domain boundary and seams are added.
 */
#pragma once

#include "Elements/Tet/TetTopology.h"
#include "Labels/NarrowVoid.h"
#include "Octree/RefinedGrid.h"

#include <functional>
#include <limits>

namespace vfm
{

/// Tets of the coarse leaves in and around HexBox, whose points in finest cells are in HexBox. The
/// grid must outlive it.
class CoarseTets
{
public:
  /// Makes the tets, or none if the grid has no refinements.
  /// @param labels  labels of the finest cells, equal in each leaf
  /// @param narrow  void cells that get tets as a barrier, equal in each leaf
  /// @throws InputError  if ids or numbers of points are too large
  /// @pre Collective.
  CoarseTets(const RefinedGrid& grid, const LabelArray& labels, bool meshVoid,
    const NarrowVoid& narrow, Ranks& ranks);

  const RefinedGrid& Levels() const { return this->Grid; }
  /// Returns the number of points that are not in finest cells.
  Index NumberOfPoints() const { return static_cast<Index>(this->Ids.size()); }
  Index NumberOfTets() const { return static_cast<Index>(this->Tets.size()); }

  /// Returns the mesh point in a slot of a block, given by its linear index. The slot is VertexSlot
  /// for a vertex of the finest grid and CentreSlot for the centre of a finest cell.
  using FinePoint = std::function<Index(Index linear, Index slot)>;
  /// Writes points with ids and positions, and tets with ids and materials, in the order of ids.
  /// @param firstPoint,firstTet  indices from which points and tets are written
  void Fill(
    TetTopology& topology, Index firstPoint, Index firstTet, const FinePoint& finePoint) const;

private:
  using Cell = OctreeKeys::LevelIndex;
  struct Tet
  {
    Index Id;
    int Material;
    /// Ids of points; ~(2 linear + slot) of points in finest cells.
    std::array<Index, 4> Points;
  };
  /// Corners and midpoints of the edges of a face, counterclockwise as seen from beyond it.
  struct Face
  {
    Cell Leaf;
    int Side;
    Index Centre; // of the leaf
    std::array<Index, 4> Corners, Midpoints;
  };
  static constexpr Index NoPoint = 0, Unknown = std::numeric_limits<Index>::min();
  static constexpr int NoTets = -1;

  void AddLeaves(const Cell& cell, const IndexBox& region);
  void AddTetsOf(const Cell& leaf);
  void AddTetsOfFace(const Face& face, int label);
  void AddBetween(const Face& face, const Cell& beyond, int label);
  void AddInner(const Face& face, Index beyond, int label);
  void AddOneSided(const Face& face, int label);
  void AddAroundCentre(const Face& face, int label);
  void AddHalves(const Face& face, int first, int label);
  void AddFinestBeyond(const Face& face);
  void AddTet(const Face& face, int number, const std::array<Index, 4>& points, int label);
  Index KnownCell(const Cell& leaf) const;
  int LabelOf(Index cell) const;
  Face FaceOf(const Cell& leaf, int side) const;
  bool IsOnFlatSeam(const Cell& leaf, int side) const;
  int BoundaryDiagonal(const Cell& leaf, int side) const;
  Index PointOf(int level, const Index3& node) const;
  Index CentreOf(const Cell& cell) const;
  Vector3 PositionOf(Index id) const;
  PointPosition KindOf(Index id) const;

  const RefinedGrid& Grid;
  const LabelArray& Labels;
  const bool MeshVoid;
  const NarrowVoid* Narrow; // null once the tets are made
  std::vector<Tet> Tets;    // by id
  std::vector<Index> Ids;   // of points that are not in finest cells, ascending
};

} // namespace vfm
