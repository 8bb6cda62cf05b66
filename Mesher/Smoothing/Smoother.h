/**
 * Smoother: minimises the barrier energy of the elements plus the squared distances of surface
 * points to their targets. Newton steps of one point at a time keep every element positive. Steps
 * that are too small to mark neighbours are taken without evaluating the energy.
 *
 * The first sweeps may be snaps: points move to the mean of their neighbours and onto their targets
 * as far as their elements stay good, which costs less than a Newton step and goes farther.
 *
 * Points move by colour, the parity of their grid node. Points of one colour share no element,
 * except points of one node, which move one after another. Ranks exchange the new positions after
 * each colour. So the result depends neither on threads nor on ranks.
 *
 * Some conditions on elements are not part of the energy: hexes must also be positive between their
 * corners (HexCoefficients.h). They are checked after each stage; where they are violated, points
 * start the stage again (Guard.h).
 *
 * Points near narrow void (NarrowVoid.h) stay within a cell of their start along each axis, or
 * three quarters if cells are not cubes, so that they do not pass the ends of the void elements
 * between bodies.
 */
#pragma once

#include "Elements/MeshReport.h"
#include "Interface/SurfaceTargets.h"
#include "Smoothing/Guard.h"

#include <atomic>
#include <memory>

namespace vfm
{

/// Moves the points of an ActiveMesh by threads of a Runtime. All ranks call its collective
/// functions in the same order.
class Smoother
{
public:
  /// Stores references to all arguments. Finds the rings of a hex mesh if it has none.
  /// @param targets  nullptr if no point is attached
  Smoother(
    ActiveMesh& mesh, const SurfaceTargets* targets, const ElementEnergy& energy, Runtime& runtime);

  /// Runs a stage: sweeps that move each marked point once. At first all points are marked. A point
  /// that moves far enough marks its neighbours again. The stage ends when no point has moved by
  /// SmoothingStage::SmallestMove, or after all sweeps.
  /// @param report  called after each sweep with the completed fraction of the sweeps
  /// @pre Collective.
  void RunStage(const SmoothingStage& stage, const std::function<void(double)>& report);

  /// Runs all stages of a ramp.
  /// @pre Collective.
  void RunRamp(const SmoothingRamp& ramp);

  /// Marks a point and its neighbours for the next sweep.
  void MarkForUpdate(int point) { this->MarkNeighbours(point); }
  /// Marks a point alone.
  void MarkPoint(int point) { this->Mark(point); }

  /// Function that returns whether an attachment may have a long offset, up to a cell width.
  using HasLongOffset = std::function<bool(const Attachment&)>;
  /// Adds shifts to the offsets of the attachments, then runs sweeps in which, at first, only
  /// points with a shift of at least 1e-3 mean cells and their neighbours are marked. An offset is
  /// limited to a quarter of a cell. A long offset is limited to one cell, and to a quarter of a
  /// cell beyond the present distance of its point from the target. It grows only if the energy of
  /// the elements at the point is at most 10. Shifts below 1e-5 mean cells are left out.
  /// @param shifts  shift of each attachment, grid coordinates, towards the second label
  /// @param isLong  selects the attachments with long offsets
  /// @return false if all shifts on all ranks were smaller; then no point was moved
  /// @pre Collective.
  bool Follow(
    const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage);

  /// Adds shifts to the offsets as Follow does and marks the points with a shift of at least 1e-3
  /// mean cells, without their neighbours, which follow if these points move far enough. In a
  /// report of RunStage, the stage goes on if points were marked on any rank.
  /// @pre Collective.
  void ShiftTargets(
    const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage);

  /// Moves each surface point by the shifts of its attachments along their normals, at most 0.01
  /// mean cells. A point does not move if the energy of its elements would grow by more than 5 %.
  /// @param shifts  shift of each attachment, grid coordinates
  /// @pre Collective.
  void MoveAlongNormals(const std::vector<double>& shifts, const SmoothingStage& stage);

  /// Ends intersections of facets next to void that is not meshed (Intersections.h): puts their
  /// points back to their start for good, with rings of points around, which then move again.
  /// @param moves  whether these and their neighbours move again
  /// @return whether any facets intersected; then points have moved
  /// @pre Collective.
  bool EndIntersections(const SmoothingStage& stage, bool moves);

  /// Return the arguments of the constructor.
  ActiveMesh& TheMesh() const { return this->Mesh; }
  const SurfaceTargets& TheTargets() const { return *this->Targets; }
  const ElementEnergy& TheEnergy() const { return this->Energy; }
  Runtime& TheRuntime() const { return this->Run; }
  /// Returns the number of sweeps so far.
  int Sweeps() const { return this->NumberOfSweeps; }
  /// Reports the points, the sweeps and the visits to points in them.
  /// @pre Collective.
  void ReportMoves(MeshReport& report) const;

  /// Returns whether each point may have moved since ForgetMoved; at first all.
  const std::vector<unsigned char>& MovedPoints()
  {
    this->ListMoved();
    return this->MovedSince;
  }
  void ForgetMoved()
  {
    this->ListMoved();
    std::fill(this->MovedSince.begin(), this->MovedSince.end(), 0);
  }
  /// Note that other code has moved points.
  void NoteMoved(const std::vector<int>& points)
  {
    for (int point : points)
    {
      this->HasMoved[point] = 1;
    }
    this->AlignColumns();
  }
  void NoteAllMoved() { std::fill(this->HasMoved.begin(), this->HasMoved.end(), 1); }

private:
  bool IsShifted(int point, const std::vector<double>& shifts) const;
  void Shift(
    const std::vector<double>& shifts, const HasLongOffset& isLong, const SmoothingStage& stage);
  std::array<double, 2> LongRange(
    int point, const Attachment& a, const SmoothingStage& stage) const;
  void MoveAndCheck(const std::function<void()>& move, const std::function<void()>& moveReturned);
  void SweepAndCheck(const SmoothingStage& stage, const std::function<void()>& sweep);
  void SweepWithChecks(const SmoothingStage& stage);
  template <class Move>
  double ForPoints(const unsigned char* where, const Move& move);
  void MoveAlongNormal(int point, const std::vector<double>& shifts, const SmoothingStage& stage);
  double Sweep(const SmoothingStage& stage);
  void Prefetch(int point) const;
  double MovePoint(int point, const SmoothingStage& stage);
  void SnapPoint(int point, const SmoothingStage& stage);
  Vector3 SnappedPosition(int point) const;
  /// Returns whether the point is strictly inside the bounds of the mesh, before and after a step.
  bool StaysWithin(int point, const Vector3& step) const
  {
    const MoveBounds& bounds = this->Mesh.BoundsOf(point);
    const Vector3 &x = this->Mesh.X[point], &low = bounds.Lower, &high = bounds.Upper;
    int stays = 1; // an integer: & without branches
    for (int a = 0; a < 3; ++a)
    {
      const double to = x[a] + step[a];
      stays = stays & (x[a] > low[a]) & (x[a] < high[a]) & (to > low[a]) & (to < high[a]);
    }
    return stays != 0;
  }
  int FixedAxes(int point, const Vector3& step) const;
  Vector3 AlongFreeAxes(int point, Vector3 step) const;
  Vector3 Moved(int point, const Vector3& step) const;
  double DistanceEnergy(int point, const Vector3& x, double lambda) const;
  void AddDistance(int point, double lambda, Derivatives& d) const;
  bool MayMove(int point, const Vector3& x) const
  {
    return this->Mesh.IsNearStart(point, x) &&
      (!(this->ChecksAll || this->TheGuard.Has(point)) ||
        this->Energy.KeepsAt(this->Mesh, point, x));
  }
  void Mark(int point) { __atomic_store_n(&this->Dirty[point], 1, __ATOMIC_RELAXED); }
  void MarkNeighbours(int point);
  void MarkAll();
  void ListMoved();
  void MarkReturned();
  /// Moves the upper points of columns after the lower ones.
  void AlignColumns()
  {
    this->Mesh.AlignColumns();
    for (const auto& [lower, upper] : this->Mesh.Columns)
    {
      this->HasMoved[upper] |= this->HasMoved[lower];
    }
  }
  void RunSweeps(const SmoothingStage& stage, const std::function<void(double)>& report);

  ActiveMesh& Mesh;
  const SurfaceTargets* Targets;
  const ElementEnergy& Energy;
  Runtime& Run;
  Guard TheGuard;
  bool ChecksAll = false; // whether each move is checked
  /// Set if targets were shifted and points marked since the last sweep.
  bool HasShifted = false;
  Index NumberOfPoints = 0;
  int NumberOfSweeps = 0;
  std::atomic<Index> NumberOfVisits{ 0 }; // visits to points in sweeps
  /// Set if a point of one of its elements has moved since the last visit.
  std::unique_ptr<unsigned char[]> Dirty;
  /// Set if the point marked its neighbours in this sweep.
  std::vector<unsigned char> Marked;
  /// Set if the point may have moved since ListMoved.
  std::vector<unsigned char> HasMoved;
  std::vector<unsigned char> MovedSince; // MovedPoints, without HasMoved
  /// Positions to which points go back. Kept between stages, because new memory takes time.
  std::vector<Vector3> Before;
  /// Active points that other ranks move.
  std::vector<int> Ghosts;
};

} // namespace vfm
