/**
 * FeatureData: fractions of cells and crossings of faces around a node of an interface.
 */
#pragma once

#include "Fractions/FractionField.h"
#include "Interface/FaceWalk.h"
#include "SharpFeatures/FeatureModel.h"

namespace vfm
{

/// Local frame of a node (Interface.h).
struct NodeFrame
{
  Index3 Position;
  Vector3 Origin, Widths; ///< grid coordinates
};
/// Returns the local frame of a node, given by its position in Interface::Nodes().
NodeFrame FrameOf(const Interface& interface, Index node);

/// Cells around a node whose centres are within Reach, weighted by a Gaussian of width
/// Sigma; both in cells.
struct Stencil
{
  Index Radius; ///< number of cells to either side along each axis
  double Reach, Sigma;
};
constexpr Stencil InnerStencil{ 2, 2.0, 0.9 }, NarrowStencil{ 3, 2.3, 1.1 },
  WideStencil{ 3, 3.3, 1.5 };

/// Collects the cells of a stencil in the local box. Cells with less than 99 % of both labels
/// together are left out.
/// @param frame  local frame of the node
/// @param labels  pair of labels; fractions are the share of the second
/// @param[out] cells  positions are in the local frame
/// @return false if the cells left out have 70 % of the weight or more
bool GatherCells(const Interface& interface, const FractionField& fractions, const NodeFrame& frame,
  const std::array<int, 2>& labels, const Stencil& stencil, std::vector<SampleCell>& cells);

/// Returns the cells within a smaller stencil, with its weights.
std::vector<SampleCell> Narrowed(const std::vector<SampleCell>& cells, const Stencil& stencil);

/// Crossing in the local frame of a node.
struct LocalCrossing
{
  Vector3 Point, Normal; ///< unit
};
/// Collects the crossings of faces of a pair of labels at the node and at nodes up to two away
/// along each axis. Only faces connected to the node by at most three rings of such faces count.
/// @param node  position in Interface::Nodes()
/// @param[out] crossings  positions and normals are in the local frame
void GatherCrossings(const Interface& interface, const NodeFrame& frame, Index node,
  const std::array<int, 2>& labels, FaceWalk& walk, std::vector<LocalCrossing>& crossings);

/// Finds up to three planes that contain many crossings, the plane with most crossings first.
/// @return empty if fewer than 35 % of the crossings lie on these planes
std::vector<LocalQuadric> FindPlanes(const std::vector<LocalCrossing>& crossings);

} // namespace vfm
