/**
 * FeatureSearch: finds a model of several surfaces that explains the fractions around one surface
 * point, where one surface does not.
 *
 * All lengths are in cells. Residuals are weighted rms errors of fractions (FeatureFit.h).
 * Acceptance depends on the fractions only:
 * - The residual is below 0.03.
 * - It is below a third of the residual of the quadric of the point, and of a quadric fitted
 *   to the same fractions.
 * - Each surface has an area of at least two cells.
 * - Any two surfaces differ by at least 28 degrees.
 * An edge that fills a gap between models is accepted below 0.05, and below half of the
 * residual of a quadric.
 */
#pragma once

#include "Interface/SurfaceTargets.h"
#include "SharpFeatures/FeatureData.h"
#include "SharpFeatures/PackedCells.h"

#include <optional>

namespace vfm
{

constexpr double ExcellentResidual = 0.005; // the search stops at a model below this residual

/// Model and its residual.
struct FittedFeature
{
  FeatureModel Model;
  double Residual = 1e30;
};

/// Model of another node.
struct NearFeature
{
  const FittedFeature* Feature;
  Vector3 From; ///< position of that node in the local frame of this one
};

/// Input of all searches.
struct FeatureInput
{
  const Interface& Source;
  const FractionField& Fractions;
  const SurfaceTargets& Targets;
  Index FirstTarget; ///< target of the interface's first surface point
};

/// Data that models are fitted to, and residuals that they must fall below.
struct FitData
{
  const PackedCells& Cells;
  double Before;   ///< residual of the point's quadric
  double Accepted; ///< largest residual of a model
};

/// Search at one surface point. Keeps references to its input; one thread uses it.
class FeatureSearch
{
public:
  /// @param input  must outlive the search
  /// @param node  position in Interface::Nodes()
  /// @param point  position in Interface::Points(), at that node
  /// @param isSharp  the pair is known to have edges, so models of less data are trusted
  FeatureSearch(const FeatureInput& input, Index node, Index point, bool isSharp);

  /// Returns the residual of the quadric of the point near it, or 0 if too few cells
  /// contain only the pair.
  double NearResidual() const;

  /// Accepts edges by the weaker limits of gaps.
  void AcceptInGap() { this->IsInGap = true; }

  /// Collects the cells around the point; returns false if too few contain only the pair.
  bool Gather();
  /// Returns the residual of the quadric of the point over all collected cells.
  /// @pre Gather() returned true.
  double QuadricResidual() const { return this->Before; }

  /// Returns the best model of planes that contain crossings around the point.
  /// @pre Gather() returned true, also for the next two.
  std::optional<FittedFeature> FromCrossings(FaceWalk& walk) const;
  /// Returns the best model of other nodes, fitted to the fractions here;
  /// others: the nearest first.
  std::optional<FittedFeature> FromModels(const std::vector<NearFeature>& others) const;
  /// Returns the best model made of surfaces of the models of other nodes.
  std::optional<FittedFeature> FromSurfaces(const std::vector<NearFeature>& others) const;

private:
  std::optional<FittedFeature> FromSeeds(const std::vector<LocalQuadric>& seeds) const;
  std::optional<FittedFeature> FitSeeds(
    const std::vector<LocalQuadric>& seeds, const FitData& data) const;
  bool IsAccepted(const FittedFeature& feature, const FitData& data) const;

  const FeatureInput& Input;
  Index Node;
  bool IsSharp;
  bool IsInGap = false;
  std::array<int, 2> Labels;
  NodeFrame Frame;
  LocalQuadric Quadric;
  std::vector<SampleCell> Around;
  PackedCells Packed; ///< the cells of Around in the layout of fits
  double Before = 0.0;
};

} // namespace vfm
