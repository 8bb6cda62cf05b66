/**
 * LayerColumns: the hexahedra along surfaces that are cut into layers.
 */
#pragma once

#include "Elements/Mesh.h"

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

  /// Returns the global ids of the points of each edge.
  std::vector<std::array<Index, 2>> IdsOfEdges(const Mesh& mesh) const;
  /// Returns ids that copies of an edge in a periodic mesh have in common; else IdsOfEdges.
  std::vector<std::array<Index, 2>> KeysOfEdges(const Mesh& mesh) const;
};

/// A facet on which a column stands.
struct ColumnBase
{
  Index Element;
  int Side;
  bool IsChosen; ///< the user selected it
};

/// Returns the corner, by bits, at the other end of the edge from a face of a cell.
inline int OppositeCorner(int corner, int side)
{
  return corner ^ (1 << side / 2);
}

/// Finds the columns on chosen facets, and those that must be cut with them: columns are connected
/// by edges, so the surface of a fragment is chosen as a whole.
/// @param mesh hexahedra
/// @param bases facets that columns may stand on, ascending by element
/// @throws InputError if a hexahedron has two bases, on all ranks
/// @pre Collective
LayerColumns FindLayerColumns(const Mesh& mesh, const std::vector<ColumnBase>& bases, Ranks& ranks);

} // namespace vfm
