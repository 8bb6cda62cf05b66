/**
 * MaterialPoints: the state of a piece of material that moves with it, and the law that gives its
 * stress.
 *
 * Pressure: Mie-Grueneisen equation of state on the linear shock Hugoniot. Strength: J2 plasticity
 * with the hardening and a linear form of the thermal softening of Johnson and Cook (1983); no
 * dependence on rate. Failure: damage is plastic strain over a failure strain that falls with
 * triaxiality (Hancock and Mackenzie 1976), or at once when the tension passes the spall stress.
 * Failed points are rubble: pressure, but neither tension nor shear.
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

/// Units: mm, microseconds, mg; so GPa, km/s, and J/mg.
struct Material
{
  double Density;       ///< mg/mm^3 at rest
  double SoundSpeed;    ///< c0 of the shock Hugoniot us = c0 + s up
  double HugoniotSlope; ///< s
  double Grueneisen;
  double ShearModulus;
  double YieldStress, Hardening, HardeningExponent; ///< A, B, n of Johnson and Cook
  double MeltEnergy;    ///< per mass; the yield stress falls linearly to 0 there
  double FailureStrain; ///< plastic strain at failure in pure shear
  double SpallStress;   ///< tension that no point survives
};

extern const Material Materials[NumberOfBodies];

/// Speed of longitudinal elastic waves.
double WaveSpeed(const Material& material);

/// Plain data: ranks send it as it is.
struct MaterialPoint
{
  Vector Position;
  Vector Velocity;
  std::array<double, 9> Gradient; ///< of velocity, row by row: d v_i / d x_j (the APIC matrix)
  std::array<double, 6> Deviator; ///< of Cauchy stress: xx yy zz xy yz xz
  Vector Size;                    ///< sides of the box that it fills at rest, stretched since
  double Volume0;                 ///< at rest
  double Ratio;                   ///< current volume over Volume0
  double Energy;                  ///< internal, per mass
  double Pressure;                ///< positive in compression
  double PlasticStrain;
  double Damage;    ///< 0 to 1; from 1 on it has failed
  double Toughness; ///< local factor of FailureStrain and SpallStress
  int Owner;        ///< Body
  int Padding;

  const Material& GetMaterial() const { return Materials[this->Owner]; }
  double Mass() const { return this->GetMaterial().Density * this->Volume0; }
  bool IsFailed() const { return this->Damage >= 1.; }
};

/// Deforms the point by its velocity gradient for a time step and updates its stress. cellSize is
/// the length over which the artificial viscosity spreads shocks.
void Deform(MaterialPoint& point, double timeStep, double cellSize);

/// Sides of the axis-aligned box over which the point spreads now.
Vector CoveredBox(const MaterialPoint& point);
/// Volume of material in it: all of it, but rubble that has come apart is partly void.
double CoveredVolume(const MaterialPoint& point);

} // namespace impact
