/**
 * LatticeNear: sets of lattice nodes near a cell, one bit per node. Connections of such sets take a
 * few operations on whole words.
 *
 * The nodes near a cell are those of the 3 x 3 x 3 cells around it: 27 centres and 64 vertices.
 */
#pragma once

#include "Elements/Tet/LatticeNodes.h"

#include <cstdint>

namespace vfm
{

/// Nodes near a cell. The bit of the vertex or the cell (x,y,z), relative to the lowest, is
/// x + 4 y + 16 z.
struct NearNodes
{
  std::uint64_t Vertices = 0, Centres = 0;
};

inline NearNodes operator&(const NearNodes& a, const NearNodes& b)
{
  return { a.Vertices & b.Vertices, a.Centres & b.Centres };
}

inline bool IsEmpty(const NearNodes& a)
{
  return (a.Vertices | a.Centres) == 0;
}

/// Returns whether all nodes of a set are in another set.
inline bool IsSubset(const NearNodes& a, const NearNodes& b)
{
  return (a.Vertices & ~b.Vertices) == 0 && (a.Centres & ~b.Centres) == 0;
}

/// Returns the centre of the cell in the middle.
inline NearNodes MiddleCentre()
{
  return { 0, std::uint64_t(1) << 21 };
}

/// Returns the centre of the cell across a face of the cell in the middle.
NearNodes CentreAcross(int face);

/// Returns the nodes that have a label, or are snapped.
/// @param cell  linear index of the cell in the middle; the cells around it are in the domain
NearNodes FindNear(const LatticeNodes& nodes, const CartesianGrid& grid, Index cell, int label);

/// Returns the nodes that share a lattice edge with any of some nodes.
NearNodes NeighboursOf(const NearNodes& nodes);

/// Returns the nodes of a set that are connected, within the set, to some of its nodes.
NearNodes ConnectedTo(const NearNodes& some, const NearNodes& set);

/// Returns whether two lattice tets share a triangle of snapped nodes, with the fourth node of one
/// in a set and that of the other in another set.
bool MeetAtTriangle(const NearNodes& a, const NearNodes& b, const NearNodes& snapped);

} // namespace vfm
