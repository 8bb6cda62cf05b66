/**
 * LayerFacets: facets, surfaces and curves of a mesh whose columns are cut into layers.
 */
#pragma once

#include "Modify/LayerParts.h"

#include <map>
#include <optional>

namespace vfm
{

/// A corner of a face between two edges of columns.
struct CutCorner
{
  Index Edge; ///< index in LayerColumns::Edges
  bool IsTop;
};

/// Finds the edges of columns from their points.
class EdgeFinder
{
public:
  explicit EdgeFinder(const LayerColumns& columns)
  {
    for (std::size_t e = 0; e < columns.Edges.size(); ++e)
    {
      const LayerColumns::Edge& edge = columns.Edges[e];
      this->Edges[{ { edge.Foot, edge.Top } }] = static_cast<Index>(e);
    }
  }

  /// Returns the edge with this foot and top, or -1.
  Index Find(Index foot, Index top) const
  {
    const auto found = this->Edges.find({ { foot, top } });
    return found == this->Edges.end() ? -1 : found->second;
  }

  /// Returns the corners of a face that two opposite edges cut; nothing for other faces.
  /// @param face four points around a face
  std::optional<std::array<CutCorner, 4>> FindCut(const Index* face) const
  {
    for (int c = 0; c < 4; ++c)
    {
      const int next = (c + 1) % 4, across = (c + 2) % 4, last = (c + 3) % 4;
      const Index one = this->Find(face[c], face[next]),
                  other = this->Find(face[last], face[across]);
      if (one >= 0 && other >= 0)
      {
        std::array<CutCorner, 4> corners;
        corners[c] = { one, false };
        corners[next] = { one, true };
        corners[across] = { other, true };
        corners[last] = { other, false };
        return corners;
      }
    }
    return std::nullopt;
  }

private:
  std::map<std::array<Index, 2>, Index> Edges;
};

/// The geometry in which new points of an edge lie.
struct EdgeGeometry
{
  int Dimension, Id; ///< GeometryDimension and GeometryId
};

/// Returns the geometry of the inside of each edge.
/// @param mesh before it is cut
/// @param edges finder of the edges of the columns
/// @pre Collective
std::vector<EdgeGeometry> FindEdgeGeometry(
  const Mesh& mesh, const LayerColumns& columns, const EdgeFinder& edges, Ranks& ranks);

/// Cuts Mesh::Facets, Surfaces, Curves and the list of facets in Tables.
/// @param mesh with the points of the parts
/// @pre Collective
void CutFacets(const LayerParts& parts, const EdgeFinder& edges, Ranks& ranks, Mesh& mesh);

} // namespace vfm
