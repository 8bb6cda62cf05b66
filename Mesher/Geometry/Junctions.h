/**
 * Junctions: the points and edges of one rank's facets where several surfaces meet.
 */
#pragma once

#include "Elements/Mesh.h"

namespace vfm
{

/// Edge of facets, or point, on several surfaces.
struct Junction
{
  std::array<Index, 2> Points; ///< points of the mesh, ascending; equal for a point
  std::vector<int> Surfaces;   ///< two or more, ascending
  /// The adjacent facet with the lowest points, which is the same facet on all ranks.
  Index First;
};

inline bool operator<(const Junction& a, const Junction& b)
{
  return a.Points < b.Points;
}

/// Points and edges of mesh.Surfaces on several surfaces, in the order of their points. The lists
/// are complete around points of owned elements.
class Junctions
{
public:
  /// @param mesh  GeometryId of each point on surfaces must be one of these surfaces
  explicit Junctions(const Mesh& mesh);

  const std::vector<Junction>& Points() const { return this->ThePoints; }
  const std::vector<Junction>& Edges() const { return this->TheEdges; }
  /// Returns whether a point is a vertex. It is not if exactly two junction edges end there and
  /// both are on the same surfaces as the point; then a curve runs through it.
  bool IsVertex(std::size_t point) const { return !this->IsThrough[point]; }
  /// Returns the position in Points() of a mesh point.
  /// @pre The point is an end of a junction edge.
  std::size_t Find(Index meshPoint) const;

private:
  std::vector<Junction> ThePoints, TheEdges;
  std::vector<unsigned char> IsThrough;
};

} // namespace vfm
