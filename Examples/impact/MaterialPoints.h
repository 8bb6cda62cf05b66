/**
 * MaterialPoints: points that move with the material and store its state, and the material law.
 *
 * Pressure: Mie-Grueneisen equation of state on the linear shock Hugoniot. Strength: J2 plasticity
 * with the hardening and a linear form of the thermal softening of Johnson and Cook (1983), without
 * dependence on rate. Failure: damage is plastic strain over a failure strain that decreases with
 * triaxiality (Hancock and Mackenzie 1976). A tension above the spall stress causes failure at
 * once. Failed points are rubble: they resist pressure, but neither tension nor shear.
 */
#pragma once

#include <array>

namespace impact
{

using Vector = std::array<double, 3>;

/// Index into the tables of materials and into the fields.
enum Body : int
{
  Ball = 0,
  Plate = 1,
  NumberOfBodies = 2
};

/// Constants of a material. Units: mm, microseconds, mg; therefore GPa, km/s and J/mg.
struct Material
{
  double Density;       ///< mg/mm^3 at rest
  double SoundSpeed;    ///< c0 of the shock Hugoniot us = c0 + s up
  double HugoniotSlope; ///< s
  double Grueneisen;
  double ShearModulus;
  double YieldStress, Hardening, HardeningExponent; ///< A, B, n of Johnson and Cook
  double MeltEnergy;    ///< energy per mass at which the yield stress, linear in energy, is 0
  double FailureStrain; ///< plastic strain at failure in pure shear
  double SpallStress;   ///< tension above which a point fails at once
};

extern const Material Materials[NumberOfBodies];

/// Returns the speed of longitudinal elastic waves.
double WaveSpeed(const Material& material);

/// State of a point. Trivially copyable, because ranks exchange the bytes.
struct MaterialPoint
{
  Vector Position;
  Vector Velocity;
  std::array<double, 9> Gradient; ///< velocity gradient by rows, d v_i / d x_j (the APIC matrix)
  std::array<double, 6> Deviator; ///< deviator of the Cauchy stress: xx yy zz xy yz xz
  Vector Size;                    ///< sides of its box: the sides at rest, stretched by the flow
  double Volume0;                 ///< volume at rest
  double Ratio;                   ///< current volume over Volume0
  double Energy;                  ///< internal energy per mass
  double Pressure;                ///< positive in compression
  double PlasticStrain;
  double Damage;    ///< 0 to 1; 1 is failed
  double Toughness; ///< local factor of FailureStrain and SpallStress
  int Owner;        ///< Body
  int Padding;

  const Material& GetMaterial() const { return Materials[this->Owner]; }
  double Mass() const { return this->GetMaterial().Density * this->Volume0; }
  bool IsFailed() const { return this->Damage >= 1.; }
};

/// Deforms the point by its velocity gradient for a time step and updates its stress.
/// @param[in] cellSize  length over which the artificial viscosity spreads shocks
void Deform(MaterialPoint& point, double timeStep, double cellSize);

/// Returns the sides of the axis-aligned box that the point covers in its current state.
Vector CoveredBox(const MaterialPoint& point);
/// Returns the volume of material in that box. It is the volume of the box, except for rubble that
/// has expanded and is partly void.
double CoveredVolume(const MaterialPoint& point);

} // namespace impact
