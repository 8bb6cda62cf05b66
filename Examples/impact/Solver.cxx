#include "Solver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace impact
{
namespace
{

constexpr int BodyChannels = 4; // mass and momentum
constexpr int Normal =
  NumberOfBodies * BodyChannels; // first moment of the ball's volume less the plate's
constexpr int Channels = Normal + 3;
constexpr double CourantNumber = .4;
constexpr double NormalQuanta = 0x1p40; // number of quanta in a cell's volume times its width
constexpr double FilledInContact = .75, Friction = .2;

constexpr double Quanta = 0x1p44; // number of quanta in a full cell; a sum can be 2^19 times larger

} // namespace

/// Weights of a point in the 27 cells around it, by quadratic B-splines.
struct Solver::Weights
{
  std::int64_t First;   // local index of the lowest cell
  double Values[3][3];  // weights by axis and cell
  double Offsets[3][3]; // offsets of cell centres from the point, by axis and cell

  Weights(const Domain& grid, const Vector& position)
  {
    const double spacing = grid.GetSpacing();
    Index3 cell = grid.CellOf(position);
    for (int a = 0; a < 3; ++a)
    {
      const double x = position[a] / spacing - (static_cast<double>(cell[a]) + .5); // -.5 to .5
      this->Values[a][0] = .5 * (.5 - x) * (.5 - x);
      this->Values[a][1] = .75 - x * x;
      this->Values[a][2] = .5 * (.5 + x) * (.5 + x);
      for (int i = 0; i < 3; ++i)
      {
        this->Offsets[a][i] = (i - 1 - x) * spacing;
      }
      --cell[a];
    }
    this->First = grid.Local(cell);
  }

  template <class Visit>
  void ForEach(const Index3& strides, Visit&& visit) const
  {
    for (int k = 0; k < 3; ++k)
    {
      for (int j = 0; j < 3; ++j)
      {
        const double weight = this->Values[2][k] * this->Values[1][j];
        const std::int64_t row = this->First + j * strides[1] + k * strides[2];
        for (int i = 0; i < 3; ++i)
        {
          visit(row + i, weight * this->Values[0][i],
            Vector{ this->Offsets[0][i], this->Offsets[1][j], this->Offsets[2][k] });
        }
      }
    }
  }
};

Solver::Solver(const Domain& domain, std::vector<MaterialPoint> points, double largestSpeed) :
  Grid(domain),
  Points(std::move(points)),
  Sums(Channels * domain.LocalSize()),
  Velocities(3 * NumberOfBodies * domain.LocalSize())
{
  const double cellVolume = std::pow(domain.GetSpacing(), 3);
  double waveSpeed = 0., density = 0.;
  for (const Material& material : Materials)
  {
    waveSpeed = std::max(waveSpeed, WaveSpeed(material));
    density = std::max(density, material.Density);
  }
  this->TimeStep = CourantNumber * domain.GetSpacing() / (waveSpeed + largestSpeed);
  this->MassQuantum = density * cellVolume / Quanta;
  this->MomentumQuantum = this->MassQuantum * (waveSpeed + largestSpeed);
}

void Solver::Step()
{
  this->Scatter();
  this->Grid.SumShared(this->Sums, Channels);
  this->UpdateGrid();
  this->Gather();
  this->Lost.Add(this->Grid.Migrate(this->Points));
}

void Solver::Scatter()
{
  std::fill(this->Sums.begin(), this->Sums.end(), 0);
  const double massScale = 1. / this->MassQuantum, scale = 1. / this->MomentumQuantum;
  const double spacing = this->Grid.GetSpacing();
  for (const MaterialPoint& p : this->Points)
  {
    const double mass = p.Mass();
    const double force = 4. * this->TimeStep * p.Volume0 * p.Ratio / (spacing * spacing);
    const auto& s = p.Deviator;
    const double stress[9] = { s[0] - p.Pressure, s[3], s[5], s[3], s[1] - p.Pressure, s[4], s[5],
      s[4], s[2] - p.Pressure };
    double affine[9], momentum[3];
    for (int i = 0; i < 9; ++i)
    {
      affine[i] = (mass * p.Gradient[i] - force * stress[i]) * scale;
    }
    for (int a = 0; a < 3; ++a)
    {
      momentum[a] = mass * p.Velocity[a] * scale;
    }
    const double quanta = mass * massScale;
    const double side =
      (p.Owner == Ball ? 1. : -1.) * p.Volume0 * NormalQuanta / std::pow(spacing, 4);
    Weights(this->Grid, p.Position)
      .ForEach(this->Grid.GetStrides(),
        [&](std::int64_t cell, double weight, const Vector& d)
        {
          std::int64_t* sums = this->Sums.data() + Channels * cell;
          std::int64_t* own = sums + BodyChannels * p.Owner;
          own[0] += std::llrint(weight * quanta);
          for (int a = 0; a < 3; ++a)
          {
            own[a + 1] += std::llrint(weight *
              (momentum[a] + affine[3 * a] * d[0] + affine[3 * a + 1] * d[1] +
                affine[3 * a + 2] * d[2]));
            sums[Normal + a] += std::llrint(weight * side * d[a]);
          }
        });
  }
}

void Solver::UpdateGrid()
{
  const double unit = this->MomentumQuantum / this->MassQuantum;
  const std::int64_t size = this->Grid.LocalSize();
  for (std::int64_t cell = 0; cell < size; ++cell)
  {
    const std::int64_t* sums = this->Sums.data() + Channels * cell;
    double* velocities = this->Velocities.data() + 3 * NumberOfBodies * cell;
    for (int body = 0; body < NumberOfBodies; ++body)
    {
      const std::int64_t* own = sums + BodyChannels * body;
      const double scale = own[0] > 0 ? unit / static_cast<double>(own[0]) : 0.;
      for (int a = 0; a < 3; ++a)
      {
        velocities[3 * body + a] = static_cast<double>(own[a + 1]) * scale;
      }
    }
    if (sums[0] > 0 && sums[BodyChannels] > 0)
    {
      this->Touch(sums, velocities);
    }
  }
}

/// Makes the normal velocities of both bodies equal where they approach each other in a filled
/// cell, and applies friction to the tangential velocities.
void Solver::Touch(const std::int64_t* sums, double* velocities) const
{
  const double ball = static_cast<double>(sums[0]), plate = static_cast<double>(sums[BodyChannels]);
  const double spacing = this->Grid.GetSpacing();
  const double filled = (ball / Materials[Ball].Density + plate / Materials[Plate].Density) *
    this->MassQuantum / (spacing * spacing * spacing);
  Vector normal, jump; // direction from ball to plate; velocity of the ball relative to the plate
  double length = 0., approach = 0.;
  for (int a = 0; a < 3; ++a)
  {
    normal[a] = static_cast<double>(sums[Normal + a]);
    length += normal[a] * normal[a];
    jump[a] = velocities[a] - velocities[3 + a];
  }
  if (filled < FilledInContact || length == 0.)
  {
    return;
  }
  for (int a = 0; a < 3; ++a)
  {
    normal[a] /= std::sqrt(length);
    approach += jump[a] * normal[a];
  }
  if (approach <= 0.)
  {
    return;
  }
  double slip = 0.;
  for (int a = 0; a < 3; ++a)
  {
    slip += (jump[a] - approach * normal[a]) * (jump[a] - approach * normal[a]);
  }
  slip = std::sqrt(slip);
  const double drag = slip > 0. ? std::min(1., Friction * approach / slip) : 0.;
  for (int a = 0; a < 3; ++a)
  {
    const double change = approach * normal[a] + drag * (jump[a] - approach * normal[a]);
    velocities[a] -= change * plate / (ball + plate);
    velocities[3 + a] += change * ball / (ball + plate);
  }
}

void Solver::Gather()
{
  const double spacing = this->Grid.GetSpacing();
  const double scale = 4. / (spacing * spacing);
  for (MaterialPoint& p : this->Points)
  {
    Vector mean{};
    std::array<double, 9> moment{};
    Weights(this->Grid, p.Position)
      .ForEach(this->Grid.GetStrides(),
        [&](std::int64_t cell, double weight, const Vector& d)
        {
          const double* velocity = this->Velocities.data() + 3 * (NumberOfBodies * cell + p.Owner);
          for (int a = 0; a < 3; ++a)
          {
            const double part = weight * velocity[a];
            mean[a] += part;
            for (int b = 0; b < 3; ++b)
            {
              moment[3 * a + b] += part * d[b];
            }
          }
        });
    p.Velocity = mean;
    for (int i = 0; i < 9; ++i)
    {
      p.Gradient[i] = moment[i] * scale;
    }
    for (int a = 0; a < 3; ++a)
    {
      const double move = this->TimeStep * mean[a];
      if (!(std::abs(move) < spacing))
      {
        throw std::overflow_error("unstable: a point moves by more than a cell in a step");
      }
      p.Position[a] += move;
    }
    Deform(p, this->TimeStep, spacing);
  }
}

std::array<Totals, NumberOfBodies> Solver::TotalsInside() const
{
  PointTotals totals;
  totals.Add(this->Points);
  return totals.Sum(this->Grid);
}

std::array<Totals, NumberOfBodies> Solver::TotalsOutside() const
{
  return this->Lost.Sum(this->Grid);
}

} // namespace impact
