#include "VolumeFractions.h"

#include <algorithm>
#include <cmath>

namespace impact
{
namespace
{

enum Channel : int
{
  BallVolume,
  PlateVolume,
  Mass,
  Momentum, // 3
  Wear = Momentum + 3,
  Channels
};

constexpr double Quanta = 0x1p40;    // a full cell of volume; a mg; a mg km/s
constexpr double Rounding = 0x1p-30; // of sums of quanta
constexpr int SpreadRounds = 12;
constexpr double TakesExcess = .5; // a cell that holds less has a surface far inside
constexpr double NearlyFull = .8;

} // namespace

VolumeFractions::VolumeFractions(const Domain& domain) :
  Grid(domain),
  Sums(Channels * domain.LocalSize()),
  Volumes(NumberOfBodies * domain.LocalSize()),
  Outflow(domain.LocalSize())
{
  Fields& f = this->Result;
  f.Spacing.fill(domain.GetSpacing());
  f.GlobalCells = domain.GetCells();
  f.Lower = domain.GetLower();
  f.Upper = domain.GetUpper();
  f.Neighbours = domain.GetNeighbours();
  for (std::vector<double>* values : { &this->Ball, &this->Plate, &this->Density, &this->Damage })
  {
    values->resize(f.NumberOfCells());
  }
  this->Velocity.resize(3 * f.NumberOfCells());
  f.Ball = this->Ball.data();
  f.Plate = this->Plate.data();
  f.Velocity = this->Velocity.data();
  f.Density = this->Density.data();
  f.Damage = this->Damage.data();
}

const Fields& VolumeFractions::Compute(
  const std::vector<MaterialPoint>& points, std::int64_t step, double time)
{
  this->Cover(points);
  this->Grid.SumShared(this->Sums, Channels);
  this->Read();
  for (int round = 0; round < SpreadRounds; ++round)
  {
    this->SpreadExcess();
  }
  this->FillGaps();
  this->Write();
  this->Result.Step = step;
  this->Result.Time = time;
  return this->Result;
}

/// Boxes are shorter than two cells, so that they reach no further than the neighbours of the point's cell.
void VolumeFractions::Cover(const std::vector<MaterialPoint>& points)
{
  std::fill(this->Sums.begin(), this->Sums.end(), 0);
  const double spacing = this->Grid.GetSpacing();
  for (const MaterialPoint& p : points)
  {
    const Vector box = CoveredBox(p);
    const Index3 cell = this->Grid.CellOf(p.Position);
    double part[3][3]; // of the box's side, in the three cells along each axis
    for (int a = 0; a < 3; ++a)
    {
      const double side = std::min(box[a] / spacing, 1.99);
      const double low = p.Position[a] / spacing - static_cast<double>(cell[a]) - .5 * side;
      const double high = low + side;
      part[a][0] = std::max(0., -low) / side;
      part[a][2] = std::max(0., high - 1.) / side;
      part[a][1] = 1. - part[a][0] - part[a][2];
    }
    const double volume = CoveredVolume(p) / (spacing * spacing * spacing) * Quanta;
    const double mass = p.Mass() * Quanta;
    for (int n = 0; n < 27; ++n)
    {
      const int i = n % 3, j = n / 3 % 3, k = n / 9;
      const double weight = part[0][i] * part[1][j] * part[2][k];
      if (weight > 0.)
      {
        std::int64_t* sums = this->Sums.data() +
          Channels * this->Grid.Local({ cell[0] + i - 1, cell[1] + j - 1, cell[2] + k - 1 });
        sums[BallVolume + p.Owner] += std::llrint(weight * volume);
        sums[Mass] += std::llrint(weight * mass);
        sums[Wear] += std::llrint(weight * mass * p.Damage);
        for (int a = 0; a < 3; ++a)
        {
          sums[Momentum + a] += std::llrint(weight * mass * p.Velocity[a]);
        }
      }
    }
  }
}

void VolumeFractions::Read()
{
  for (std::int64_t cell = 0; cell < this->Grid.LocalSize(); ++cell)
  {
    for (int body = 0; body < NumberOfBodies; ++body)
    {
      this->Volumes[NumberOfBodies * cell + body] =
        static_cast<double>(this->Sums[Channels * cell + BallVolume + body]) / Quanta;
    }
  }
  this->Grid.FillGhosts(this->Volumes, NumberOfBodies); // drops what lies outside of the grid
}

double VolumeFractions::Total(std::int64_t cell) const
{
  return this->Volumes[NumberOfBodies * cell] + this->Volumes[NumberOfBodies * cell + 1];
}

template <class Visit>
void VolumeFractions::ForEachNeighbour(std::int64_t cell, Visit&& visit) const
{
  for (std::int64_t stride : this->Grid.GetStrides())
  {
    visit(cell - stride);
    visit(cell + stride);
  }
}

/// A cell over 1 gives its excess to its neighbours in proportion to their room, with the mixture that it has itself.
void VolumeFractions::SpreadExcess()
{
  const auto room = [this](std::int64_t cell)
  {
    const double total = this->Total(cell);
    return total > TakesExcess ? std::max(0., 1. - total) : 0.;
  };
  std::fill(this->Outflow.begin(), this->Outflow.end(), 0.);
  this->Grid.ForEachCell(
    [&](const Index3&, std::int64_t cell)
    {
      double rooms = 0.;
      this->ForEachNeighbour(cell, [&](std::int64_t other) { rooms += room(other); });
      const double excess = this->Total(cell) - 1.;
      if (excess > Rounding && rooms > Rounding)
      {
        this->Outflow[cell] = std::min(1., excess / rooms);
      }
    });
  this->Grid.FillGhosts(this->Outflow, 1);
  std::vector<double> next = this->Volumes;
  this->Grid.ForEachCell(
    [&](const Index3&, std::int64_t cell)
    {
      this->ForEachNeighbour(cell,
        [&](std::int64_t other)
        {
          const double in = this->Outflow[other] * room(cell) / std::max(1., this->Total(other));
          const double out = this->Outflow[cell] * room(other) / std::max(1., this->Total(cell));
          for (int body = 0; body < NumberOfBodies; ++body)
          {
            next[NumberOfBodies * cell + body] +=
              in * this->Volumes[NumberOfBodies * other + body] -
              out * this->Volumes[NumberOfBodies * cell + body];
          }
        });
    });
  this->Volumes.swap(next);
  this->Grid.FillGhosts(this->Volumes, NumberOfBodies);
}

void VolumeFractions::FillGaps()
{
  std::vector<double> next = this->Volumes;
  this->Grid.ForEachCell(
    [&](const Index3&, std::int64_t cell)
    {
      double least = this->Total(cell);
      this->ForEachNeighbour(
        cell, [&](std::int64_t other) { least = std::min(least, this->Total(other)); });
      if (least > NearlyFull || this->Total(cell) > 1. - Rounding)
      {
        for (int body = 0; body < NumberOfBodies; ++body)
        {
          next[NumberOfBodies * cell + body] /= this->Total(cell);
        }
      }
    });
  this->Volumes.swap(next);
}

void VolumeFractions::Write()
{
  const double spacing = this->Grid.GetSpacing();
  const double cellVolume = spacing * spacing * spacing;
  std::int64_t n = 0;
  this->Grid.ForEachCell(
    [&](const Index3&, std::int64_t cell)
    {
      const std::int64_t* sums = this->Sums.data() + Channels * cell;
      const double mass = static_cast<double>(sums[Mass]);
      this->Ball[n] = this->Volumes[NumberOfBodies * cell + impact::Ball];
      this->Plate[n] = this->Volumes[NumberOfBodies * cell + impact::Plate];
      this->Density[n] = mass / Quanta / cellVolume;
      this->Damage[n] = mass > 0. ? static_cast<double>(sums[Wear]) / mass : 0.;
      for (int a = 0; a < 3; ++a)
      {
        this->Velocity[3 * n + a] = mass > 0. ? static_cast<double>(sums[Momentum + a]) / mass : 0.;
      }
      ++n;
    });
}

} // namespace impact
