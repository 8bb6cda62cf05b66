/**
 * Attach: selects the mesh points that carry edges and corners of interfaces (Rules.h), and the
 * surfaces that attract them during smoothing.
 */
#pragma once

#include "SharpFeatures/Rules.h"
#include "SharpFeatures/SharpFeatures.h"

namespace vfm
{

/// Sharp features of interfaces.
struct InterfaceFeatures
{
  const SharpFeatures& Models;
  std::vector<const Interface*> Sources; ///< of one or more levels, the finest last
  Index FirstTarget;                     ///< target of the first surface point of Sources

  /// Returns the labels of the pair of a target, or -1 if it belongs to another level.
  std::array<int, 2> LabelsOf(Index target) const;
};

/// Surfaces of a model that attract a point for one pair of labels, in place of the
/// quadric of the pair.
struct FeaturePull
{
  int Count = 0;                  ///< number of surfaces; 0: the pair keeps its quadric
  std::array<Index, 3> Targets{}; ///< of the surfaces, Count of them
  double Weight = 1.0;            ///< weight of squared distances; the weight of quadrics is 1
};

/// Result of PullToFeatures.
struct FeaturePulls
{
  std::vector<FeaturePull> OfPairs; ///< one per pair; Count is 0 at points that other ranks move
  std::vector<FeatureKind> Kinds;   ///< kind of each point, equal on all ranks that hold it
  /// Whether each point has a model of an edge that fades out.
  std::vector<unsigned char> Fade;
  /// Bluntness of the sharpest edge that each point carries; 1: it carries no edge.
  std::vector<float> Bluntness;
};

/// Finds the surfaces that attract the points near sharp features. A carrier is attracted to all
/// surfaces that meet at its edge or corner, a side point to its side. The model is that of the
/// surface point that the pair is attached to.
/// @param pairs  surface points of the mesh in their initial position
/// @param facets  surface facets of this rank
/// @param[in,out] targets  the surfaces are appended
/// @pre Collective.
FeaturePulls PullToFeatures(const InterfaceFeatures& features, const SurfacePairs& pairs,
  const std::vector<Facet>& facets, SurfaceTargets& targets, Runtime& runtime);

} // namespace vfm
