/**
 * ElementEnergy: the barrier energy against poor elements that smoothing minimises, as a function
 * of one point of the mesh. HexEnergy, TetEnergy and UntangleEnergy implement it.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

#include <limits>

namespace vfm
{

/// Step lengths, and the steps after which the neighbours of a point are visited again.
struct SmoothingPace
{
  /// Factor of Newton steps that is tried first.
  double Relaxation = 1.0;
  /// Largest factor of Newton steps where the barrier dominates.
  double LongestStretch = 1.0;
  /// Shorter steps, in cells, do not mark the neighbours.
  double MoveThatCounts = 0.005;
  /// Steps mark the neighbours only if they lower the energy at the point by at least
  /// FallThatCounts + PartThatCounts * energy.
  double FallThatCounts = 0.0;
  double PartThatCounts = 0.0;
};

/// Stage of the ramp from a soft to a hard barrier.
struct SmoothingStage
{
  int HalfPower; ///< p / 2 of the barrier, a power of two
  double Lambda; ///< weight of the squared distances
  double Omega;  ///< weight of the shape term
  int Sweeps;
  /// The stage ends when no point moved farther, in cells; 0: all sweeps run.
  double SmallestMove;
  SmoothingPace Pace{};
  /// Sweeps before the others that move points to the mean of their neighbours and onto their
  /// targets, without derivatives.
  int Snaps = 0;
};

using SmoothingRamp = std::vector<SmoothingStage>;

/// Value, gradient and Hessian (xx yy zz xy xz yz) of an energy with respect to one point.
struct Derivatives
{
  double Value = 0.0;
  Vector3 Gradient{ { 0.0, 0.0, 0.0 } };
  std::array<double, 6> Hessian{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
  /// Largest relative change of a determinant of the elements per length of a step; determinants
  /// are linear in the point. Infinite if not known.
  double Steepness = std::numeric_limits<double>::infinity();
};

/// Energy at positions where an element is not positive.
constexpr double InvalidEnergy = 1e300;

/// Interface of the energies of elements. All functions are called by several threads at once.
class ElementEnergy
{
public:
  virtual ~ElementEnergy() = default;
  /// Returns the energy of the elements at an active point for position x.
  virtual double Evaluate(
    const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const = 0;
  /// Returns the energy and its derivatives for the current position of an active point.
  /// @pre The elements at the point are positive.
  virtual Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const = 0;

  /// Marks the points of the elements of this rank that do not meet the conditions that the energy
  /// does not contain.
  /// @param returned  whether each point went back to an earlier position; empty: none. Elements
  /// of which only some active points went back must meet stricter conditions.
  /// @param where  elements without a flagged active point may be left out; empty: none
  /// @param[in,out] points  flags of all points
  /// @return whether there is such an element
  virtual bool MarkLost(const ActiveMesh&, Runtime&, const std::vector<unsigned char>& /*returned*/,
    const std::vector<unsigned char>& /*where*/, std::vector<unsigned char>& /*points*/) const
  {
    return false;
  }
  /// Returns whether the elements at a point meet these conditions for position x.
  virtual bool KeepsAt(const ActiveMesh&, int, const Vector3&) const { return true; }
};

} // namespace vfm
