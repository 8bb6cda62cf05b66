/**
 * The energy that smoothing minimises, as a function of one point of the mesh: a barrier against bad elements.
 * HexEnergy and TetEnergy give it.
 */
#pragma once

#include "Smoothing/ActiveMesh.h"

namespace vfm
{

/// How far points step, and after which steps their neighbours are looked at again.
struct SmoothingPace
{
  double Relaxation = 1.0;       ///< factor of Newton steps, tried first
  double LongestStretch = 1.0;   ///< their largest factor where the barrier rules
  double MoveThatCounts = 0.005; ///< shorter steps, in cells, wake no neighbour
  double FallThatCounts = 0.0;   ///< nor do those by which the energy at the point falls by less,
  double PartThatCounts = 0.0;   ///< together with this part of that energy
};

/// One stage of the ramp from a soft to a hard barrier.
struct SmoothingStage
{
  int HalfPower; ///< p / 2 of the barrier, a power of two
  double Lambda; ///< weight of the squared distances
  double Omega;  ///< weight of the shape term
  int Sweeps;
  double SmallestMove; ///< ends the stage when no point moved farther, in cells; 0: all sweeps
  SmoothingPace Pace{};
};

using SmoothingRamp = std::vector<SmoothingStage>;

/// Derivatives of an energy in one point: value, gradient, Hessian (xx yy zz xy xz yz).
struct Derivatives
{
  double Value = 0.0;
  Vector3 Gradient{ { 0.0, 0.0, 0.0 } };
  std::array<double, 6> Hessian{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
};

/// The energy where an element is not positive.
constexpr double InvalidEnergy = 1e300;

class ElementEnergy
{
public:
  virtual ~ElementEnergy() = default;
  /// Of the elements at an active point when it stands at x.
  virtual double Evaluate(
    const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const = 0;
  /// The same at its present place, with derivatives. There the elements must be positive.
  virtual Derivatives Differentiate(
    const ActiveMesh& mesh, int point, const SmoothingStage& stage) const = 0;

  /// What moves must keep although the energy does not see it. Of all elements on this rank.
  virtual bool IsKept(const ActiveMesh&, Runtime&) const { return true; }
  /// Of those at a point, when it stands at x.
  virtual bool KeepsAt(const ActiveMesh&, int, const Vector3&) const { return true; }
};

} // namespace vfm
