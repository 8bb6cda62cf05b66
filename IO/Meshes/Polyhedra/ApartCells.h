/**
 * ApartCells: the cells of a dual mesh that are split into the parts of single tetrahedra.
 *
 * A cell around a node where a region is not convex may not contain its own centre. Its parts do:
 * each is a hexahedron between the node, the middles of three edges, the centres of three sides and
 * the point in the tetrahedron.
 */
#pragma once

#include "Meshes/Polyhedra/DualWalls.h"

#include <map>

namespace vfm
{

/// Points of parts, also those on walls; numbers are those of the dual mesh.
struct ApartPoints
{
  std::map<Index, Index> Nodes;
  std::map<EdgeIds, Index> Middles;
  std::map<EdgeIds, Index> Centres; ///< of the sides between two tetrahedra

  /// Returns the centre of the side between two tetrahedra, or -1 if no part has it.
  Index CentreBetween(Index first, Index second) const
  {
    const auto found = this->Centres.find(MakeEdgeIds(first, second));
    return found == this->Centres.end() ? -1 : found->second;
  }
};

/// Finds the points of parts, and adds the coordinates of those that are on no wall.
/// @param isApart  of each corner of the tetrahedra: whether its part is a cell; on walls only at
/// nodes whose edges are sharp
/// @param[in,out] points  the tetrahedra's and the walls' points; more are added
ApartPoints AddApartPoints(const DualTets& tets, const DualWalls& walls,
  const std::vector<char>& isApart, std::vector<double>& points);

} // namespace vfm
