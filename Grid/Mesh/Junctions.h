/**
 * Junctions: where facets of several surfaces meet, in the facets of one rank.
 */
#pragma once

#include "Mesh/Mesh.h"

namespace vfm
{

/// An edge of facets, or a point, which is named twice.
struct Junction
{
  std::array<Index, 2> Points; ///< of the mesh, ascending
  std::vector<int> Surfaces;   ///< two or more, ascending
  Index First; ///< of the facets around it the one with the lowest points: no rank knows another
};

inline bool operator<(const Junction& a, const Junction& b)
{
  return a.Points < b.Points;
}

/// The points and edges of mesh.Surfaces on several surfaces, in the order of their points; around points of owned elements all that there are.
class Junctions
{
public:
  /// mesh: GeometryId of each point on surfaces is one of them.
  explicit Junctions(const Mesh& mesh);

  const std::vector<Junction>& Points() const { return this->ThePoints; }
  const std::vector<Junction>& Edges() const { return this->TheEdges; }
  /// Whether no curve goes through a point: on it are not just two edges, of its own surfaces.
  bool IsVertex(std::size_t point) const { return !this->IsThrough[point]; }
  /// The position in Points() of a mesh point that is an end of an edge.
  std::size_t Find(Index meshPoint) const;

private:
  std::vector<Junction> ThePoints, TheEdges;
  std::vector<unsigned char> IsThrough;
};

} // namespace vfm
