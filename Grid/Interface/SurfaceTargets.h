/**
 * What surface nodes are drawn to: for every surface node and every pair of labels that meets there, a
 * local model of the pair's interface and the signed distance to it.
 *
 * Quadric: w = c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2 in a frame at the surface point, fitted to the
 * crossings of the pair's faces at the nodes within two rings of them; beyond 1.5 cells it continues linearly.
 * Not to surface points: those are means over tangent planes, off to one side where the surface bends, and more so
 * at a side of the domain, where all planes are on one side of the node.
 * Facets: the quads between the surface points of the pair around the node, moved onto the quadrics there, as triangles.
 *
 * Distances are in the node's local frame (Interface.h), where a cell is a unit cube; positive on the
 * side of the second label.
 *
 * Interfaces may be those of several grids, each coarser than the one after it (LevelInterfaces.h). All positions and gradients are then in
 * the grid coordinates of the last one; distances stay in cells of the target's own grid.
 */
#pragma once

#include "Base/Options.h"
#include "Interface/Interface.h"
#include "Interface/LocalQuadric.h"

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
  /// interfaces: of grids of the same domain, the finest last; at least one. Facets need them as long as the targets.
  SurfaceTargets(const std::vector<const Interface*>& interfaces, Kind kind, Runtime& runtime);

  /// Targets are numbered like Interface::Points(), those of the first interface first.
  Index Count() const { return static_cast<Index>(this->Frames.size()); }

  /// Signed distance of x (grid coordinates); gradient in grid coordinates.
  double Distance(Index target, const Vector3& x, Vector3& gradient) const;

  /// The quadric that was fitted, in the local frame of a node with such an origin and widths (grid coordinates of the finest grid).
  LocalQuadric QuadricOf(Index target, const Vector3& origin, const Vector3& widths) const;
  /// Appends a target, the quadric as it is: fitted ones stand off a little where they bend. Returns its number. Of quadrics only.
  Index Add(const LocalQuadric& quadric, const Vector3& origin, const Vector3& widths);

  /// The unit of Distance in grid coordinates, along the normal: distance = length * LocalScale.
  double LocalScale(Index target) const;

private:
  struct Level
  {
    const Interface* Source;
    double Ratio; // of its grid coordinates to those of the finest grid
    Index First;  // of its targets
  };
  struct Frame
  {
    Vector3 Base;          // grid coordinates of the finest grid
    Vector3 InverseWidths; // of the node's local frame, in the same
    Vector3 U, V, N;       // unit vectors of the local frame
    std::array<double, 6> C;
  };

  void FitLevel(const Level& level, Runtime& runtime);
  void FitQuadric(const Level& level, Index node, Index point, const std::vector<Index>& faces);
  Vector3 FindCorner(const Level& level, Index node, Index point) const;
  const Level& LevelOf(Index target) const;
  double QuadricDistance(const Frame& frame, const Vector3& y, Vector3& gradient) const;
  double FacetDistance(Index target, const Vector3& y, Vector3& gradient) const;

  Kind TheKind;
  std::vector<Level> Levels;
  std::vector<Frame> Frames;
  std::vector<std::vector<Index>> Facets; // faces of its interface around each target
  std::vector<Vector3> Corners; // of facets: each target's surface point moved onto its quadric
};

/// The kind of targets that the options ask for.
inline SurfaceTargets::Kind KindOfTargets(const MeshSettings& options)
{
  return options.Method == Smoothing::GeometryBased ? SurfaceTargets::Kind::Facets
                                                    : SurfaceTargets::Kind::Quadrics;
}

} // namespace vfm
