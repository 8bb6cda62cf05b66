#include "SharpFeatures/FeatureModel.h"

#include "SharpFeatures/CellLanes.h"

namespace vfm
{
namespace
{

BoxPlane Flipped(const BoxPlane& plane)
{
  return { { { -plane.Normal[0], -plane.Normal[1], -plane.Normal[2] } }, -plane.Height };
}

/// Volume of a term; adds what each plane does to it.
double VolumeOf(const CompositionTerm& term, std::array<BoxPlane, 3> planes, int in, int out,
  std::array<PlaneRates, 3>& rates)
{
  const int inside = (in & ~term.Flipped) | (out & term.Flipped);
  const int outside = (out & ~term.Flipped) | (in & term.Flipped);
  if (term.Mask & outside)
  {
    return 0.0;
  }
  const int mask = term.Mask & ~inside;
  if (mask == 0)
  {
    return term.Sign;
  }
  for (int k = 0; k < 3; ++k)
  {
    planes[k] = mask & term.Flipped & 1 << k ? Flipped(planes[k]) : planes[k];
  }
  std::array<PlaneRates, 3> parts;
  const bool isSingle = (mask & (mask - 1)) == 0;
  const double volume =
    isSingle ? CutBox(planes[mask >> 1], parts[mask >> 1]) : CutBox(planes, mask, parts);
  for (int k = 0; k < 3; ++k)
  {
    if (mask >> k & 1)
    {
      const double sign = term.Flipped >> k & 1 ? -term.Sign : term.Sign;
      rates[k].ByHeight += sign * parts[k].ByHeight;
      rates[k].ByNormal = rates[k].ByNormal + sign * parts[k].ByNormal;
    }
  }
  return term.Sign * volume;
}

} // namespace

double FractionUnder(const Composition& composition, const std::array<BoxPlane, 3>& planes, int in,
  int out, std::array<PlaneRates, 3>& rates)
{
  double fraction = 0.0;
  for (const CompositionTerm& term : composition)
  {
    fraction += term.Sign != 0 ? VolumeOf(term, planes, in, out, rates) : 0.0;
  }
  return fraction;
}

int NumberOfCompositions(int surfaces)
{
  return surfaces == 1
    ? 1
    : static_cast<int>(surfaces == 2 ? CompositionsOfTwo.size() : CompositionsOfThree.size());
}

bool IsInside(const FeatureModel& model, int bits)
{
  int sum = 0;
  for (const CompositionTerm& term : CompositionOf(model.Count, model.Composition))
  {
    sum += ((bits ^ term.Flipped) & term.Mask) == term.Mask ? term.Sign : 0;
  }
  return sum != 0;
}

double FractionIn(const FeatureModel& model, const SampleCell& cell)
{
  std::array<double, 6 * FeatureModel::MaximumSurfaces> derivatives;
  return FractionIn(model, cell, derivatives.data());
}

VFM_CLONES
double FractionIn(const FeatureModel& model, const SampleCell& cell, double* derivatives)
{
  const PackedCells cells(std::vector<SampleCell>{ cell });
  ModelLanes at;
  const CellLanes four = Load(*cells.begin());
  SetFractions(at, model, four, SharedCells::Exact);
  for (int k = 0; k < model.Count; ++k)
  {
    const auto lanes = DerivativesBy(at.Surfaces[k], model.Surfaces[k], four.Width);
    for (int i = 0; i < 6; ++i)
    {
      derivatives[6 * k + i] = lanes[i][0];
    }
  }
  return at.Fraction[0];
}

} // namespace vfm
