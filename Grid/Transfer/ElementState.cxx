#include "Transfer/ElementState.h"

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
    (line[0] * part.X[0] + line[width] * part.X[1] + line[2 * width] * part.X[2] +
      line[3 * width]);
}
VFM_INLINE Lanes ValuesIn(const StatePart& part, int column, int width)
{
  const double* line = part.Line + column;
  return LoadLanes(part.Own + column) +
    (LoadLanes(line) * part.X[0] + LoadLanes(line + width) * part.X[1] + LoadLanes(line + 2 * width) * part.X[2] +
      LoadLanes(line + 3 * width));
}

/// Sums the contents of all columns over parts.
/// @param width  StateColumns::Width()
/// @param slots  slot of each column, `width` numbers
/// @param factors  rows of the factors of each slot, `slotCount` numbers per part
VFM_CLONES
void SumContents(const StatePart* parts, std::size_t count, int width, const int* slots,
  const double* factors, std::size_t slotCount, double* contents)
{
  for (int c = 0; c < width; c += ElementLanes<double>::Count)
  {
    const int* slot = slots + c;
    Lanes sum{};
    const double* factor = factors;
    for (std::size_t p = 0; p < count; ++p, factor += slotCount)
    {
      const Lanes four{ factor[slot[0]], factor[slot[1]], factor[slot[2]], factor[slot[3]] };
      sum += four * ValuesIn(parts[p], c, width);
    }
    StoreLanes(sum, contents + c);
  }
}

} // namespace

ElementState::ElementState(const StateColumns& columns) :
  Columns(columns),
  Slots(columns.Width(), 0),
  Contents(columns.Width(), 0.0),
  Found(columns.Width(), 0.0)
{
  for (int c : columns.Order())
  {
    const int base = columns.Base(c);
    if (base >= 0)
    {
      const auto at = std::find(this->Multiplied.begin(), this->Multiplied.end(), base);
      this->Slots[c] = 1 + static_cast<int>(at - this->Multiplied.begin());
      if (at == this->Multiplied.end())
      {
        this->Multiplied.push_back(base);
      }
    }
  }
}

void ElementState::Finish()
{
  const int width = this->Columns.Width();
  const std::size_t slots = 1 + this->Multiplied.size();
  double inside = 0.0;
  this->Factors.resize(this->Parts.size() * slots);
  double* factor = this->Factors.data();
  for (const StatePart& part : this->Parts)
  {
    inside += part.Inside;
    factor[0] = part.Volume;
    for (std::size_t s = 1; s < slots; ++s)
    {
      const int c = this->Multiplied[s - 1];
      factor[s] = factor[this->Slots[c]] * ValueIn(part, c, width);
    }
    factor += slots;
  }
  SumContents(this->Parts.data(), this->Parts.size(), width, this->Slots.data(),
    this->Factors.data(), slots, this->Contents.data());
  for (int c = 0; c < this->Columns.Count(); ++c)
  {
    const int base = this->Columns.Base(c);
    const double weight = base < 0 ? inside : this->Contents[base];
    this->Found[c] = this->Contents[c] / weight;
    if (!(weight > 0.0))
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
