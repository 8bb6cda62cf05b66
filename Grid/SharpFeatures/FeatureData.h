/**
 * What is known of an interface around one of its nodes: fractions of the cells, and crossings of its faces.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Interface/FaceWalk.h"
#include "SharpFeatures/FeatureModel.h"

namespace vfm
{

/// The local frame of a node (Interface.h).
struct NodeFrame
{
  Index3 Position;
  Vector3 Origin, Widths; ///< grid coordinates
};
NodeFrame FrameOf(const Interface& interface, Index node);

/// Cells around a node: centres within Reach, weighted by a Gaussian; both in cells.
struct Stencil
{
  Index Radius; ///< of the cells along each axis
  double Reach, Sigma;
};
constexpr Stencil InnerStencil{ 2, 2.0, 0.9 }, NarrowStencil{ 3, 2.3, 1.1 },
  WideStencil{ 3, 3.3, 1.5 };

/// The cells of a stencil in the domain, with the share of the second label among both. Those with other materials are left out; false: too many
/// of them.
bool GatherCells(const Interface& interface, const FractionField& fractions, const NodeFrame& frame,
  const std::array<int, 2>& labels, const Stencil& stencil, std::vector<SampleCell>& cells);

/// Those of the cells within a smaller stencil, weighted by it.
std::vector<SampleCell> Narrowed(const std::vector<SampleCell>& cells, const Stencil& stencil);

/// A crossing in the local frame of a node.
struct LocalCrossing
{
  Vector3 Point, Normal; ///< unit
};
/// Those of the faces of a pair at the node and at nodes two away along each axis that are reached over such faces.
void GatherCrossings(const Interface& interface, const NodeFrame& frame, Index node,
  const std::array<int, 2>& labels, FaceWalk& walk, std::vector<LocalCrossing>& crossings);

/// Up to three planes that many crossings lie on, the one with most first; none where most crossings lie on no plane.
std::vector<LocalQuadric> FindPlanes(const std::vector<LocalCrossing>& crossings);

} // namespace vfm
