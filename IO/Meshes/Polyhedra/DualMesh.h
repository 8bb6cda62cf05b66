/**
 * DualMesh: the polyhedra around the nodes of a mesh of linear tetrahedra.
 *
 * A node inside of a region is one cell; a node on walls (DualWalls.h) is one cell per region and
 * connected group of its tetrahedra there. A face between the cells of two nodes is a polygon
 * around their common edge: through the centres of the tetrahedra there, and at walls through the
 * centres of two wall triangles and, if the edge is sharp, its middle.
 */
#pragma once

#include "Meshes/Polyhedra/DualWalls.h"

#include <span>

namespace vfm
{

struct DualMesh
{
  std::vector<double> Points;
  DualCells Cells;
  std::vector<Index> FacePoints; ///< of one face after another
  std::vector<Index> FaceEnds;   ///< of each face among FacePoints
  std::vector<Index> Owners;     ///< cell of each face with the lower number
  std::vector<Index> Neighbours; ///< cell behind; of inner faces, which are the first ones
  /// Side of the tetrahedra of the owner, 4 * tet + side, at the lowest wall triangle of a face
  /// between two regions or on the boundary; -1 for other faces.
  std::vector<Index> WallSides;

  Index NumberOfPoints() const { return static_cast<Index>(this->Points.size()) / 3; }
  Index NumberOfCells() const { return static_cast<Index>(this->Cells.Nodes.size()); }
  Index NumberOfInnerFaces() const { return static_cast<Index>(this->Neighbours.size()); }
  Index NumberOfFaces() const { return static_cast<Index>(this->FaceEnds.size()); }
  /// Returns the neighbour of a face, or NothingBehind.
  Index BehindFace(Index face) const
  {
    return face < this->NumberOfInnerFaces() ? this->Neighbours[face] : NothingBehind;
  }
  /// Returns the points of a face, counterclockwise seen from outside of its owner.
  std::span<const Index> PointsOf(Index face) const
  {
    const Index begin = face == 0 ? 0 : this->FaceEnds[face - 1];
    return { this->FacePoints.data() + begin,
      static_cast<std::size_t>(this->FaceEnds[face] - begin) };
  }
};

/// Makes the dual of a whole mesh. Faces are ordered by owner, then by neighbour, those on the
/// boundary behind the others. At nodes whose cells would have poor faces (DualMeasures.h), sharp
/// edges of walls are rounded; if faces remain poor, points in tetrahedra are moved; and if finite
/// volumes would still reject faces, cells are split into the parts of single tetrahedra.
/// @param mesh  linear tetrahedra with Material; points and elements ordered by global id
/// @param surfaceOf  the surface of a side on a wall
DualMesh MakeDualMesh(const MeshData& mesh, const SurfaceOfSide& surfaceOf);

} // namespace vfm
