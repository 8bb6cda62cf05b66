#include "VolumeFractions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace impact
{
namespace
{

/// Sums of a body in a cell. All except the volume are mass times a mean.
enum Channel : int
{
  Volume,
  Mass,
  Momentum, // 3
  Wear = Momentum + 3,
  PlainChannels,
  Energy = PlainChannels, // kinetic plus internal
  Ratio,
  Deviator, // 6
  PlasticStrain = Deviator + 6,
  Toughness,
  StateChannels
};

struct State
{
  const char* Name;
  int Channel, Components;
};

constexpr State ListedStates[] = { { "density", Mass, 1 }, { "velocity", Momentum, 3 },
  { "energy", Energy, 1 }, { "ratio", Ratio, 1 }, { "deviator", Deviator, 6 },
  { "plastic_strain", PlasticStrain, 1 }, { "damage", Wear, 1 }, { "toughness", Toughness, 1 } };
constexpr int NumberOfStates = static_cast<int>(std::size(ListedStates));

constexpr double VolumeQuanta = 0x1p40;  // number of quanta in a full cell
constexpr double Quanta = 0x1p52;        // number of quanta per mg, also times the unit of a mean
constexpr double Rounding = 0x1p-29;     // bound of the rounding of sums of quanta
constexpr double SmallestPart = 0x1p-20; // smallest part of a box side that a cell receives
constexpr int SpreadRounds = 12;
constexpr double TakesExcess = .5; // a cell below it contains a surface and takes no excess
constexpr double NearlyFull = .8;

/// Returns 0 for a part below SmallestPart. It is due to rounding, and readers that ignore tiny
/// fractions would lose its mass.
double CutOff(double part)
{
  return part > SmallestPart ? part : 0.;
}

double KineticEnergy(const Vector& v)
{
  return .5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Returns the contribution of a point to each of StateChannels, in quanta.
std::array<double, StateChannels> ListContents(const MaterialPoint& p, double cellVolume)
{
  const double mass = p.Mass() * Quanta;
  std::array<double, StateChannels> contents;
  contents[Volume] = CoveredVolume(p) / cellVolume * VolumeQuanta;
  contents[Mass] = mass;
  contents[Wear] = mass * p.Damage;
  contents[Energy] = mass * (p.Energy + KineticEnergy(p.Velocity));
  contents[Ratio] = mass * CoveredVolume(p) / p.Volume0; // excludes void, as does the density
  contents[PlasticStrain] = mass * p.PlasticStrain;
  contents[Toughness] = mass * p.Toughness;
  for (int a = 0; a < 3; ++a)
  {
    contents[Momentum + a] = mass * p.Velocity[a];
  }
  for (int i = 0; i < 6; ++i)
  {
    contents[Deviator + i] = mass * p.Deviator[i];
  }
  return contents;
}

} // namespace

VolumeFractions::VolumeFractions(const Domain& domain, bool withState) :
  Grid(domain),
  WithState(withState),
  Channels(withState ? StateChannels : PlainChannels),
  Moved(withState ? StateChannels : 1),
  Sums(NumberOfBodies * Channels * domain.LocalSize()),
  Flowing(NumberOfBodies * Moved * domain.LocalSize()),
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
  for (int n = 0; withState && n < NumberOfBodies * NumberOfStates; ++n)
  {
    const State& state = ListedStates[n % NumberOfStates];
    this->States.emplace_back(state.Components * f.NumberOfCells());
    f.States.push_back({ std::string(state.Name) + " - " + std::to_string(n / NumberOfStates + 1),
      state.Components, this->States.back().data() });
  }
}

const Fields& VolumeFractions::Compute(
  const std::vector<MaterialPoint>& points, std::int64_t step, double time)
{
  this->Cover(points);
  this->Grid.SumShared(this->Sums, NumberOfBodies * this->Channels);
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

/// Adds the contribution of each point to the cells that its box overlaps. Boxes are shorter than
/// two cells, so that they reach only the neighbours of the point's cell.
void VolumeFractions::Cover(const std::vector<MaterialPoint>& points)
{
  std::fill(this->Sums.begin(), this->Sums.end(), 0);
  const double spacing = this->Grid.GetSpacing();
  for (const MaterialPoint& p : points)
  {
    const Vector box = CoveredBox(p);
    const Index3 cell = this->Grid.CellOf(p.Position);
    double part[3][3]; // part of the box side in each of three cells, by axis
    for (int a = 0; a < 3; ++a)
    {
      const double side = std::min(box[a] / spacing, 1.99);
      const double low = p.Position[a] / spacing - static_cast<double>(cell[a]) - .5 * side;
      const double high = low + side;
      part[a][0] = CutOff(-low / side);
      part[a][2] = CutOff((high - 1.) / side);
      part[a][1] = 1. - part[a][0] - part[a][2];
    }
    const std::array<double, StateChannels> contents = ListContents(p, spacing * spacing * spacing);
    for (int n = 0; n < 27; ++n)
    {
      const int i = n % 3, j = n / 3 % 3, k = n / 9;
      const double weight = part[0][i] * part[1][j] * part[2][k];
      const std::int64_t at =
        this->Grid.Local({ cell[0] + i - 1, cell[1] + j - 1, cell[2] + k - 1 });
      std::int64_t* sums = this->Sums.data() + this->Channels * (NumberOfBodies * at + p.Owner);
      for (int c = 0; weight > 0. && c < this->Channels; ++c)
      {
        sums[c] += std::llrint(weight * contents[c]);
      }
    }
  }
}

void VolumeFractions::Read()
{
  for (std::int64_t n = 0; n < NumberOfBodies * this->Grid.LocalSize(); ++n)
  {
    for (int c = 0; c < this->Moved; ++c)
    {
      this->Flowing[this->Moved * n + c] = static_cast<double>(this->Sums[this->Channels * n + c]) /
        (c == impact::Volume ? VolumeQuanta : Quanta);
    }
  }
  // This also drops material outside of the grid.
  this->Grid.FillGhosts(this->Flowing, NumberOfBodies * this->Moved);
}

const double* VolumeFractions::Contents(std::int64_t cell, int body) const
{
  return this->Flowing.data() + this->Moved * (NumberOfBodies * cell + body);
}

double VolumeFractions::Total(std::int64_t cell) const
{
  return this->Volume(cell, impact::Ball) + this->Volume(cell, impact::Plate);
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

/// Moves the excess of each cell above 1 to its neighbours, in proportion to their free volume. The
/// bodies move in the proportion in which the cell contains them.
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
  std::vector<double> next = this->Flowing;
  const int count = NumberOfBodies * this->Moved;
  this->Grid.ForEachCell(
    [&](const Index3&, std::int64_t cell)
    {
      this->ForEachNeighbour(cell,
        [&](std::int64_t other)
        {
          const double in = this->Outflow[other] * room(cell) / std::max(1., this->Total(other));
          const double out = this->Outflow[cell] * room(other) / std::max(1., this->Total(cell));
          for (int c = 0; (in > 0. || out > 0.) && c < count; ++c)
          {
            next[count * cell + c] +=
              in * this->Flowing[count * other + c] - out * this->Flowing[count * cell + c];
          }
        });
    });
  this->Flowing.swap(next);
  this->Grid.FillGhosts(this->Flowing, count);
}

void VolumeFractions::FillGaps()
{
  std::vector<double> next = this->Flowing;
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
          next[this->Moved * (NumberOfBodies * cell + body)] /= this->Total(cell);
        }
      }
    });
  this->Flowing.swap(next);
}

void VolumeFractions::Write()
{
  std::int64_t place = 0;
  this->Grid.ForEachCell(
    [&](const Index3&, std::int64_t cell)
    {
      this->WriteMeans(cell, place);
      for (int body = 0; this->WithState && body < NumberOfBodies; ++body)
      {
        this->WriteStates(body, cell, place);
      }
      ++place;
    });
}

/// Writes means over both bodies.
void VolumeFractions::WriteMeans(std::int64_t cell, std::int64_t place)
{
  const std::int64_t* ball = this->Sums.data() + this->Channels * NumberOfBodies * cell;
  const auto sum = [&](int channel)
  { return static_cast<double>(ball[channel] + ball[this->Channels + channel]); };
  const double mass = sum(Mass), scale = mass > 0. ? 1. / mass : 0.;
  this->Ball[place] = this->Volume(cell, impact::Ball);
  this->Plate[place] = this->Volume(cell, impact::Plate);
  this->Density[place] = mass / Quanta / std::pow(this->Grid.GetSpacing(), 3);
  this->Damage[place] = scale * sum(Wear);
  for (int a = 0; a < 3; ++a)
  {
    this->Velocity[3 * place + a] = scale * sum(Momentum + a);
  }
}

void VolumeFractions::WriteStates(int body, std::int64_t cell, std::int64_t place)
{
  const double* contents = this->Contents(cell, body);
  const double mass = contents[Mass];
  const double volume = contents[impact::Volume] * std::pow(this->Grid.GetSpacing(), 3);
  std::array<double, StateChannels> means{};
  if (mass > 0. && volume > 0.)
  {
    std::transform(
      contents, contents + StateChannels, means.begin(), [&](double x) { return x / mass; });
    means[Energy] -= KineticEnergy({ means[Momentum], means[Momentum + 1], means[Momentum + 2] });
    means[Mass] = mass / volume;
  }
  for (int n = 0; n < NumberOfStates; ++n)
  {
    const State& state = ListedStates[n];
    std::copy_n(means.data() + state.Channel, state.Components,
      this->States[body * NumberOfStates + n].data() + state.Components * place);
  }
}

} // namespace impact
