/**
 * GeometryTables: adjacency and measures of the volumes, surfaces, curves and vertices of a mesh.
 */
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace vfm
{

/// Tables of the geometry of a mesh. A rank has the rows of the surfaces and curves that it
/// touches, or all rows (GatherTables.h); on a single rank they are the same.
struct GeometryTables
{
  using Pair = std::array<int, 2>;

  ///@{ Whether the rows are those of surfaces or curves 1, 2, .. of the whole mesh.
  bool HasAllSurfaces = true, HasAllCurves = true;
  ///@}
  ///@{ Number over all ranks of each row, ascending; empty if all rows are there.
  std::vector<int> SurfaceIds, CurveIds;
  ///@}
  ///@{ Columns of surfaces; a pair holds both sides, the smaller material first.
  std::vector<Pair> SurfaceVolumes;   ///< fragments; 0: not meshed or outside the domain
  std::vector<Pair> SurfaceMaterials; ///< materials; 0: void or outside the domain
  std::vector<int> SurfaceSides;      ///< -1, or the side of the domain, 0..5 for -x +x -y +y -z +z
  std::vector<int> SurfaceParts;      ///< smooth side of an interface with edges, from 1; else 0
  /// Names of sides that the surface of a body names, or ""; empty if there are none.
  std::vector<std::string> PatchNames;
  std::vector<double> SurfaceAreas; ///< areas in squared length units of the grid
  std::vector<std::array<double, 3>> SurfaceCentroids; ///< centroids of the area
  /// Mean normals over the area, from the second material to the first. The length is 1 for a plane
  /// and 0 for a closed surface.
  std::vector<std::array<double, 3>> SurfaceNormals;
  ///@}
  /// Column of curves: the number of ends of curve edges at vertices. It is 0 for a closed curve, 2
  /// for an open one, and larger if the curve has several components.
  std::vector<int> CurveEnds;
  ///@{ Pairs of a volume and a surface that bounds it, and so on; ascending, without duplicates.
  /// Pairs of the surfaces or curves with rows; without all rows, CurveVertices are those of the
  /// curve edges of this rank.
  std::vector<Pair> VolumeSurfaces, SurfaceCurves, CurveVertices;
  ///@}
  /// Facets of smooth sides whose surface cannot be found from their points, because no point is
  /// inside a surface or points are inside several. An entry holds the global ids of the points,
  /// ascending (in triangles -1 first), and the surface. Entries are ascending. Without all rows of
  /// surfaces, those of the facets of this rank.
  std::vector<std::array<std::int64_t, 5>> EdgeFacets;

  /// Returns the row of a surface by its number over all ranks, or -1 if there is none.
  std::ptrdiff_t RowOfSurface(int surface) const
  {
    if (this->HasAllSurfaces)
    {
      const auto rows = static_cast<int>(this->SurfaceVolumes.size());
      return surface >= 1 && surface <= rows ? surface - 1 : -1;
    }
    const auto at = std::lower_bound(this->SurfaceIds.begin(), this->SurfaceIds.end(), surface);
    return at != this->SurfaceIds.end() && *at == surface ? at - this->SurfaceIds.begin() : -1;
  }
};

inline bool operator==(const GeometryTables& a, const GeometryTables& b)
{
  const auto all = [](const GeometryTables& t)
  {
    return std::tie(t.HasAllSurfaces, t.HasAllCurves, t.SurfaceIds, t.CurveIds, t.SurfaceVolumes,
      t.SurfaceMaterials, t.SurfaceSides, t.SurfaceParts, t.PatchNames, t.SurfaceAreas,
      t.SurfaceCentroids, t.SurfaceNormals, t.CurveEnds, t.VolumeSurfaces, t.SurfaceCurves,
      t.CurveVertices, t.EdgeFacets);
  };
  return all(a) == all(b);
}

} // namespace vfm
