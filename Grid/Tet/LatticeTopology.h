/**
 * The tets of the method Lattice.
 */
#pragma once

#include "Tet/LatticeNodes.h"
#include "Tet/TetFacets.h"

namespace vfm
{

class CoarseTets;
class Partition;

struct LatticeTets
{
  TetTopology Topology;
  TetFaces Faces;
};

/// Every node of the lattice has a label of its own, from the fractions; lattice tets with several labels are cut. All tets
/// positive for any fractions. Unsnaps nodes until the boundary of every material is a manifold. coarse: of a grid whose interfaces, where it is
/// refined, are those of FindLatticeInterfaces. Collective.
LatticeTets BuildLatticeTets(const CartesianGrid& grid, LatticeNodes& nodes, bool meshVoid,
  const Partition& partition, Runtime& runtime, const CoarseTets& coarse);

/// The vertices of the cells of HexBox that differ in label from a centre around them or are snapped or beside a snapped
/// centre: only lattice tets at such vertices are cut or move. Linear indices, ascending.
std::vector<Index> FindLatticeInterfaces(const CartesianGrid& grid, const LatticeNodes& nodes);

} // namespace vfm
