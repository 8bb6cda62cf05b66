/**
 * Interface: the interfaces between labels, as faces between cells, points where the true interface
 * crosses the line between two cell centres (dual edge), and surface points. Each face has one
 * crossing; surface points are found from the crossings around a node.
 *
 * Frames. Grid coordinates are (x - lower corner of the domain) / CartesianGrid::MeanWidth, so that
 * numbers are close to cell counts. The local frame of a node or cell has grid coordinates relative
 * to it, divided by its widths along each axis, so that cells are unit cubes.
 *
 * A pair is two labels a < b. Its difference field is D = vf_b - vf_a, with the fractions vf of a
 * cell. For a = 0 (void), it is D = 2 (1 - vf_0 - isoValue). D is negative on the side of a.
 * Normals point from a to b.
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
  double Weight;  ///< above 0, at most 1; smaller where other labels fill a part of the cells
};

/// Pair of labels that meet at a surface node, and a point of their interface near the node: the
/// mean of the node's projections onto the tangent planes of the crossings around it.
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
  /// @param mixed  FindMixedNodes(grid, labels), or some of these nodes, ascending. A face is left
  ///   out if one of its nodes is not in this list
  /// @param steps  cells, ascending, that got their label as a part of a coarser cell, against
  ///   their own fractions. Their faces get the crossing of a face nearby (Crossings.h)
  /// @param thin  cells, ascending, that got their label as a thin part (FilmCrossings.h)
  Interface(const CartesianGrid& grid, const FractionField& fractions, const LabelArray& labels,
    std::vector<Index> mixed, double isoValue, Runtime& runtime,
    const std::vector<Index>& steps = {}, const std::vector<Index>& thin = {});

  const CartesianGrid& Grid() const { return this->TheGrid; }
  /// Returns the mixed nodes, ascending.
  const std::vector<Index>& Nodes() const { return this->MixedNodes; }
  /// Returns the position of a node in Nodes(), or -1.
  Index Find(Index node) const;

  const std::vector<InterfaceFace>& Faces() const { return this->TheFaces; }
  /// Returns the crossings, one per face.
  const std::vector<Crossing>& Crossings() const { return this->TheCrossings; }
  /// Returns the four nodes of a face (positions in Nodes()), in order around it.
  const std::array<int, 4>& CornersOfFace(Index face) const { return this->FaceNodes[face]; }
  /// Returns the position in FaceList() of the first face at the n-th node. Faces are ascending,
  /// and end where the faces of the next node begin.
  Index FaceOffset(Index n) const { return this->FacesOfNodes.Begin[n]; }
  const std::vector<int>& FaceList() const { return this->FacesOfNodes.Items; }

  /// Returns the position in Points() of the first surface point of the n-th node. Points are
  /// ascending by pair, and end where the points of the next node begin.
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
  using FaceAndNodes = std::pair<InterfaceFace, std::array<int, 4>>; // numbers of nodes
  void FindFaces(const LabelArray& labels, Runtime& runtime);
  void AddFace(const InterfaceFace& face, std::vector<FaceAndNodes>& faces) const;
  void FindSurfacePoints(Runtime& runtime);
  void SlideIntoDomain(Index node, const Vector3& x, SurfacePoint& point) const;
  void AddSurfacePoints(Index n, std::vector<SurfacePoint>& points) const;

  const CartesianGrid& TheGrid;
  double MeanWidth;
  std::vector<Index> MixedNodes;
  std::vector<InterfaceFace> TheFaces;
  std::vector<std::array<int, 4>> FaceNodes;
  std::vector<Crossing> TheCrossings;
  Groups<int> FacesOfNodes;
  std::vector<Index> PointsAt;
  std::vector<SurfacePoint> SurfacePoints;
};

} // namespace vfm
