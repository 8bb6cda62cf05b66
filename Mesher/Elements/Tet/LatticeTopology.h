/**
 * LatticeTopology: the tets of the method Lattice, whose interfaces cut
 * tets of the body-centred lattice.
 */
#pragma once

#include "Elements/Tet/LatticeNodes.h"
#include "Elements/Tet/TetFacets.h"
#include "Labels/NarrowVoid.h"

namespace vfm
{

class CoarseTets;
class Partition;

struct LatticeTets
{
  TetTopology Topology;
  TetFaces Faces;
};

/// Makes the tets of labelled lattice nodes: lattice tets whose nodes have several labels are cut.
/// All tets are positive for any labels, and each has a point inside its material and the domain.
/// Nodes are settled (LatticeNodes.h), and tets made again, until the tets have the fragments of
/// the cells, the same pairs of fragments touch, and the boundary of every material is a manifold.
/// F. Labelle and J. R. Shewchuk, Isosurface stuffing, ACM Transactions on Graphics 26 (2007), here
/// for several labels.
/// @param nodes  labels of the nodes; nodes that break LatticeRules or cause LatticeFaults are
/// settled
/// @param narrow  void cells that get tets as a barrier, in all lattice tets that touch them; empty
/// if void is meshed
/// @param coarse  tets of the coarse cells. The nodes of FindLatticeInterfaces must be surrounded
/// by finest cells.
/// @return points and tets in CartesianGrid::HexBox, ordered by id, and their faces
/// @throws InputError  if ids or numbers of points are too large
/// @pre Collective.
LatticeTets BuildLatticeTets(const CartesianGrid& grid, LatticeNodes& nodes, bool meshVoid,
  const NarrowVoid& narrow, const Partition& partition, Runtime& runtime, const CoarseTets& coarse);

/// Returns the vertices at which lattice tets may be cut or move: they are snapped, or a centre
/// around them is snapped or has another label.
/// @return linear indices of vertices of the cells of HexBox, ascending
std::vector<Index> FindLatticeInterfaces(const CartesianGrid& grid, const LatticeNodes& nodes);

} // namespace vfm
