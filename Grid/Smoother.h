/**
 * Smoothing: the barrier energy and the squared distances of the surface points to their targets,
 * minimised point by point with Newton steps that keep every corner determinant positive.
 *
 * Points move in eight colours (parity of their grid node); points of one colour share no hex, so the
 * result does not depend on the threads, nor on the ranks, which exchange each colour. Inside a grid node S moves first, then its I.
 */
#pragma once

#include "BarrierEnergy.h"
#include "PointExchange.h"
#include "SurfaceTargets.h"

#include <atomic>
#include <memory>

namespace vfm
{

/// One stage of the ramp from a soft to a hard barrier.
struct SmoothingStage
{
  int HalfPower; ///< p / 2 of the barrier
  double Lambda; ///< weight of the squared distances
  double Omega;  ///< weight of the shape term
  int Sweeps;
  double SmallestMove; ///< ends the stage when no point moved farther, in cells; 0: all sweeps
};

class Smoother
{
public:
  /// targetScaledJacobian: s* of the barrier.
  Smoother(ActiveMesh& mesh, const Interface& interface, const SurfaceTargets& targets,
    const PointExchange& exchange, double targetScaledJacobian, Runtime& runtime);

  /// report(fraction) is called after every sweep.
  void RunStage(const SmoothingStage& stage, const std::function<void(double)>& report);

  /// Moves every surface point by the shifts of its targets along their normals (grid coordinates), at most
  /// a hundredth of a cell, where its hexes stay as good.
  void Nudge(const std::vector<double>& shifts);

private:
  double ForPoints(const std::function<double(int)>& move);
  void NudgePoint(int point, const std::vector<double>& shifts);
  double Sweep(const SmoothingStage& stage);
  double MovePoint(int point, const SmoothingStage& stage);
  double DistanceEnergy(int point, const Vector3& x, double lambda) const;
  void AddDistance(int point, double lambda, Derivatives& d) const;
  void MarkNeighbours(int point);
  BarrierWeights WeightsOf(const SmoothingStage& stage) const;
  void MarkAll();

  ActiveMesh& Mesh;
  const Interface& TheInterface;
  const SurfaceTargets& Targets;
  const PointExchange& Exchange;
  double TargetJacobian;
  Runtime& Run;
  /// Set when a point of one of its hexes moved since the point was last looked at.
  std::unique_ptr<unsigned char[]> Dirty;
  /// Set when the point woke its neighbours in this sweep.
  std::vector<unsigned char> Woke;
};

/// The ramp of quadric surface smoothing.
const std::vector<SmoothingStage>& SmoothingRamp();

} // namespace vfm
