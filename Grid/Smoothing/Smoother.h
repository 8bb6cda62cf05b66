/**
 * Smoothing: the barrier energy of the elements and the squared distances of the surface points to their
 * targets, minimised point by point with Newton steps that keep every element positive.
 *
 * Points move by colour (parity of their grid node); points of one colour share no element, so the result
 * depends neither on the threads nor on the ranks, which exchange each colour. The points of one node move in order.
 *
 * What elements keep that the energy does not see (hexes: to be positive between their corners) is looked at after each stage. Where
 * it got lost the stage begins anew, and from then on each move is looked at.
 */
#pragma once

#include "Interface/SurfaceTargets.h"
#include "Smoothing/ElementEnergy.h"

#include <atomic>
#include <memory>

namespace vfm
{

class Smoother
{
public:
  /// targets: nullptr when nothing is attached.
  Smoother(
    ActiveMesh& mesh, const SurfaceTargets* targets, const ElementEnergy& energy, Runtime& runtime);

  /// report(fraction) is called after every sweep.
  void RunStage(const SmoothingStage& stage, const std::function<void(double)>& report);

  /// The same, stage by stage.
  void RunRamp(const SmoothingRamp& ramp);

  /// Has the point and its neighbours looked at in the next sweep.
  void MarkForUpdate(int point) { this->MarkNeighbours(point); }

  /// Whether an attachment may have an offset of up to a cell.
  using HasLongOffset = std::function<bool(const Attachment&)>;
  /// Adds to the offsets of the attachments (grid coordinates, towards the second label), then runs a stage from the points whose targets
  /// moved by a thousandth of a cell or more, and what they wake; whether there were some. Offsets stay within a quarter of a cell; long ones
  /// may be as far ahead of where their points have come, while the elements there are good by the energy of a stage.
  bool Follow(
    const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage);

  /// Moves every surface point by the shifts of its attachments along their normals (grid coordinates), at most
  /// a hundredth of a cell, where its elements stay as good by the energy of a stage.
  void MoveAlongNormals(const std::vector<double>& shifts, const SmoothingStage& stage);

  /// What was done so far on this rank.
  int Sweeps() const { return this->NumberOfSweeps; }
  Index Visits() const { return this->NumberOfVisits; }

private:
  void Shift(
    const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage);
  std::array<double, 2> LongRange(
    int point, const Attachment& a, const SmoothingStage& stage) const;
  void MoveAndCheck(const std::function<void()>& move);
  template <class Move>
  double ForPoints(const Move& move);
  void MoveAlongNormal(int point, const std::vector<double>& shifts, const SmoothingStage& stage);
  double Sweep(const SmoothingStage& stage);
  double MovePoint(int point, const SmoothingStage& stage);
  /// Whether the point is within the mesh's bounds, and still is when it has made a step.
  bool StaysWithin(int point, const Vector3& step) const
  {
    const Vector3 &x = this->Mesh.X[point], &low = this->Mesh.Lower, &high = this->Mesh.Upper;
    bool stays = true;
    for (int a = 0; a < 3; ++a)
    {
      const double to = x[a] + step[a];
      stays = stays & (x[a] > low[a]) & (x[a] < high[a]) & (to > low[a]) & (to < high[a]);
    }
    return stays;
  }
  int FixedAxes(int point, const Vector3& step) const;
  Vector3 Moved(int point, const Vector3& step) const;
  double DistanceEnergy(int point, const Vector3& x, double lambda) const;
  void AddDistance(int point, double lambda, Derivatives& d) const;
  bool MayMove(int point, const Vector3& x) const
  {
    return !this->IsGuarded || this->Energy.KeepsAt(this->Mesh, point, x);
  }
  void MarkNeighbours(int point);
  void MarkAll();
  void RunSweeps(const SmoothingStage& stage, const std::function<void(double)>& report);

  ActiveMesh& Mesh;
  const SurfaceTargets* Targets;
  const ElementEnergy& Energy;
  Runtime& Run;
  bool IsGuarded = false; // whether each move is looked at
  int NumberOfSweeps = 0;
  std::atomic<Index> NumberOfVisits{ 0 }; // of points in sweeps
  /// Set when a point of one of its elements moved since the point was last looked at.
  std::unique_ptr<unsigned char[]> Dirty;
  /// Set when the point woke its neighbours in this sweep.
  std::vector<unsigned char> Woke;
};

} // namespace vfm
