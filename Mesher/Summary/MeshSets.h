/**
 * MeshSets: the side sets and node sets of a mesh, from its facets.
 *
 * Side sets: one for each ordered pair of materials that touch, "ball_to_plate", which holds the faces of the elements of the first
 * that lie against the second, and "ball_to_Void" for its free surface; where such an interface has several smooth sides, one more for
 * each, "ball_to_Void_3", 3 its surface; and one a side of the domain, "x_min" to "z_max", of all materials. Node sets: one a side of the domain, and one of the nodes of each smooth side, with its name and id. Faces on the domain are in no set of a pair.
 * Of a turned image (field DomainFrame) the sides are those of its own axes: x_min is where its first index begins.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Summary/MeshData.h"

namespace vfm
{

struct MeshSide
{
  Index Element; ///< of this rank
  int Side;      ///< as MeshFacet::Side
};

struct SideSet
{
  int Id;
  std::string Name;
  int Surface;                 ///< of a smooth side, else 0
  std::vector<MeshSide> Sides; ///< of this rank, ascending
};

struct NodeSet
{
  int Id;
  std::string Name;
  std::vector<Index> Points; ///< of this rank, ascending
};

struct MeshSets
{
  std::vector<SideSet> SideSets;
  std::vector<NodeSet> NodeSets;
};

/// Collective: the sets that are not empty on all ranks together, the same list of ids and names on each. Ids: 1 to 6 of the
/// sides of the domain, x_min first; first * 1000 + second of two materials with ids below 1,000 (a greater power of ten for
/// greater ids; counted from 7 where that does not fit 31 bits); the void is 0 as the second, FindVoidId() as the first. Of smooth sides the
/// id of the pair * 1000 + surface (or a greater power of ten; counted on where that does not fit).
/// The fields of the mesh must be the same on all ranks, also those without elements. Throws as FindMeshFacets.
MeshSets FindMeshSets(const MeshData& mesh, Ranks& ranks);

} // namespace vfm
