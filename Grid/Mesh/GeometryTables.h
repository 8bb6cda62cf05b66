/**
 * What bounds what in the geometry that a mesh resolves: volumes, surfaces, curves, vertices. The same on every rank.
 */
#pragma once

#include <array>
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
  ///@}
  /// Of curves 1, 2, ...: how many ends of its edges are vertices: none of a closed curve, two of an open one, more where the same
  /// surfaces meet in several pieces.
  std::vector<int> CurveEnds;
  ///@{ Each pair once, ascending: a volume and a surface that bounds it, and so on downwards.
  std::vector<Pair> VolumeSurfaces, SurfaceCurves, CurveVertices;
  ///@}
};

inline bool operator==(const GeometryTables& a, const GeometryTables& b)
{
  return a.SurfaceVolumes == b.SurfaceVolumes && a.SurfaceMaterials == b.SurfaceMaterials &&
    a.SurfaceSides == b.SurfaceSides && a.CurveEnds == b.CurveEnds &&
    a.VolumeSurfaces == b.VolumeSurfaces && a.SurfaceCurves == b.SurfaceCurves &&
    a.CurveVertices == b.CurveVertices;
}

} // namespace vfm
