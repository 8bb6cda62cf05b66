/**
 * From labels to tetrahedra: points and tets before anything moves. Two ways: Cells (CellTets.h) and Lattice (LatticeTopology.h).
 *
 * Both are made of the body-centred lattice of the grid: its nodes are the grid's nodes (vertices) and the centres of
 * cells. Each face of the grid belongs to the block (i,j,k) of its lowest corner: face `axis` of block b lies
 * between the cells b - e_axis and b. Around an inner face stand four lattice tets, t = 0..3: the two centres and
 * an edge of the face; on a face of the domain two, t = 0, 1: the one centre and half of the face, cut by
 * a diagonal.
 *
 * Ids. Every point belongs to the block (i,j,k) in which it starts (its coordinates in cells, rounded down), the
 * node of that index owns it: id = NodeKey * 64 + slot + 1. Every tet belongs to a face:
 * id = NodeKey * (12 * PiecesPerTet) + (4 axis + t) * PiecesPerTet + piece + 1.
 * Points whose blocks have the same parities share no tet (blocks of different index): these are the eight colours.
 *
 * In a refined grid this is so for faces of fine cells alone; the coarse tets follow (CoarseTets.h).
 *
 * Made of the faces whose cells lie in CartesianGrid::HexBox (both, or the one in the domain). Order: points and tets by id.
 */
#pragma once

#include "Mesh/Mesh.h"

namespace vfm
{

/// Slots of the nodes of the lattice: vertices and centres.
constexpr Index VertexSlot = 0, CentreSlot = 1;
/// The slot of a point from its id.
inline Index SlotOfPoint(Index id)
{
  return (id - 1) % TetIds.PointSlots;
}

/// Where a point may lie.
enum class PointPosition : unsigned char
{
  Inside,   ///< inside a material and the domain
  OnDomain, ///< inside a material, on a side of the domain
  OnInterface
};

struct TetTopology
{
  Mesh Tets;                            ///< points, ids, elements, ids, materials
  std::vector<PointPosition> Positions; ///< of each point
};

/// Whether a point is the centre of a cell of the grid or of a coarse hex.
bool IsCentre(const Mesh& mesh, Index pointId);
/// Of a centre: the finest cell, of those of its hex the nearest to the owned ones.
Index3 CellOfCentre(const CartesianGrid& grid, const Mesh& mesh, Index pointId);

} // namespace vfm
