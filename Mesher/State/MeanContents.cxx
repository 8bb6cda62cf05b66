#include "State/MeanContents.h"

namespace vfm
{
namespace
{

/// Returns the weight of each column in sums over cells.
/// @param values values of a cell; volume: volume of the material in the cell
std::vector<double> FindWeights(const InputContents& contents, const double* values, double volume)
{
  const StatePlan& plan = contents.GetPlan();
  const double mass =
    plan.Density < 0 ? volume : volume * values[contents.FirstColumn(plan.Density)];
  std::vector<double> weights(contents.NumberOfColumns(), mass); // also for |u|^2 / 2
  for (std::size_t a = 0; a < plan.Conserved.size(); ++a)
  {
    const ConservedArray& array = plan.Conserved[a];
    const double factor =
      array.Weight < 0 ? mass : mass * values[contents.FirstColumn(array.Weight)];
    std::fill_n(weights.begin() + contents.FirstColumn(a), array.Components,
      array.Meaning == StateMeaning::PerMass ? factor : volume);
  }
  return weights;
}

} // namespace

void ContentSums::Add(
  const InputContents& contents, int material, double volume, const double* values)
{
  const std::size_t columns = contents.NumberOfColumns();
  auto at = std::find_if(this->Items.begin(), this->Items.end(),
    [material](const Item& item) { return item.Material == material; });
  if (at == this->Items.end())
  {
    const std::vector<double> zeros(columns, 0.0);
    at = this->Items.insert(at, { material, 0.0, zeros, zeros, zeros });
  }
  const std::vector<double> weights = FindWeights(contents, values, volume);
  at->Volume += volume;
  for (std::size_t c = 0; c < columns; ++c)
  {
    at->Weights[c] += weights[c];
    at->Weighted[c] += weights[c] * values[c];
    at->Plain[c] += volume * values[c];
  }
}

int MeanContents::Store(const ContentSums& sums)
{
  for (const ContentSums::Item& own : sums.Items)
  {
    this->Parts.push_back({ own.Material, this->Values.size() });
    for (std::size_t c = 0; c < own.Weights.size(); ++c)
    {
      this->Values.push_back(
        own.Weights[c] > 0.0 ? own.Weighted[c] / own.Weights[c] : own.Plain[c] / own.Volume);
    }
  }
  this->Offsets.push_back(this->Parts.size());
  return static_cast<int>(this->Offsets.size()) - 2;
}

void MeanContents::Read(int number, int material, int columns, double* values) const
{
  for (std::size_t p = this->Offsets[number]; p < this->Offsets[number + 1]; ++p)
  {
    if (this->Parts[p].Material == material)
    {
      std::copy_n(this->Values.data() + this->Parts[p].First, columns, values);
      return;
    }
  }
  std::fill_n(values, columns, 0.0);
}

} // namespace vfm
