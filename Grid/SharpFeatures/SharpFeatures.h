/**
 * SharpFeatures: edges and corners of interfaces that fractions alone tell. At each surface point where one quadric does not explain the
 * fractions around, up to three surfaces cut by each other are fitted to them, and kept where they explain them three times better.
 */
#pragma once

#include "Base/Options.h"
#include "Base/Partition.h"
#include "Fractions/FractionField.h"
#include "Interface/SurfaceTargets.h"
#include "SharpFeatures/FeatureModel.h"

namespace vfm
{

/// The model at a surface point, in the local frame of its node.
struct NodeFeature
{
  FeatureModel Model;
  Vector3 Origin, Widths; ///< of the frame: grid coordinates of the interface
};

class SharpFeatures
{
public:
  /// None.
  SharpFeatures() = default;
  /// interface: of the finest grid; targets: firstTarget is the first of the interface's points. Collective.
  SharpFeatures(const Interface& interface, const FractionField& fractions,
    const SurfaceTargets& targets, Index firstTarget, SharpEdges mode, const Partition& partition,
    Runtime& runtime);

  /// Of a surface point (position in Interface::Points()); nullptr: none.
  const NodeFeature* Find(Index point) const
  {
    const auto at = std::lower_bound(this->Points.begin(), this->Points.end(), point);
    return at != this->Points.end() && *at == point ? &this->Models[at - this->Points.begin()]
                                                    : nullptr;
  }
  bool IsEmpty() const { return this->Points.empty(); }

  /// For tests and what is known from elsewhere: the models of some points, ascending.
  SharpFeatures(std::vector<Index> points, std::vector<NodeFeature> models) :
    Points(std::move(points)), Models(std::move(models))
  {
  }

private:
  std::vector<Index> Points;
  std::vector<NodeFeature> Models;
};

} // namespace vfm
