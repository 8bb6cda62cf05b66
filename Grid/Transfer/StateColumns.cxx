#include "Transfer/StateColumns.h"

#include <algorithm>
#include <numeric>

namespace vfm
{

StateColumns::StateColumns(const std::vector<StateQuantity>& quantities, int density)
{
  int count = 0;
  for (const StateQuantity& quantity : quantities)
  {
    this->Starts.push_back(count);
    count += quantity.Components;
  }
  this->DensityColumn = density < 0 ? -1 : this->Starts[density];
  this->Constant.assign(count, 0);
  std::vector<int> depths;
  for (const StateQuantity& quantity : quantities)
  {
    const bool isPerMass = quantity.Kind == StateKind::PerMass;
    const int base = !isPerMass ? -1
      : quantity.Weight < 0     ? this->DensityColumn
                                : this->Starts[quantity.Weight];
    this->Bases.insert(this->Bases.end(), quantity.Components, base);
    this->Extensive.insert(
      this->Extensive.end(), quantity.Components, quantity.Kind == StateKind::Extensive);
    this->AnyExtensive = this->AnyExtensive || quantity.Kind == StateKind::Extensive;
    depths.insert(depths.end(), quantity.Components, !isPerMass ? 0 : quantity.Weight < 0 ? 1 : 2);
    if (isPerMass && quantity.Weight >= 0)
    {
      this->Constant[base] = 1;
    }
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
    const double share = base < 0
      ? ShareOf(otherVolume, volume, otherVolume, volume)
      : ShareOf(theirs[base], mine[base], otherVolume, volume);
    values[c] += share * (others[c] - values[c]);
  }
  volume += otherVolume;
}

} // namespace vfm
