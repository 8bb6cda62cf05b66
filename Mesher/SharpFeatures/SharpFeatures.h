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

namespace vfm
{

/// Model at a surface point, in the local frame of its node.
struct NodeFeature
{
  FeatureModel Model;
  Vector3 Origin, Widths; ///< grid coordinates of the interface; they define the frame
};

/// Models at the surface points of one interface that are near its edges and corners. Owns the
/// models; it does not change after construction.
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
  /// @param mode  Off: no models; On: models for all pairs of labels; Automatic: models only for
  ///   pairs whose samples show edges (SharpPairs.h)
  /// @pre Collective; mode is equal on all ranks.
  SharpFeatures(const Interface& interface, const FractionField& fractions,
    const SurfaceTargets& targets, Index firstTarget, SharpEdgeMode mode,
    const Partition& partition, Runtime& runtime);

  /// Returns the model at a surface point (position in Interface::Points()), or nullptr.
  const NodeFeature* Find(Index point) const
  {
    const auto at = std::lower_bound(this->Points.begin(), this->Points.end(), point);
    return at != this->Points.end() && *at == point ? &this->Models[at - this->Points.begin()]
                                                    : nullptr;
  }
  bool IsEmpty() const { return this->Points.empty(); }

  /// Stores given models, for tests and for features known from another source.
  /// @param points  positions in Interface::Points(), ascending
  /// @param models  one per point
  SharpFeatures(std::vector<Index> points, std::vector<NodeFeature> models) :
    Points(std::move(points)), Models(std::move(models))
  {
  }

private:
  std::vector<Index> Points;
  std::vector<NodeFeature> Models;
};

} // namespace vfm
