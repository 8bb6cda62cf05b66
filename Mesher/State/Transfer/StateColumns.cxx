#include "State/Transfer/StateColumns.h"

#include <algorithm>
#include <numeric>

namespace vfm
{

StateColumns::StateColumns(const std::vector<StateQuantity>& quantities, int density)
{
  std::vector<int> starts;
  for (const StateQuantity& quantity : quantities)
  {
    starts.push_back(this->QuantityCount);
    this->QuantityCount += quantity.Components;
  }
  const int count = this->QuantityCount + (density < 0);
  this->DensityColumn = density < 0 ? this->QuantityCount : starts[density];
  this->Constant.assign(count, 0);
  std::vector<int> depths;
  for (const StateQuantity& quantity : quantities)
  {
    const bool isPerMass = quantity.Kind == StateKind::PerMass;
    const int base = !isPerMass ? -1
      : quantity.Weight < 0     ? this->DensityColumn
                                : starts[quantity.Weight];
    this->Bases.insert(this->Bases.end(), quantity.Components, base);
    depths.insert(depths.end(), quantity.Components, !isPerMass ? 0 : quantity.Weight < 0 ? 1 : 2);
    if (isPerMass && quantity.Weight >= 0)
    {
      this->Constant[base] = 1;
    }
  }
  if (density < 0)
  {
    this->Bases.push_back(-1);
    depths.push_back(0);
  }
  this->Sequence.resize(count);
  std::iota(this->Sequence.begin(), this->Sequence.end(), 0);
  std::stable_sort(this->Sequence.begin(), this->Sequence.end(),
    [&depths](int a, int b) { return depths[a] < depths[b]; });
}

void StateColumns::FindContents(double volume, const double* values, double* contents) const
{
  for (int c : this->Sequence)
  {
    contents[c] = (this->Bases[c] < 0 ? volume : contents[this->Bases[c]]) * values[c];
  }
}

namespace
{

/// Returns the weighted mean of two values. It is computed from the value with the larger weight,
/// so that a value with a tiny weight causes no rounding error.
double MeanOf(double a, double weightA, double b, double weightB)
{
  const double sum = weightA + weightB;
  if (!(sum > 0.0))
  {
    return a;
  }
  return weightA < weightB ? b + weightA / sum * (a - b) : a + weightB / sum * (b - a);
}

} // namespace

void StateColumns::Mix(
  double& volume, double* values, double otherVolume, const double* others) const
{
  const std::size_t count = this->Bases.size();
  constexpr std::size_t Usual = 64;
  std::array<double, 2 * Usual> few;
  std::vector<double> many(count > Usual ? 2 * count : 0);
  double* mine = count > Usual ? many.data() : few.data();
  double* theirs = mine + count;
  this->FindContents(volume, values, mine);
  this->FindContents(otherVolume, others, theirs);
  for (int c : this->Sequence)
  {
    const int base = this->Bases[c];
    const double weight = base < 0 ? volume : mine[base];
    const double otherWeight = base < 0 ? otherVolume : theirs[base];
    const bool areWeights = weight >= 0.0 && otherWeight >= 0.0 && weight + otherWeight > 0.0;
    values[c] = areWeights ? MeanOf(values[c], weight, others[c], otherWeight)
                           : MeanOf(values[c], volume, others[c], otherVolume);
  }
  volume += otherVolume;
}

} // namespace vfm
