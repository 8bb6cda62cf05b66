/**
 * What bounds what in the geometry that a mesh resolves: volumes, surfaces, curves, vertices. The same on every rank.
 */
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace vfm
{

struct GeometryTables
{
  using Pair = std::array<int, 2>;

  ///@{ Of surfaces 1, 2, ...: what lies on the two sides, the smaller material first, as in facets.
  std::vector<Pair> SurfaceVolumes;   ///< fragments; 0: not meshed, or beyond the domain
  std::vector<Pair> SurfaceMaterials; ///< 0: void, or beyond the domain
  std::vector<int> SurfaceSides;      ///< -1, or the side of the domain, 0..5 for -x +x -y +y -z +z
  std::vector<int> SurfaceParts;    ///< 0, or which smooth side of an interface with edges, from 1
  std::vector<double> SurfaceAreas; ///< squared length units of the grid
  std::vector<std::array<double, 3>> SurfaceCentroids; ///< of the area
  /// Means of the normals over the area, from the second material to the first: of length 1 on a plane, 0 all around a volume.
  std::vector<std::array<double, 3>> SurfaceNormals;
  ///@}
  /// Of curves 1, 2, ...: how many ends of its edges are vertices: none of a closed curve, two of an open one, more where the same
  /// surfaces meet in several pieces.
  std::vector<int> CurveEnds;
  ///@{ Each pair once, ascending: a volume and a surface that bounds it, and so on downwards.
  std::vector<Pair> VolumeSurfaces, SurfaceCurves, CurveVertices;
  ///@}
  /// Facets of smooth sides whose points do not tell the surface, since none is inside one, or several inside several: global ids of the
  /// points, ascending, of triangles -1 first, and the surface. Ascending.
  std::vector<std::array<std::int64_t, 5>> EdgeFacets;
};

inline bool operator==(const GeometryTables& a, const GeometryTables& b)
{
  const auto all = [](const GeometryTables& t)
  {
    return std::tie(t.SurfaceVolumes, t.SurfaceMaterials, t.SurfaceSides, t.SurfaceParts,
      t.SurfaceAreas, t.SurfaceCentroids, t.SurfaceNormals, t.CurveEnds, t.VolumeSurfaces,
      t.SurfaceCurves, t.CurveVertices, t.EdgeFacets);
  };
  return all(a) == all(b);
}

} // namespace vfm
