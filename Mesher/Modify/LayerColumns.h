/**
 * LayerColumns: the hexahedra along surfaces that are cut into layers.
 */
#pragma once

#include "Mesh/Mesh.h"

#include <functional>

namespace vfm
{

/// Hexahedra with a face on a surface. Hexahedra that share an edge from the surface to the
/// opposite face are cut together.
struct LayerColumns
{
  /// An edge of columns, from the surface to the opposite face.
  struct Edge
  {
    Index Foot, Top; ///< points of the mesh; the foot is on the surface
  };
  struct Column
  {
    Index Element;
    int Side;                   ///< the face on the surface, 0..5 for -x +x -y +y -z +z
    std::array<Index, 4> Edges; ///< at the corners of the face in the order of FaceCorners
  };
  std::vector<Edge> Edges;     ///< ascending by the global ids of foot and top
  std::vector<Column> Columns; ///< ascending by element

  /// Returns the global ids of each edge.
  std::vector<std::array<Index, 2>> KeysOfEdges(const Buffer<Index>& ids) const;
};

/// Returns the corner, by bits, at the other end of the edge from a face of a cell.
inline int OppositeCorner(int corner, int side)
{
  return corner ^ (1 << side / 2);
}

/// Finds the columns at chosen facets, and those that must be cut with them: columns are connected
/// by edges, so the surface of a fragment is chosen as a whole.
/// @param mesh hexahedra
/// @param isOnSurface facets that columns may stand on
/// @param isChosen facets of these that the user selected
/// @throws InputError if a hexahedron has two facets on the surface, on all ranks
/// @pre Collective
LayerColumns FindLayerColumns(const Mesh& mesh,
  const std::function<bool(const MeshFacet&)>& isOnSurface,
  const std::function<bool(const MeshFacet&)>& isChosen, Ranks& ranks);

} // namespace vfm
