/**
 * Interface: interfaces between labels: their faces, the points where the true interface crosses
 * the dual edge of each face, and the surface points fitted to these crossings.
 *
 * Frames. Grid coordinates are (x - lower corner of the domain) / CartesianGrid::MeanWidth, so that
 * numbers are close to cell counts. The local frame of a node or cell has grid coordinates relative
 * to it, divided by its widths along each axis, so that cells are unit cubes.
 *
 * A pair is two labels a < b. Its difference field D is 2 (1 - vf_0 - isoValue) for a = 0, else
 * vf_b - vf_a. It is negative on the side of a. Normals point from a to b.
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Runtime.h"
#include "Labels/InterfaceFaces.h"

namespace vfm
{

/// Point where the interface crosses the dual edge of a face, in grid coordinates.
struct Crossing
{
  Vector3 Point;
  Vector3 Normal; ///< unit
  double Weight;  ///< > 0, at most 1; smaller if the pair fills less of the cells
};

/// Pair of labels that meets at a surface node, and the point of its interface nearest to the node.
struct SurfacePoint
{
  int First, Second;
  Vector3 Point;  ///< grid coordinates
  Vector3 Normal; ///< unit, grid coordinates
};

/// Faces, crossings and surface points in the local box of a grid. Keeps a reference to the grid.
/// It does not change after construction, so threads may read it at the same time.
class Interface
{
public:
  /// @param fractions  fractions of the cells of the local box
  /// @param labels  labels of the same cells, after ResolveLabels
  /// @param mixed  FindMixedNodes(grid, labels), or some of these nodes, ascending; faces with a
  ///   node that is not listed are left out
  /// @param steps  cells, ascending, whose label differs from their fractions because they are part
  ///   of a coarser cell; their faces get the crossings of faces nearby (FindCrossingNear)
  Interface(const CartesianGrid& grid, const FractionField& fractions, const LabelArray& labels,
    std::vector<Index> mixed, double isoValue, Runtime& runtime,
    const std::vector<Index>& steps = {});

  const CartesianGrid& Grid() const { return this->TheGrid; }
  /// Returns the mixed nodes, ascending.
  const std::vector<Index>& Nodes() const { return this->MixedNodes; }
  /// Returns the position of a node in Nodes(), or -1.
  Index Find(Index node) const;

  const std::vector<InterfaceFace>& Faces() const { return this->TheFaces; }
  /// Returns the crossings, one per face.
  const std::vector<Crossing>& Crossings() const { return this->TheCrossings; }
  /// Returns the four nodes of a face (positions in Nodes()), in order around it.
  const std::array<Index, 4>& CornersOfFace(Index face) const { return this->FaceNodes[face]; }
  /// Returns where the faces at the n-th node begin in FaceList(), ascending. They end where the
  /// faces at the next node begin.
  Index FaceOffset(Index n) const { return this->FacesOfNodes.Begin[n]; }
  const std::vector<Index>& FaceList() const { return this->FacesOfNodes.Items; }

  /// Returns where the surface points of the n-th node begin in Points(), ascending by pair. They
  /// end where the points of the next node begin.
  Index PointOffset(Index n) const { return this->PointsAt[n]; }
  const std::vector<SurfacePoint>& Points() const { return this->SurfacePoints; }
  /// Returns the surface point of a pair at the n-th node, or nullptr.
  const SurfacePoint* FindPoint(Index n, int first, int second) const;

  /// Returns the grid coordinates of a node.
  Vector3 NodePoint(Index node) const;
  /// Returns the mean widths of the cells at a node, in grid coordinates; at the boundary, the
  /// widths of the cells inside.
  Vector3 NodeWidths(Index node) const;
  /// Returns the length of one unit of grid coordinates.
  double Scale() const { return this->MeanWidth; }

private:
  void FindFaces(const LabelArray& labels);
  void AddFace(const InterfaceFace& face);
  void FindSurfacePoints(Runtime& runtime);
  void SlideIntoDomain(Index node, const Vector3& x, SurfacePoint& point) const;
  void AddSurfacePoints(Index n, std::vector<SurfacePoint>& points) const;

  const CartesianGrid& TheGrid;
  double MeanWidth;
  std::vector<Index> MixedNodes;
  std::vector<InterfaceFace> TheFaces;
  std::vector<std::array<Index, 4>> FaceNodes;
  std::vector<Crossing> TheCrossings;
  Groups<Index> FacesOfNodes;
  std::vector<Index> PointsAt;
  std::vector<SurfacePoint> SurfacePoints;
};

} // namespace vfm
