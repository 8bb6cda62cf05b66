/**
 * PortableMath: elementary functions with the same bits on every machine.
 *
 * C libraries round these functions differently, and glibc uses other code on processors without
 * fused multiply-add. The functions here use only operations that IEEE 754 defines to the last bit,
 * in a fixed order. Errors in units in the last place: Exp and CubeRoot below 1, Sine and Cosine
 * below 2, ArcTangent below 3.
 *
 * Range reduction: W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980.
 */
#pragma once

namespace vfm
{

constexpr double Pi = 3.14159265358979323846;

double Exp(double x);
double CubeRoot(double x);
///@{ x in radians, at most 1e5 in magnitude.
double Sine(double x);
double Cosine(double x);
///@}
/// Returns the angle of (x, y) from the x axis, in [-Pi, Pi].
double ArcTangent(double y, double x);

/// Returns x to the third power.
inline double Cube(double x)
{
  return x * x * x;
}

} // namespace vfm
