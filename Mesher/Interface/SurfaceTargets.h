/**
 * SurfaceTargets: surfaces that attract surface nodes. Each surface node has, for each
 * pair of labels that meets there, a local model of the interface of the pair and the
 * signed distance to it.
 *
 * Quadric: w = c0 + c1 u + c2 v + c3 u^2 + c4 u v + c5 v^2 in a frame at the surface point. It is
 * fitted to the crossings of the faces of the pair within two rings of nodes, and continues
 * linearly beyond 1.5 cells. The fit uses crossings rather than surface points, because surface
 * points are means over tangent planes. Where the surface bends, they are off to one side, and more
 * so at a side of the domain, where all planes are on one side of the node.
 *
 * Facets: the quads between the surface points of the pair around the node, moved onto the quadrics
 * there and divided into triangles.
 *
 * Distances are in the local frame of the node (Interface.h), where a cell is a unit cube; positive
 * on the side of the second label.
 *
 * Interfaces may belong to several grids, each coarser than the next (LevelInterfaces.h). All
 * positions and gradients are then in grid coordinates of the last grid; distances stay in cells of
 * the grid of the target.
 */
#pragma once

#include "Base/Options.h"
#include "Interface/Interface.h"
#include "Interface/LocalQuadric.h"

namespace vfm
{

/// Targets of all surface points, numbered like Interface::Points(), the first interface first;
/// added targets follow. Threads may call const functions at the same time.
class SurfaceTargets
{
public:
  enum class Kind
  {
    Quadrics,
    Facets
  };

  /// Fits the targets of one interface; facets keep a reference to it.
  SurfaceTargets(const Interface& interface, Kind kind, Runtime& runtime);
  /// Fits the targets of the interfaces of several grids.
  /// @param interfaces  one or more, on grids of one domain, the finest
  ///   last; facets keep references
  SurfaceTargets(const std::vector<const Interface*>& interfaces, Kind kind, Runtime& runtime);

  /// Returns the number of targets.
  Index Count() const { return static_cast<Index>(this->Frames.size()); }

  /// Returns the signed distance of x to a target.
  /// @param x  grid coordinates
  /// @param[out] gradient  gradient in grid coordinates
  double Distance(Index target, const Vector3& x, Vector3& gradient) const;

  /// Begins to load a target.
  void Prefetch(Index target) const
  {
    const char* frame = reinterpret_cast<const char*>(&this->Frames[target]);
    for (std::size_t at = 0; at < sizeof(Frame); at += 64)
    {
      __builtin_prefetch(frame + at);
    }
  }

  /// Returns the fitted quadric in the local frame of a node.
  /// @param origin,widths  frame of the node, in grid coordinates of the finest grid
  LocalQuadric QuadricOf(Index target, const Vector3& origin, const Vector3& widths) const;
  /// Appends a quadric to targets of kind Quadrics and returns its number. It is used as given;
  /// fitted quadrics are shifted a little where they bend.
  /// @pre quadric.U and quadric.V are bitwise equal to those of MakeTangents
  Index Add(const LocalQuadric& quadric, const Vector3& origin, const Vector3& widths);
  /// Replaces a target by a quadric as in Add. Threads may replace different targets.
  /// @pre If all cells of a single grid have equal widths, these are given.
  void Replace(
    Index target, const LocalQuadric& quadric, const Vector3& origin, const Vector3& widths);

  /// Returns the number of units of Distance per unit of grid coordinates along the normal:
  /// distance = length * LocalScale.
  double LocalScale(Index target) const;

private:
  struct Level
  {
    const Interface* Source;
    double Ratio; // factor from its grid coordinates to the coordinates of the finest grid
    Index First;  // its first target
  };
  struct Frame
  {
    Vector3 Base;   // grid coordinates of the finest grid
    Vector3 N;      // unit vector of the local frame; MakeTangents finds the others
    double Tangent; // the first of them, which is orthogonal to an axis, as a number
    std::array<double, 6> C;
  };

  void StartWidths();
  void SetWidths(Index target, const Vector3& inverse);
  const Vector3& WidthsAt(Index target) const
  {
    return this->InverseWidths[this->HasEqualWidths ? 0 : target];
  }
  void FitLevel(const Level& level, Runtime& runtime);
  void FitQuadric(const Level& level, Index node, Index point, const std::vector<int>& faces);
  Vector3 FindCorner(const Level& level, Index node, Index point) const;
  const Level& LevelOf(Index target) const;
  double QuadricDistance(const Frame& frame, const Vector3& y, Vector3& gradient) const;
  double FacetDistance(Index target, const Vector3& y, Vector3& gradient) const;

  Kind TheKind;
  std::vector<Level> Levels;
  std::vector<Frame> Frames;
  // Inverse widths of the node of each target, in coordinates of the finest grid; if all are equal,
  // only one.
  bool HasEqualWidths = false;
  std::vector<Vector3> InverseWidths;
  std::vector<std::vector<int>> Facets; // interface faces around each target
  // Surface point of each target, moved onto its quadric; only for facets.
  std::vector<Vector3> Corners;
};

/// Returns the kind of targets that a smoothing method uses.
inline SurfaceTargets::Kind KindOfTargets(const MeshSettings& options)
{
  return options.Smoothing == SmoothingMethod::GeometryBased ? SurfaceTargets::Kind::Facets
                                                             : SurfaceTargets::Kind::Quadrics;
}

/// Returns whether mid nodes of interfaces leave the middles of edges.
inline bool HasCurvedEdges(const MeshSettings& options)
{
  return options.ElementOrder != InterpolationOrder::Linear && MovesPoints(options) &&
    KindOfTargets(options) == SurfaceTargets::Kind::Quadrics;
}

} // namespace vfm
