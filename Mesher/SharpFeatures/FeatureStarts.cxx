#include "SharpFeatures/FeatureStarts.h"

#include "SharpFeatures/CellLanes.h"

#include <algorithm>

namespace vfm
{
namespace
{

using Shares = std::vector<std::array<double, 4>>;

VFM_CLONES
void SetShares(const LocalQuadric& surface, const PackedCells& cells, Shares& shares)
{
  SurfaceLanes at;
  auto share = shares.begin();
  for (const FourCells& packed : cells)
  {
    SetInside(at, surface, Load(packed));
    *share++ = { { at.Inside[0], at.Inside[1], at.Inside[2], at.Inside[3] } };
  }
}

/// Returns the rough residual of a model; shares: inside each surface of the model.
VFM_CLONES
double RoughResidualOf(const FeatureModel& model,
  const std::array<const Shares*, FeatureModel::MaximumSurfaces>& shares, const PackedCells& cells)
{
  const Composition& composition = CompositionOf(model.Count, model.Composition);
  ResidualSums sums{};
  std::size_t at = 0;
  for (const FourCells& four : cells)
  {
    Lanes fraction{};
    for (const CompositionTerm& term : composition)
    {
      Lanes product = Fill<double>(term.Sign);
      for (int k = 0; k < model.Count; ++k)
      {
        if (term.Mask >> k & 1)
        {
          const Lanes inside = Load((*shares[k])[at]);
          product *= term.Flipped >> k & 1 ? 1.0 - inside : inside;
        }
      }
      fraction += product;
    }
    AddErrors(sums, fraction, Load(four.Fraction), Load(four.Weight));
    ++at;
  }
  return RootMeanSquare(sums);
}

} // namespace

FeatureStarts::FeatureStarts(const std::vector<LocalQuadric>& seeds, const PackedCells& cells) :
  Seeds(seeds), Cells(cells), Inside(seeds.size(), Shares(cells.Count()))
{
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    SetShares(seeds[s], cells, this->Inside[s]);
  }
}

std::vector<FeatureStart> FeatureStarts::Best(int count, std::size_t most) const
{
  std::vector<FeatureStart> starts;
  for (int set = 0; set < 1 << this->Seeds.size(); ++set)
  {
    FeatureModel model;
    std::array<const Shares*, FeatureModel::MaximumSurfaces> shares{};
    for (std::size_t s = 0; s < this->Seeds.size(); ++s)
    {
      if (set >> s & 1 && ++model.Count <= count)
      {
        shares[model.Count - 1] = &this->Inside[s];
        model.Surfaces[model.Count - 1] = this->Seeds[s];
      }
    }
    for (int c = 0; model.Count == count && c < NumberOfCompositions(count); ++c)
    {
      model.Composition = c;
      starts.push_back({ RoughResidualOf(model, shares, this->Cells), model });
    }
  }
  std::stable_sort(starts.begin(), starts.end(),
    [](const FeatureStart& a, const FeatureStart& b) { return a.Residual < b.Residual; });
  starts.resize(std::min(most, starts.size()));
  return starts;
}

} // namespace vfm
