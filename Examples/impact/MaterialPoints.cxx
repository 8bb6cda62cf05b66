#include "MaterialPoints.h"

#include <algorithm>
#include <cmath>

namespace impact
{
namespace
{

constexpr double LinearViscosity = .15, QuadraticViscosity = 1.5;
constexpr double TriaxialityFactor = 1.5, TriaxialityLimit = 1.5;
constexpr double SmallestRatio = .3, LargestStretch = 1.8;

/// Returns W s - s W for the spin W: the rotation of the deviator with the material (Jaumann rate).
std::array<double, 6> SpinTerm(const std::array<double, 9>& l, const std::array<double, 6>& s)
{
  const double xy = .5 * (l[1] - l[3]), yz = .5 * (l[5] - l[7]), xz = .5 * (l[2] - l[6]);
  return { 2. * (xy * s[3] + xz * s[5]), 2. * (yz * s[4] - xy * s[3]),
    -2. * (xz * s[5] + yz * s[4]), xy * (s[1] - s[0]) + xz * s[4] + yz * s[5],
    yz * (s[2] - s[1]) - xy * s[5] - xz * s[3], xz * (s[2] - s[0]) + xy * s[4] - yz * s[3] };
}

std::array<double, 6> StrainRateDeviator(const std::array<double, 9>& l)
{
  const double mean = (l[0] + l[4] + l[8]) / 3.;
  return { l[0] - mean, l[4] - mean, l[8] - mean, .5 * (l[1] + l[3]), .5 * (l[5] + l[7]),
    .5 * (l[2] + l[6]) };
}

double Contract(const std::array<double, 6>& a, const std::array<double, 6>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2. * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

double EquationOfState(const Material& m, double ratio, double energy)
{
  const double bulk = m.Density * m.SoundSpeed * m.SoundSpeed;
  const double thermal = m.Grueneisen * m.Density * energy;
  if (ratio >= 1.)
  {
    return bulk * (1. / ratio - 1.) + thermal;
  }
  const double strain = std::min(1. - ratio, .8 / m.HugoniotSlope);
  const double slowed = 1. - m.HugoniotSlope * strain;
  return bulk * strain * (1. - .5 * m.Grueneisen * strain) / (slowed * slowed) + thermal;
}

double YieldStress(const MaterialPoint& p)
{
  const Material& m = p.GetMaterial();
  const double softening = std::clamp(1. - p.Energy / m.MeltEnergy, 0., 1.);
  return softening * (m.YieldStress + m.Hardening * std::pow(p.PlasticStrain, m.HardeningExponent));
}

/// Moves the stress back to the yield surface (radial return). Returns the plastic strain.
double ReturnToYield(MaterialPoint& p)
{
  const double stress = std::sqrt(1.5 * Contract(p.Deviator, p.Deviator));
  const double yield = YieldStress(p);
  if (stress <= yield)
  {
    return 0.;
  }
  for (double& s : p.Deviator)
  {
    s *= yield / stress;
  }
  const double strain = (stress - yield) / (3. * p.GetMaterial().ShearModulus);
  p.PlasticStrain += strain;
  return strain;
}

void Wear(MaterialPoint& p, double plasticStrain)
{
  const Material& m = p.GetMaterial();
  if (plasticStrain > 0.)
  {
    const double yield = std::max(YieldStress(p), 1e-3 * m.YieldStress);
    const double triaxiality = std::clamp(-p.Pressure / yield, -TriaxialityLimit, TriaxialityLimit);
    const double strain = m.FailureStrain * std::exp(-TriaxialityFactor * triaxiality);
    p.Damage += plasticStrain / (p.Toughness * strain);
  }
  if (p.Pressure < -p.Toughness * m.SpallStress)
  {
    p.Damage = 1.;
  }
  p.Damage = std::min(p.Damage, 1.);
}

void Stretch(MaterialPoint& p, double timeStep)
{
  if (p.IsFailed())
  {
    p.Size.fill(std::cbrt(p.Volume0));
    return;
  }
  for (int a = 0; a < 3; ++a)
  {
    p.Size[a] *= std::exp(timeStep * p.Gradient[4 * a]);
  }
}

} // namespace

// Brittle aluminium and hard steel; Impact.h gives the sources.
const Material Materials[NumberOfBodies] = {
  { 2.785, 5.328, 1.338, 2.0, 27.6, .4, 0., 1., 1., .1, 1. },
  { 7.83, 4.569, 1.49, 1.93, 80., 1.6, .5, .3, .7, .8, 3. },
};

double WaveSpeed(const Material& m)
{
  return std::sqrt(m.SoundSpeed * m.SoundSpeed + 4. / 3. * m.ShearModulus / m.Density);
}

void Deform(MaterialPoint& p, double timeStep, double cellSize)
{
  const Material& m = p.GetMaterial();
  const double rate = p.Gradient[0] + p.Gradient[4] + p.Gradient[8];
  const std::array<double, 6> strainRate = StrainRateDeviator(p.Gradient);
  const double oldRatio = p.Ratio;
  p.Ratio = std::max(SmallestRatio, p.Ratio * std::exp(timeStep * rate));
  p.Energy +=
    (timeStep * oldRatio * Contract(p.Deviator, strainRate) - p.Pressure * (p.Ratio - oldRatio)) /
    m.Density;

  double plasticStrain = 0.;
  if (!p.IsFailed())
  {
    const std::array<double, 6> spin = SpinTerm(p.Gradient, p.Deviator);
    for (int i = 0; i < 6; ++i)
    {
      p.Deviator[i] += timeStep * (2. * m.ShearModulus * strainRate[i] + spin[i]);
    }
    plasticStrain = ReturnToYield(p);
  }
  p.Pressure = EquationOfState(m, p.Ratio, p.Energy);
  if (!p.IsFailed())
  {
    Wear(p, plasticStrain);
  }
  if (p.IsFailed())
  {
    p.Deviator.fill(0.);
    p.Pressure = std::max(0., p.Pressure);
  }
  if (rate < 0.)
  {
    const double step = -rate * cellSize;
    p.Pressure +=
      m.Density / p.Ratio * step * (LinearViscosity * m.SoundSpeed + QuadraticViscosity * step);
  }
  Stretch(p, timeStep);
}

Vector CoveredBox(const MaterialPoint& p)
{
  const double side = std::cbrt(p.Volume0);
  Vector box;
  for (int a = 0; a < 3; ++a)
  {
    box[a] = std::clamp(p.Size[a], side / LargestStretch, side * LargestStretch);
  }
  const double scale = std::cbrt(p.Volume0 * p.Ratio / (box[0] * box[1] * box[2]));
  for (double& length : box)
  {
    length *= scale;
  }
  return box;
}

double CoveredVolume(const MaterialPoint& p)
{
  return p.Volume0 * (p.IsFailed() ? std::min(1., p.Ratio) : p.Ratio);
}

} // namespace impact
