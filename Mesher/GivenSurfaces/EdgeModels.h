/**
 * EdgeModels: models of the sharp edges and corners of a given surface near a node.
 */
#pragma once

#include "GivenSurfaces/SampleFit.h"
#include "SharpFeatures/FeatureModel.h"

namespace vfm
{

/// What a model is made of: surface, edges and corners near a node, in its local frame. Normals
/// point to the second label; an edge is convex if the second label fills less than 180 degrees.
struct NodeSurroundings
{
  std::vector<NearSample> Samples;
  std::vector<NearEdge> Edges;
  std::vector<NearCorner> Corners;
};

/// Model of edges near a node.
struct EdgeModel
{
  FeatureModel Model;
  bool Fades; ///< the nearest edge has one sheet on both sides
};

/// Distance of edges and corners for which models are made, in cells.
constexpr double EdgeReach = 2.3, CornerReach = EdgeReach + 0.5;

/// Makes the model of the edge nearest to a node: two sides, and a third side of a corner or of
/// another edge, if more samples of the surface then lie where the second label ends.
/// @param normal  of the interface at the node, towards the second label; edges without a side that
///   faces this way are ignored
/// @return nothing if there is no edge, or no two sides have enough samples
std::optional<EdgeModel> MakeEdgeModel(const NodeSurroundings& around, const Vector3& normal);

} // namespace vfm
