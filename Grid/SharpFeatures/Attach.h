/**
 * Which points of a mesh carry edges and corners of interfaces (Rules.h), and what they are drawn to.
 */
#pragma once

#include "SharpFeatures/Rules.h"
#include "SharpFeatures/SharpFeatures.h"

namespace vfm
{

/// The models of an interface, and its first surface point among the targets.
struct InterfaceFeatures
{
  const SharpFeatures& Models;
  const Interface& Source;
  Index FirstTarget;
};

/// What a pair of labels at a point is drawn to in place of its quadric: so many surfaces of a model, each with this weight.
struct FeaturePull
{
  int Count = 0; ///< 0: it keeps its quadric
  std::array<Index, 3> Targets{};
  double Weight = 1.0; ///< of squared distances, against 1 of quadrics
};

struct FeaturePulls
{
  std::vector<FeaturePull> OfPairs;
  std::vector<FeatureKind> Kinds; ///< of each point, the same on all ranks that hold it
  std::vector<float>
    Bluntness; ///< of the sharpest edge that each point carries; 1: it carries none
};

/// Draws points near edges to the surfaces of the models of the surface points that they are attached to: carriers to those that
/// meet there. Appends these surfaces to the targets. Collective.
FeaturePulls PullToFeatures(const InterfaceFeatures& features, const SurfacePairs& pairs,
  const std::vector<Facet>& facets, SurfaceTargets& targets, Runtime& runtime);

} // namespace vfm
