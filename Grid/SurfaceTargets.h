/**
 * What surface nodes are drawn to: for every surface node and every pair of labels that meets there, a
 * local model of the pair's interface and the signed distance to it.
 *
 * Quadric: w = c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2 in a frame at the surface point, fitted to the
 * surface points of the pair within two rings of interface faces; beyond 1.5 cells it continues linearly.
 * Facets: the quads between the surface points of the pair around the node, as triangles.
 *
 * Distances are in the node's local frame (Interface.h), where a cell is a unit cube; positive on the
 * side of the second label.
 */
#pragma once

#include "Interface.h"

namespace vfm
{

class SurfaceTargets
{
public:
  enum class Kind
  {
    Quadrics,
    Facets
  };

  SurfaceTargets(const Interface& interface, Kind kind, Runtime& runtime);

  /// Targets are numbered like Interface::Points().
  Index Count() const { return static_cast<Index>(this->Frames.size()); }

  /// Signed distance of x (grid coordinates); gradient in grid coordinates.
  double Distance(Index target, const Vector3& x, Vector3& gradient) const;

  /// The unit of Distance in grid coordinates, along the normal: distance = length * LocalScale.
  double LocalScale(Index target) const;

private:
  struct Frame
  {
    Vector3 Base;          // grid coordinates
    Vector3 InverseWidths; // of the node's local frame
    Vector3 U, V, N;       // unit vectors of the local frame
    std::array<double, 6> C;
  };

  void FitQuadric(Index node, Index target);
  void FindFacets(Index node, Index target);
  double QuadricDistance(const Frame& frame, const Vector3& y, Vector3& gradient) const;
  double FacetDistance(Index target, const Vector3& y, Vector3& gradient) const;

  const Interface& TheInterface;
  Kind TheKind;
  std::vector<Frame> Frames;
  std::vector<std::vector<Index>> Facets; // interface faces around each target
};

} // namespace vfm
