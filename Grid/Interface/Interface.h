/**
 * The interfaces between labels: their faces, where the true interface crosses the dual edge of each
 * face, and the surface points fitted to those crossings.
 *
 * Frames. Grid coordinates: (x - lower corner of the domain) / CartesianGrid::MeanWidth, so that numbers
 * are near cell counts. Local frame of a node or cell: grid coordinates relative to it, divided by its
 * widths, one axis each, so that cells are unit cubes.
 *
 * A pair is two labels a < b. Its difference field is D = 2 (1 - vf_0 - isoValue) for a = 0, else vf_b - vf_a:
 * negative on the side of a. Normals point from a to b.
 */
#pragma once

#include "Base/Groups.h"
#include "Base/Runtime.h"
#include "Labels/InterfaceFaces.h"

namespace vfm
{

/// Where the interface crosses the dual edge of a face, grid coordinates.
struct Crossing
{
  Vector3 Point;
  Vector3 Normal; ///< unit
  double Weight;  ///< > 0, at most 1: the less of its cells the pair fills, the less
};

/// A pair of labels that meets at a surface node, and the point of its interface nearest to the node.
struct SurfacePoint
{
  int First, Second;
  Vector3 Point;  ///< grid coordinates
  Vector3 Normal; ///< unit, grid coordinates
};

class Interface
{
public:
  /// mixed: FindMixedNodes(grid, labels), after ResolveLabels, or some of them, ascending: then faces with a node that is not
  /// among them are left out. steps: cells, ascending, that have another label than their fractions tell because they are part of a
  /// coarser cell: their faces get the crossings of faces nearby (FindCrossingNear).
  Interface(const CartesianGrid& grid, const FractionField& fractions, const LabelArray& labels,
    std::vector<Index> mixed, double isoValue, Runtime& runtime,
    const std::vector<Index>& steps = {});

  const CartesianGrid& Grid() const { return this->TheGrid; }
  /// The mixed nodes, ascending.
  const std::vector<Index>& Nodes() const { return this->MixedNodes; }
  /// Position of a node in Nodes(), or -1.
  Index Find(Index node) const;

  const std::vector<InterfaceFace>& Faces() const { return this->TheFaces; }
  const std::vector<Crossing>& Crossings() const { return this->TheCrossings; }
  /// The four nodes of a face (positions in Nodes()), around it.
  const std::array<Index, 4>& CornersOfFace(Index face) const { return this->FaceNodes[face]; }
  /// Faces at the n-th node: FaceList()[FaceOffset(n) .. FaceOffset(n + 1)), ascending.
  Index FaceOffset(Index n) const { return this->FacesOfNodes.Begin[n]; }
  const std::vector<Index>& FaceList() const { return this->FacesOfNodes.Items; }

  /// Surface points of the n-th node: Points()[PointOffset(n) .. PointOffset(n + 1)), by pair.
  Index PointOffset(Index n) const { return this->PointsAt[n]; }
  const std::vector<SurfacePoint>& Points() const { return this->SurfacePoints; }
  /// The surface point of a pair at the n-th node, or nullptr.
  const SurfacePoint* FindPoint(Index n, int first, int second) const;

  /// Grid coordinates of a node, and the mean widths of its cells (clamped at the boundary).
  Vector3 NodePoint(Index node) const;
  Vector3 NodeWidths(Index node) const;
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
