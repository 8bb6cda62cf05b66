/**
 * SharpFeatures: edges and corners of interfaces, found from the volume fractions. A model consists
 * of up to three surfaces that cut each other (FeatureModel.h). Models are fitted at each surface
 * point where one quadric does not explain the fractions nearby. A model is kept if its error is
 * less than a third of the error of one quadric.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Partition.h"
#include "Fractions/FractionField.h"
#include "Interface/SurfaceTargets.h"
#include "SharpFeatures/FeatureModel.h"
#include "SharpFeatures/FeatureSites.h"

namespace vfm
{

/// Model at a surface point, in the local frame of its node.
struct NodeFeature
{
  FeatureModel Model;
  Vector3 Origin, Widths; ///< grid coordinates of the interface; they define the frame
  bool Fades = false;     ///< the edge of a given surface fades out: one sheet is on both sides
};

/// Models at the surface points of interfaces that are near their edges and corners, by their
/// targets. Owns the models; it does not change after construction.
class SharpFeatures
{
public:
  /// Makes an object without models.
  SharpFeatures() = default;
  /// Finds the models at the owned surface points, and at points of other ranks within two nodes of
  /// them (FeatureSites::Spread).
  /// @param interface  interface of the finest grid
  /// @param fractions  fractions that the interface was made from, owned and ghost cells
  /// @param targets  fitted quadrics of the surface points
  /// @param firstTarget  index in `targets` of the target of the interface's first surface point
  /// @param isSought  pairs of labels that may have models
  /// @param mode  Off: no models; On: models for all pairs of labels; Automatic: models only for
  ///   pairs whose samples show edges (SharpPairs.h)
  /// @pre Collective; mode is equal on all ranks.
  SharpFeatures(const Interface& interface, const FractionField& fractions,
    const SurfaceTargets& targets, Index firstTarget, const PairFilter& isSought,
    SharpEdgeMode mode, const Partition& partition, Runtime& runtime);

  /// Returns the model at the surface point of a target, or nullptr.
  const NodeFeature* Find(Index target) const
  {
    const auto at = std::lower_bound(this->Targets.begin(), this->Targets.end(), target);
    return at != this->Targets.end() && *at == target ? &this->Models[at - this->Targets.begin()]
                                                      : nullptr;
  }
  bool IsEmpty() const { return this->Targets.empty(); }

  /// Stores given models.
  /// @param targets  of surface points, ascending
  /// @param models  one per target
  SharpFeatures(std::vector<Index> targets, std::vector<NodeFeature> models) :
    Targets(std::move(targets)), Models(std::move(models))
  {
  }
  /// Adds the models of other targets.
  void Add(const SharpFeatures& other);

private:
  std::vector<Index> Targets;
  std::vector<NodeFeature> Models;
};

} // namespace vfm
