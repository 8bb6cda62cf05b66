/**
 * FeatureSearch: the model of several surfaces that explains the fractions around one surface point, where one surface does not.
 *
 * All lengths in cells; residuals are weighted rms of fractions (FeatureFit.h). A model is accepted by the fractions alone: where it is off by
 * less than .03, and by less than a third of what the quadric of the point and one fitted to the same fractions are off, each surface has an
 * area of two cells or more, and any two differ by 28 degrees.
 */
#pragma once

#include "Interface/SurfaceTargets.h"
#include "SharpFeatures/FeatureData.h"
#include "SharpFeatures/PackedCells.h"

#include <optional>

namespace vfm
{

constexpr double ExcellentResidual = 0.005; // below which nothing better is looked for

struct FittedFeature
{
  FeatureModel Model;
  double Residual = 1e30;
};

/// A model of another node, and where its node lies in this one's frame.
struct NearFeature
{
  const FittedFeature* Feature;
  Vector3 From;
};

/// What is searched through.
struct FeatureInput
{
  const Interface& Source;
  const FractionField& Fractions;
  const SurfaceTargets& Targets;
  Index FirstTarget; ///< that of the first of the interface's points
};

/// What models are fitted to and must be better than.
struct FitData
{
  const PackedCells& Cells;
  double Before;   ///< residual of the point's quadric
  double Accepted; ///< largest residual of a model
};

class FeatureSearch
{
public:
  /// node: position in Interface::Nodes(); point: in Points(), of that node. isSharp: the pair is known to have edges, so that models of less
  /// data are trusted. Keeps references.
  FeatureSearch(const FeatureInput& input, Index node, Index point, bool isSharp);

  /// How far the quadric of the point is off near it; 0 where the data does not tell.
  double NearResidual() const;

  /// Collects what is around; false: not enough of the pair.
  bool Gather();
  /// How far the quadric of the point is off, over all cells around. After Gather.
  double QuadricResidual() const { return this->Before; }

  /// The best model of planes that the crossings around tell.
  std::optional<FittedFeature> FromCrossings(FaceWalk& walk) const;
  /// The best of models of other nodes, sorted: the nearest first; fitted to the fractions here.
  std::optional<FittedFeature> FromModels(const std::vector<NearFeature>& others) const;
  /// The best model of the surfaces of other nodes' models.
  std::optional<FittedFeature> FromSurfaces(const std::vector<NearFeature>& others) const;

private:
  std::optional<FittedFeature> FromSeeds(const std::vector<LocalQuadric>& seeds) const;
  std::optional<FittedFeature> FitSeeds(
    const std::vector<LocalQuadric>& seeds, const FitData& data) const;
  bool IsAccepted(const FittedFeature& feature, const FitData& data) const;

  const FeatureInput& Input;
  Index Node;
  bool IsSharp;
  std::array<int, 2> Labels;
  NodeFrame Frame;
  LocalQuadric Quadric;
  std::vector<SampleCell> Around;
  PackedCells Packed; ///< the same
  double Before = 0.0;
};

} // namespace vfm
