/**
 * TetTopology: points and tets of a mesh before points move. CellTets.h and LatticeTopology.h make
 * them by the methods Cells and Lattice.
 *
 * Both methods use the body-centred lattice of the grid. Its nodes are the nodes of the grid,
 * called vertices, and the centres of cells. Each face of the grid belongs to the block (i,j,k) of
 * its lowest corner: face `axis` of block b is between the cells b - e_axis and b. A face inside
 * the domain has four lattice tets, t = 0..3, each of the two centres and an edge of the face. A
 * face on the domain boundary has two, t = 0, 1, each of the centre and half of the face, which a
 * diagonal divides.
 *
 * Ids. A point belongs to the block (i,j,k) in which it starts: its coordinates in cells, rounded
 * down. The node of that index owns it: id = NodeKey * 64 + slot + 1. A tet belongs to a face:
 * id = NodeKey * (12 * PiecesPerTet) + (4 axis + t) * PiecesPerTet + piece + 1.
 *
 * Colours. Points of different blocks whose indices have equal parities share no tet. The eight
 * combinations of parities are the colours.
 *
 * In a refined grid this holds for the faces of fine cells. The tets of coarse cells follow after
 * them (CoarseTets.h).
 *
 * A rank makes the tets of the faces whose cells in the domain, one or two, are in
 * CartesianGrid::HexBox. Points and tets are in the order of ids.
 */
#pragma once

#include "Elements/BarrierElements.h"
#include "Labels/Fragments.h"

namespace vfm
{

/// Slots of the nodes of the lattice.
constexpr Index VertexSlot = 0, CentreSlot = 1;
/// Returns the slot of a point from its id.
inline Index SlotOfPoint(Index id)
{
  return (id - 1) % TetIds.PointSlots;
}

/// Position of a point relative to interfaces and the domain boundary.
enum class PointPosition : unsigned char
{
  Inside,     ///< inside a material and the domain
  OnDomain,   ///< inside a material, on the domain boundary
  OnInterface ///< may be on an interface
};

struct TetTopology
{
  Mesh Tets;                            ///< points and elements with ids and materials
  std::vector<PointPosition> Positions; ///< one per point
  BarrierElements Barrier;
};

/// Returns whether a point is the centre of a cell of the grid or of a coarse cell.
bool IsCentre(const Mesh& mesh, Index pointId);
/// Returns the finest cell of a centre. In a coarse cell, it is the finest cell in it that is
/// nearest to the owned cells.
Index3 CellOfCentre(const CartesianGrid& grid, const Mesh& mesh, Index pointId);

/// Sets the fragment of each tet of the method Cells to the fragment of its cell. A tet between two
/// cells of one label gets the fragment of the lower cell.
void FillFragments(const CartesianGrid& grid, const Fragments& fragments, Mesh& mesh);
/// Sets the GeometryId of points inside fragments.
void FillInside(Mesh& mesh);

} // namespace vfm
