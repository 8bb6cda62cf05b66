/**
 * Guard: keeps conditions on elements that are not part of the energy (ElementEnergy::MarkLost).
 * They are checked after many moves. Where elements have lost them, points go back, and from then
 * on each move is checked there. Everywhere else points keep their places and move without checks.
 */
#pragma once

#include "Smoothing/ElementEnergy.h"

namespace vfm
{

/// Refers to all arguments of the constructor.
class Guard
{
public:
  Guard(const ActiveMesh& mesh, const ElementEnergy& energy, Runtime& runtime) :
    Mesh(mesh), Energy(energy), Run(runtime)
  {
  }

  /// Returns whether moves of a point are checked.
  bool Has(int point) const { return !this->Guarded.empty() && this->Guarded[point]; }

  /// Notes that points may have moved. PutBack looks only at elements at points that have moved
  /// since it looked last, and at those that it found then; at first at all.
  /// @param points  flags of all points
  void NoteMoved(const std::vector<unsigned char>& points);

  /// Puts points back where elements were lost, with two rings of points around. Then puts back the
  /// points of elements that this has lost, without rings, until no element is lost that was not
  /// lost before.
  /// @param before  positions of all points before they moved
  /// @param[in,out] points  positions of all points now
  /// @return false if no element was lost on any rank; then nothing changes
  /// @pre NoteMoved got all points that have moved. Collective.
  bool PutBack(const std::vector<Vector3>& before, std::vector<Vector3>& points);

  /// Puts points back, with two rings of points around, and more until all elements at these points
  /// are positive and no element is lost.
  /// @param points  flags of the points; those of ghosts are not used
  /// @param before,now  arguments of the other PutBack
  /// @param stage  determines how positive elements are checked
  /// @pre Collective.
  void PutBack(std::vector<unsigned char> points, const std::vector<Vector3>& before,
    std::vector<Vector3>& now, const SmoothingStage& stage);

  /// Returns whether the last call of PutBack put each point back.
  const std::vector<unsigned char>& Returned() const { return this->PutBackNow; }

private:
  using Flags = std::vector<unsigned char>; // of points

  bool MarkLost(const Flags& known, const Flags& returned, const Flags& where, Flags& lost) const;
  bool MarkNegative(const Flags& returned, const SmoothingStage& stage, Flags& lost) const;
  template <class FindMore>
  void Return(Flags& lost, const std::vector<Vector3>& before, std::vector<Vector3>& points,
    int laterRings, const FindMore& findMore);
  void Grow(int rings, Flags& flags) const;
  void Exchange(Flags& flags) const;

  const ActiveMesh& Mesh;
  const ElementEnergy& Energy;
  Runtime& Run;
  Flags Guarded, PutBackNow;
  Flags Unchecked; // points at which PutBack looks next; empty: all
};

} // namespace vfm
