#include "State/Transfer/ElementState.h"

#include "Base/Lanes.h"

namespace vfm
{
namespace
{

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

/// Sums the contents of all columns over the parts, and divides them by the contents of their
/// bases. Returns whether all of these are positive.
VFM_CLONES
bool ElementState::Sum()
{
  const int width = this->Columns.Width(), slots = static_cast<int>(this->Bases.size());
  double* weights = this->Factors.data(); // contents of the bases
  std::fill_n(weights, slots, 0.0);
  double* factor = weights;
  for (const StatePart& part : this->Parts)
  {
    factor += slots;
    factor[0] = part.Volume;
    weights[0] += part.Inside;
    for (int s = 1; s < slots; ++s)
    {
      const int c = this->Bases[s];
      factor[s] = factor[this->Slots[c]] * ValueIn(part, c, width);
      weights[s] += factor[s];
    }
  }
  for (int c = 0; c < width; c += ElementLanes<double>::Count)
  {
    const int* places = this->Slots.data() + c;
    Lanes sum{};
    factor = weights;
    for (const StatePart& part : this->Parts)
    {
      factor += slots;
      sum += Gather(factor, places) * ValuesIn(part, c, width);
    }
    StoreLanes(sum / Gather(weights, places), this->Found.data() + c);
  }
  // A call here would make GCC 12 leave out vzeroupper, which slows down all code that follows.
  bool arePositive = true;
  for (int s = 0; s < slots; ++s)
  {
    arePositive = arePositive && weights[s] > 0.0;
  }
  return arePositive;
}

ElementState::ElementState(const StateColumns& columns) :
  Columns(columns), Slots(columns.Width(), 0), Bases(1, -1), Found(columns.Width(), 0.0)
{
  this->FindSlot(columns.Density());
  for (int c : columns.Order())
  {
    this->Slots[c] = columns.Base(c) < 0 ? 0 : this->FindSlot(columns.Base(c));
  }
}

/// Returns the slot of a base, which is made if there is none.
int ElementState::FindSlot(int base)
{
  const auto at = std::find(this->Bases.begin(), this->Bases.end(), base);
  const int slot = static_cast<int>(at - this->Bases.begin());
  if (at == this->Bases.end())
  {
    this->Bases.push_back(base);
  }
  return slot;
}

void ElementState::Finish()
{
  this->Factors.resize((this->Parts.size() + 1) * this->Bases.size());
  if (this->Sum())
  {
    return;
  }
  for (int c = 0; c < this->Columns.Count(); ++c)
  {
    if (!(this->Factors[this->Slots[c]] > 0.0))
    {
      this->FindMean(c);
    }
  }
}

/// Sets the value of a column to the mean over the volume, for elements without mass.
void ElementState::FindMean(int column)
{
  double sum = 0.0, inside = 0.0;
  for (const StatePart& part : this->Parts)
  {
    sum += part.Inside * ValueIn(part, column, this->Columns.Width());
    inside += part.Inside;
  }
  this->Found[column] = inside > 0.0 ? sum / inside : 0.0;
}

} // namespace vfm
