#include "State/Transfer/ElementState.h"

#include "Base/Lanes.h"

namespace vfm
{
namespace
{

constexpr int LaneCount = ElementLanes<double>::Count;

/// Returns the value of a column in a part.
VFM_INLINE double ValueIn(const StatePart& part, int column, int width)
{
  const double* line = part.Line + column;
  return part.Own[column] +
    (line[0] * part.X[0] + line[width] * part.X[1] + line[2 * width] * part.X[2] + line[3 * width]);
}
VFM_INLINE Lanes ValuesIn(const StatePart& part, int column, int width)
{
  const double* line = part.Line + column;
  return LoadLanes(part.Own + column) +
    (LoadLanes(line) * part.X[0] + LoadLanes(line + width) * part.X[1] +
      LoadLanes(line + 2 * width) * part.X[2] + LoadLanes(line + 3 * width));
}

VFM_INLINE Lanes Gather(const double* numbers, const int* places)
{
  return Lanes{ numbers[places[0]], numbers[places[1]], numbers[places[2]], numbers[places[3]] };
}

} // namespace

/// Sums the contents of all columns over the parts of an element, and divides them by the contents
/// of their bases, for any bases.
VFM_INLINE void ElementStates::SumElement(
  const StatePart* first, const StatePart* end, double* weights, double* found)
{
  const int width = this->Columns.Width(), slots = static_cast<int>(this->Bases.size());
  double* factor = this->Factors.data();
  for (const StatePart* part = first; part < end; ++part, factor += slots)
  {
    factor[0] = part->Volume;
    weights[0] += part->Inside;
    for (int s = 1; s < slots; ++s)
    {
      const int c = this->Bases[s];
      factor[s] = factor[this->Slots[c]] * ValueIn(*part, c, width);
      weights[s] += factor[s];
    }
  }
  for (int c = 0; c < width; c += LaneCount)
  {
    const int* places = this->Slots.data() + c;
    Lanes sum{};
    factor = this->Factors.data();
    for (const StatePart* part = first; part < end; ++part, factor += slots)
    {
      sum += Gather(factor, places) * ValuesIn(*part, c, width);
    }
    StoreLanes(sum / Gather(weights, places), found + c);
  }
}

VFM_INLINE void ElementStates::SumMany()
{
  const std::size_t width = this->Columns.Width(), slots = this->Bases.size();
  for (std::size_t i = 0; i + 1 < this->Firsts.size(); ++i)
  {
    this->SumElement(this->Parts.data() + this->Firsts[i], this->Parts.data() + this->Firsts[i + 1],
      this->Weights.data() + i * slots, this->Found.data() + i * width);
  }
}

/// The same sums if the only bases are volume and density, and there are few columns.
/// @param Groups  number of lanes of columns
template <int Groups>
VFM_INLINE void ElementStates::SumFew()
{
  constexpr int Width = Groups * LaneCount;
  const int density = this->Bases[1];
  Mask isPerMass[Groups];
  for (int g = 0; g < Groups; ++g)
  {
    isPerMass[g] = LoadLanes(this->IsPerMass.data() + g * LaneCount) < 0.0;
  }
  const std::size_t count = this->Firsts.size() - 1;
  for (std::size_t i = 0; i < count; ++i)
  {
    const StatePart* end = this->Parts.data() + this->Firsts[i + 1];
    Lanes sums[Groups]{};
    double volume = 0.0, mass = 0.0;
    for (const StatePart* part = this->Parts.data() + this->Firsts[i]; part < end; ++part)
    {
      Lanes values[Groups];
      double numbers[Width];
      for (int g = 0; g < Groups; ++g)
      {
        values[g] = ValuesIn(*part, g * LaneCount, Width);
        StoreLanes(values[g], numbers + g * LaneCount);
      }
      const double partMass = part->Volume * numbers[density];
      volume += part->Inside;
      mass += partMass;
      const Lanes ofVolume = Fill(part->Volume), ofMass = Fill(partMass);
      for (int g = 0; g < Groups; ++g)
      {
        sums[g] += (isPerMass[g] ? ofMass : ofVolume) * values[g];
      }
    }
    this->Weights[2 * i] = volume;
    this->Weights[2 * i + 1] = mass;
    const Lanes ofVolume = Fill(volume), ofMass = Fill(mass);
    for (int g = 0; g < Groups; ++g)
    {
      StoreLanes(sums[g] / (isPerMass[g] ? ofMass : ofVolume),
        this->Found.data() + i * Width + g * LaneCount);
    }
  }
}

// A call to another function would make GCC 12 leave out vzeroupper, which slows down all code that
// follows.
VFM_CLONES
void ElementStates::Sum()
{
  const int groups = this->Bases.size() == 2 ? this->Columns.Width() / LaneCount : 0;
  switch (groups)
  {
    case 1:
      return this->SumFew<1>();
    case 2:
      return this->SumFew<2>();
    case 3:
      return this->SumFew<3>();
    case 4:
      return this->SumFew<4>();
    default:
      return this->SumMany();
  }
}

ElementStates::ElementStates(const StateColumns& columns) :
  Columns(columns), Slots(columns.Width(), 0), Bases(1, -1), IsPerMass(columns.Width(), 0.0)
{
  this->FindSlot(columns.Density());
  for (int c : columns.Order())
  {
    this->Slots[c] = columns.Base(c) < 0 ? 0 : this->FindSlot(columns.Base(c));
    this->IsPerMass[c] = this->Slots[c] == 1 ? -1.0 : 0.0;
  }
}

/// Returns the slot of a base, which is made if there is none.
int ElementStates::FindSlot(int base)
{
  const auto at = std::find(this->Bases.begin(), this->Bases.end(), base);
  const int slot = static_cast<int>(at - this->Bases.begin());
  if (at == this->Bases.end())
  {
    this->Bases.push_back(base);
  }
  return slot;
}

void ElementStates::Clear()
{
  this->Parts.clear();
  this->Firsts.clear();
}

void ElementStates::Finish()
{
  const std::size_t count = this->Count(), slots = this->Bases.size();
  this->Start(); // the end of the last element
  this->Factors.resize(this->Parts.size() * slots);
  this->Weights.assign(count * slots, 0.0);
  this->Found.resize(count * this->Columns.Width());
  this->Sum();
  for (std::size_t i = 0; i < count; ++i)
  {
    const double* weights = this->Weights.data() + i * slots;
    if (std::all_of(weights, weights + slots, [](double weight) { return weight > 0.0; }))
    {
      continue;
    }
    for (int c = 0; c < this->Columns.Count(); ++c)
    {
      if (!(weights[this->Slots[c]] > 0.0))
      {
        this->Found[i * this->Columns.Width() + c] = this->FindMean(i, c);
      }
    }
  }
}

/// Returns the mean of a column over the volume, for elements without mass.
double ElementStates::FindMean(std::size_t i, int column) const
{
  double sum = 0.0, inside = 0.0;
  for (int p = this->Firsts[i]; p < this->Firsts[i + 1]; ++p)
  {
    const StatePart& part = this->Parts[p];
    sum += part.Inside * ValueIn(part, column, this->Columns.Width());
    inside += part.Inside;
  }
  return inside > 0.0 ? sum / inside : 0.0;
}

} // namespace vfm
