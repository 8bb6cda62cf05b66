/**
 * Planes in cells (PLIC, piecewise linear interface calculation), in coordinates of the unit cell
 * centred at the origin.
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// The parts of the unit cell centred at the origin below parallel planes. Scardovelli and Zaleski,
/// Analytical relations connecting linear interfaces and volume fractions in rectangular grids,
/// J. Comput. Phys. 164 (2000) 228-237.
class CellBelowPlanes
{
public:
  /// @param n  normal of any length, not zero
  explicit CellBelowPlanes(const Vector3& n);

  /// Returns the volume where n.x < d.
  double Volume(double d) const;
  /// Returns the derivative of Volume.
  double Slope(double d) const;
  /// Returns the d with Volume(d) = fraction, by bisection to 1e-12 of the cell.
  double PlaneOf(double fraction) const;
  /// Returns the largest |d| of a plane that cuts the cell.
  double Reach() const { return 0.5 * this->Size; }

private:
  double VolumeAt(double alpha) const;
  void Narrow(double fraction, double& low, double& high) const;

  Vector3 M;   // magnitudes of n, ascending, of sum 1
  double Size; // their sum before
};

/// Returns the volume of the unit cell centred at the origin where n.x < d.
/// @param n  normal of any length, not zero
inline double VolumeBelowPlane(const Vector3& n, double d)
{
  return CellBelowPlanes(n).Volume(d);
}

/// Returns the d for which VolumeBelowPlane(n, d) = fraction, by bisection to 1e-12 of the cell.
inline double PlaneOfVolume(const Vector3& n, double fraction)
{
  return CellBelowPlanes(n).PlaneOf(fraction);
}

} // namespace vfm
